// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "experiments/cli/command.h"
#include "experiments/cli/run/text_table.h"
#include "experiments/suite/collection.h"
#include "experiments/suite/parse_suite.h"
#include "experiments/suite/plan/plan.h"
#include "experiments/suite/shipped/shipped_suites.h"
#include "experiments/suite/suite_grid.h"

namespace cvo {
namespace {

int List() {
  TextTable table({"suite", "split", "sequences", "variants", "points", "seeds", "jobs", "about"});
  for (const ShippedSuite& shipped : ShippedSuites()) {
    // Skips the checks of suites, which would build every scene.
    const Suite suite = ReadCheckedSuite(ParseJson(shipped.text, shipped.name), shipped.name);
    const std::size_t points =
        GridPoints(suite, suite.sequences.front(), suite.variants.front()).size() *
        suite.oracles.size();
    table.Add({suite.name, SplitOf(suite), std::to_string(suite.sequences.size()),
               std::to_string(suite.variants.size()), std::to_string(points),
               std::to_string(suite.seeds.size()), std::to_string(ExpandSuite(suite).size()),
               suite.about});
  }
  for (const std::string& name : CollectionNames()) {
    table.Add({name, "", "", "", "", "", "", FindCollection(name)->about});
  }
  table.Print(std::cout);
  return 0;
}

}  // namespace

Command AddExperimentListCommand(CLI::App& experiment) {
  return {experiment.add_subcommand("list", "List the shipped suites"), List};
}

}  // namespace cvo
