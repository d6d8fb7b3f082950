// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <exception>
#include <functional>
#include <map>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "reports/page/page.h"
#include "reports/tables/cells.h"
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

// Adds a fact, or one fact per member of an object.
void AddFact(std::string name, const Json& value, std::vector<Fact>& facts) {
  if (value.is_object()) {
    for (const auto& [part, of_part] : value.items()) AddFact(part, of_part, facts);
    return;
  }
  std::replace(name.begin(), name.end(), '_', ' ');
  facts.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
}

// What produced a result: the program (result.json) and the machine (timing.json).
void ReadOrigin(const fs::path& run_folder, PageRun& run) {
  Try("", run.missing, [&] {
    const Json json =
        ReadJson(run_folder / "result.json", {"bodies", "clusters", "frames", "metrics"});
    if (json.contains("build")) AddFact("build", json["build"], run.build);
  });
  Try("", run.missing, [&] {
    const Json json = ReadJson(run_folder / "timing.json", {"frames"});
    for (const char* name : {"host", "cpu", "cpus", "threads"}) {
      if (json.contains(name)) AddFact(name, json[name], run.machine);
    }
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
  for (SuiteRun& run : ReadRuns(request.folder, plan, {})) {
    PageRun& described = content.runs.emplace_back();
    if (run.run) ReadOrigin(request.folder / "jobs" / run.planned.job, described);
    described.run = std::move(run);
  }
}

void ReadScenes(const PageRequest& request, PageContent& content) {
  ChooseScenes(kMostScenes, content);
  std::erase_if(content.scenes, [&](PageScene& scene) {
    scene.wants_images = scene.wants_images || request.images_of_all;
    PageRun& run = content.runs[scene.run];
    const std::size_t missing = run.missing.size();
    Try("frame by frame: ", run.missing,
        [&] { scene.detail = ReadRunDetail(request.folder / "jobs" / run.run.planned.job); });
    return run.missing.size() > missing;
  });
}

// Compares the two folders. The texts name them without their paths.
Table Compare(const PageRequest& request) {
  Table table = CompareFolders(request.against, request.folder);
  table.reference = request.against.filename().string();
  table.title = StrCat(request.folder.filename().string(), " against ", table.reference);
  for (Row& row : table.rows) {
    for (Cell& cell : row.cells) {
      if (cell.difference) cell.difference->reference = table.reference;
    }
  }
  return table;
}

// Removes the path of the folder from messages that name files, since it is private and differs
// between machines.
void ForgetFolder(const std::string& folder, PageContent& content) {
  const auto forget = [&folder](std::string& text) {
    for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder)) {
      text.erase(at, folder.size());
    }
  };
  std::for_each(content.problems.begin(), content.problems.end(), forget);
  std::for_each(content.drawing.not_drawn.begin(), content.drawing.not_drawn.end(), forget);
  for (PageRun& run : content.runs) {
    std::for_each(run.missing.begin(), run.missing.end(), forget);
    forget(run.run.message);
  }
  for (PageScene& scene : content.scenes) {
    std::for_each(scene.detail.missing.begin(), scene.detail.missing.end(), forget);
  }
  if (!content.table) return;
  for (Problem& problem : content.table->problems) forget(problem.message);
}

std::vector<std::size_t> FirstSeeds(const std::vector<PageRun>& runs) {
  // By everything that identifies a run, except the seed.
  std::map<std::map<std::string, std::string>, std::size_t> first;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SuiteRun& run = runs[i].run;
    if (!run.run || !run.planned.system.empty()) continue;
    const auto [entry, added] = first.try_emplace(run.planned.keys, i);
    if (!added && run.planned.seed < runs[entry->second].run.planned.seed) entry->second = i;
  }
  std::vector<std::size_t> chosen;
  for (const auto& [keys, run] : first) chosen.push_back(run);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

// The priority of showing the images of a run; lower comes first.
int Rank(const PageRun& run, const std::string& reference) {
  const std::string variant = KeyOf(run.run.planned, "variant");
  if (variant == "full") return 0;
  return variant == reference || "variant=" + variant == reference ? 1 : 2;
}

// The share of frames of moving bodies that the run estimates within 10 cm; 1 if it has no moving
// body.
double SuccessOf(const PageRun& run) {
  const BodyMetric success = *FindBodyMetric("object_success_10cm");
  Part total = {0.0, 0.0};
  if (!run.run.run->bodies) return 1.0;
  for (const BodyRow& body : run.run.run->bodies->refined) {
    const std::optional<Part> part = PartOf(success, body);
    if (!part) continue;
    total.sum += part->sum;
    total.weight += part->weight;
  }
  return total.weight > 0.0 ? total.sum / total.weight : 1.0;
}

}  // namespace

void ChooseScenes(std::size_t most, PageContent& content) {
  const std::vector<PageRun>& runs = content.runs;
  const std::string reference = content.table ? content.table->reference : "";
  std::vector<std::size_t> candidates = FirstSeeds(runs);
  if (candidates.size() > most) {
    std::stable_sort(candidates.begin(), candidates.end(), [&](std::size_t a, std::size_t b) {
      return SuccessOf(runs[a]) < SuccessOf(runs[b]);
    });
  }
  std::map<std::string, std::size_t> with_images;  // by sequence
  for (const std::size_t i : candidates) {
    const auto [entry, added] = with_images.try_emplace(KeyOf(runs[i].run.planned, "sequence"), i);
    if (!added && Rank(runs[i], reference) < Rank(runs[entry->second], reference)) {
      entry->second = i;
    }
  }
  for (const std::size_t i : candidates) {
    content.scenes.push_back({i, with_images[KeyOf(runs[i].run.planned, "sequence")] == i});
  }
  std::stable_partition(content.scenes.begin(), content.scenes.end(),
                        [](const PageScene& scene) { return scene.wants_images; });
  content.scenes.resize(std::min(most, candidates.size()));
  content.scenes_left_out = candidates.size() - content.scenes.size();
}

PageContent ReadPage(const PageRequest& request) {
  const fs::path plan = request.folder / "plan.json";
  if (!fs::exists(plan)) {
    ThrowError(plan.string(), "no such file", "the folder that a suite was run to");
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
  if (!request.against.empty()) {
    content.compared_with = request.against.filename().string();
    Try("comparison: ", content.problems, [&] { content.comparison = Compare(request); });
  }
  ReadScenes(request, content);
  ForgetFolder((request.folder / "").string(), content);
  return content;
}

}  // namespace cvo::reports
