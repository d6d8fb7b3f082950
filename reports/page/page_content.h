// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/figures/figure.h"
#include "reports/page/run_origin.h"
#include "reports/results/suite_runs.h"
#include "reports/runs/run_detail.h"
#include "reports/tables/table.h"

namespace cvo::reports {

// A job of the suite and what made its result.
struct PageRun {
  SuiteRun run;
  std::string result;  // relative to the suite's folder; empty where there is none
  RunOrigin origin;
  std::vector<ChangedOption> options;  // that are not at their default
};

struct PageImage {
  int frame = 0;  // counted in the folder of the sequence
  std::string jpeg;
  std::string alt;  // what it shows
};

// A run that can be looked at frame by frame.
struct PageScene {
  std::size_t run = 0;  // index in PageContent::runs
  bool wants_images = false;
  RunDetail detail;
  std::vector<PageImage> images;
  std::string no_images;      // why there are none
  std::string images_folder;  // of all its frames, beside the page; empty: none
};

// All that a page shows. A part that could not be made is empty, and `problems` says why.
struct PageContent {
  std::string title;
  std::string about;
  std::optional<Table> table;
  std::optional<Table> comparison;
  std::string compared_with;   // name of the other folder
  std::vector<PageRun> runs;   // in the order of the plan
  std::vector<Fact> variants;  // of the suite: what each is
  SuiteDrawing drawing;
  std::vector<PageScene> scenes;
  std::size_t scenes_left_out = 0;
  std::vector<std::string> problems;
};

struct PageRequest {
  std::filesystem::path folder;   // that a suite was run to
  std::filesystem::path against;  // another one; empty: none
  std::string default_options;    // nested JSON; empty where not known
  std::vector<Fact> variants;     // that there are, and what each is
  std::size_t most_scenes = 24;
  bool images_of_all = false;  // not of one run per sequence alone
};

// Reads whatever of the folder can be read. Throws Error only where it holds no plan.json.
PageContent ReadPage(const PageRequest& request);

}  // namespace cvo::reports
