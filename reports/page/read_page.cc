// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <exception>
#include <functional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json.h"
#include "reports/page/page.h"
#include "reports/tables/make_table.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostScenes = 24;

// Runs a step. If it fails, the page is made without it and says so.
void Try(const std::string& what, std::vector<std::string>& problems,
         const std::function<void()>& step) {
  try {
    step();
  } catch (const std::exception& error) {
    problems.push_back(StrCat(what, error.what()));
  }
}

// Names and values that are known, on one line.
std::string FactsText(const Json& json) {
  std::string text;
  for (const auto& [name, value] : FlatJson(json)) {
    if (value != "\"\"") text += StrCat(text.empty() ? "" : ", ", name, " ", value);
  }
  std::erase(text, '"');
  return text;
}

// What produced a result: the program and the machine.
void ReadOrigin(const fs::path& run_folder, const RunSummary& run, PageContent& content) {
  AddOnce("program: " + FactsText(ToJson(run.build)), content.origins);
  Try("", content.missing, [&] {
    const Json timing = ReadJson(run_folder / "timing.json", {"frames"});
    Json machine = Json::object();
    for (const char* name : {"host", "cpu", "cpus", "threads"}) {
      if (timing.contains(name)) machine[name] = timing[name];
    }
    AddOnce("machine: " + FactsText(machine), content.origins);
  });
}

void ReadSuite(const PageRequest& request, PageContent& content) {
  const SuitePlan plan = ReadPlan(request.folder / "plan.json");
  content.title = plan.name;
  content.about = plan.about;
  for (const Fact& variant : request.variants) {
    if (std::any_of(plan.runs.begin(), plan.runs.end(), [&](const PlannedRun& run) {
          return KeyOf(run, "variant") == variant.first;
        })) {
      content.variants.push_back(variant);
    }
  }
  content.runs = ReadRuns(request.folder, plan, {});
  for (const SuiteRun& run : content.runs) {
    if (run.run) ReadOrigin(request.folder / "jobs" / run.planned.job, *run.run, content);
  }
}

// Removes the path of the folder from messages that name files, since it is private and differs
// between machines.
void ForgetFolder(const std::string& folder, PageContent& content) {
  const auto forget = [&folder](std::string& text) {
    for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder)) {
      text.erase(at, folder.size());
    }
  };
  for (auto* texts : {&content.problems, &content.drawing.not_drawn, &content.missing}) {
    std::for_each(texts->begin(), texts->end(), forget);
  }
  if (!content.table) return;
  for (Problem& problem : content.table->problems) forget(problem.message);
}

// The priority of showing the images of a run; lower comes first.
std::pair<int, std::uint64_t> Rank(const PlannedRun& run, const std::string& reference) {
  const std::string variant = KeyOf(run, "variant");
  const bool is_reference = variant == reference || "variant=" + variant == reference;
  return {variant == "full" ? 0 : is_reference ? 1 : 2, run.seed};
}

}  // namespace

void ChooseScenes(PageContent& content) {
  const std::string reference = content.table ? content.table->reference : "";
  const auto sequence = [&](const PageScene& scene) {
    return KeyOf(content.runs[scene.run].planned, "sequence");
  };
  for (std::size_t i = 0; i < content.runs.size(); ++i) {
    const SuiteRun& run = content.runs[i];
    if (!run.run || !run.planned.system.empty()) continue;
    PageScene& scene = FindOrAdd(content.scenes, sequence, {i});
    const PlannedRun& chosen = content.runs[scene.run].planned;
    if (Rank(run.planned, reference) < Rank(chosen, reference)) scene.run = i;
  }
  content.scenes.resize(std::min(content.scenes.size(), kMostScenes));
}

PageContent ReadPage(const PageRequest& request) {
  const fs::path plan = request.folder / "plan.json";
  if (!fs::exists(plan)) {
    ThrowError(plan.string(), "no such file",
               "the folder that a suite was run to (of a run: clustervo plot, clustervo overlay)");
  }
  PageContent content;
  content.title = request.folder.filename().string();
  Try("suite: ", content.problems, [&] { ReadSuite(request, content); });
  Try("table: ", content.problems, [&] {
    content.table = MakeTable(request.folder, ShippedReference(), request.default_options);
  });
  if (content.table) {
    Try("figures: ", content.problems,
        [&] { content.drawing = MakeSuiteFigures(ReadSuiteData(request.folder, *content.table)); });
  }
  ChooseScenes(content);
  ForgetFolder((request.folder / "").string(), content);
  return content;
}

}  // namespace cvo::reports
