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

// A job of the suite, and what produced its result.
struct PageRun {
  SuiteRun run;
  std::string result;  // relative to the folder of the suite; empty: none
  RunOrigin origin;
  std::vector<ChangedOption> options;  // those that are not at their default
};

struct PageImage {
  int frame = 0;  // index within the folder of the sequence
  std::string jpeg;
  std::string alt;  // text alternative: what it shows
};

// A run that is shown frame by frame.
struct PageScene {
  std::size_t run = 0;  // index in PageContent::runs
  bool wants_images = false;
  RunDetail detail;
  std::vector<PageImage> images;
  std::string no_images;      // why there are none
  std::string images_folder;  // folder beside the page with images of all frames; empty: none
};

// Everything that a page shows. A part that could not be made is empty, and `problems` says why.
struct PageContent {
  std::string title;
  std::string about;
  std::optional<Table> table;
  std::optional<Table> comparison;
  std::string compared_with;   // name of the folder compared with
  std::vector<PageRun> runs;   // in the order of the plan
  std::vector<Fact> variants;  // variants of the suite, each with its meaning
  SuiteDrawing drawing;
  std::vector<PageScene> scenes;
  std::size_t scenes_left_out = 0;
  std::vector<std::string> problems;
};

struct PageRequest {
  std::filesystem::path folder;   // output folder of a suite
  std::filesystem::path against;  // output folder to compare with; empty: none
  std::string default_options;    // nested JSON; empty: unknown
  std::vector<Fact> variants;     // all variants, each with its meaning
  std::size_t most_scenes = 24;
  bool images_of_all = false;  // for all runs shown, not only for one per sequence
};

// Reads whatever can be read from the folder. Throws Error only if it holds no plan.json.
PageContent ReadPage(const PageRequest& request);

}  // namespace cvo::reports
