// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <exception>
#include <functional>

#include "core/base/error.h"
#include "reports/figures/suite/suite_figures.h"
#include "reports/page/choose_scenes.h"
#include "reports/page/page_content.h"
#include "reports/page/run_origin.h"
#include "reports/tables/make_table.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

// Runs a step. If it fails, the page is made without it and says so.
void Try(const std::string& what, const std::function<void()>& step, PageContent& content) {
  try {
    step();
  } catch (const std::exception& error) {
    content.problems.push_back(StrCat(what, ": ", error.what()));
  }
}

PageRun DescribeRun(SuiteRun run, const PageRequest& request, OptionDefaults& defaults) {
  PageRun described;
  if (run.run) {
    described.result = StrCat("jobs/", run.planned.job, "/result.json");
    described.origin = ReadRunOrigin(request.folder / "jobs" / run.planned.job);
    described.options = defaults.ChangedIn(run.run->options);
  }
  described.run = std::move(run);
  return described;
}

void ReadSuite(const PageRequest& request, PageContent& content) {
  const SuitePlan plan = ReadPlan(request.folder / "plan.json");
  content.title = plan.name;
  content.about = plan.about;
  for (const Fact& variant : request.variants) {
    const auto is_of_it = [&](const PlannedRun& run) {
      return KeyOf(run, "variant") == variant.first;
    };
    if (std::any_of(plan.runs.begin(), plan.runs.end(), is_of_it)) {
      content.variants.push_back(variant);
    }
  }
  OptionDefaults defaults(request.default_options);
  for (SuiteRun& run : ReadRuns(request.folder, plan, {})) {
    content.runs.push_back(DescribeRun(std::move(run), request, defaults));
  }
}

void ReadScenes(const PageRequest& request, PageContent& content) {
  const SceneChoice choice = ChooseScenes(
      content.runs, content.table ? content.table->reference : "", request.most_scenes);
  content.scenes_left_out = choice.left_out;
  for (const auto& [run, wants_images] : choice.scenes) {
    PageScene scene;
    scene.run = run;
    scene.wants_images = wants_images || request.images_of_all;
    const fs::path folder = request.folder / "jobs" / content.runs[run].run.planned.job;
    try {
      scene.detail = ReadRunDetail(folder);
      content.scenes.push_back(std::move(scene));
    } catch (const std::exception& error) {
      content.runs[run].origin.missing.push_back(StrCat("frame by frame: ", error.what()));
    }
  }
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
void ForgetFolder(const std::string& folder, std::string& text) {
  for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder)) {
    text.erase(at, folder.size());
  }
}

void ForgetFolder(const std::string& folder, std::vector<std::string>& texts) {
  for (std::string& text : texts) ForgetFolder(folder, text);
}

void ForgetFolder(const std::string& folder, PageContent& content) {
  ForgetFolder(folder, content.problems);
  for (PageRun& run : content.runs) {
    ForgetFolder(folder, run.origin.missing);
    ForgetFolder(folder, run.run.message);
  }
  ForgetFolder(folder, content.drawing.not_drawn);
  for (PageScene& scene : content.scenes) ForgetFolder(folder, scene.detail.missing);
  if (!content.table) return;
  for (Problem& problem : content.table->problems) ForgetFolder(folder, problem.message);
}

}  // namespace

PageContent ReadPage(const PageRequest& request) {
  const fs::path plan = request.folder / "plan.json";
  if (!fs::exists(plan)) {
    ThrowError(plan.string(), "no such file", "the folder that a suite was run to");
  }
  PageContent content;
  content.title = request.folder.filename().string();
  Try(
      "suite", [&] { ReadSuite(request, content); }, content);
  Try(
      "table",
      [&] {
        content.table = MakeTable(request.folder, ShippedReference(), request.default_options);
      },
      content);
  if (content.table) {
    Try(
        "figures",
        [&] { content.drawing = SuiteFigures(ReadSuiteData(request.folder, *content.table)); },
        content);
  }
  if (!request.against.empty()) {
    content.compared_with = request.against.filename().string();
    Try(
        "comparison", [&] { content.comparison = Compare(request); }, content);
  }
  ReadScenes(request, content);
  ForgetFolder((request.folder / "").string(), content);
  return content;
}

}  // namespace cvo::reports
