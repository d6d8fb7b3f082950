// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <iostream>
#include <memory>

#include "experiments/cli/experiment_command.h"
#include "reports/tables/make_table.h"
#include "reports/tables/moved.h"
#include "reports/tables/table_text.h"

namespace cvo {
namespace {

int Compare(const std::string& before, const std::string& after) {
  const reports::Table table = reports::CompareFolders(before, after);
  std::cout << reports::TableText(table, isatty(STDOUT_FILENO) != 0) << '\n'
            << reports::MovedText(table);
  return 0;
}

}  // namespace

Command AddExperimentCompareCommand(CLI::App& experiment) {
  struct Folders {
    std::string before;
    std::string after;
  };
  CLI::App* app = experiment.add_subcommand(
      "compare", "Compare the results of two folders run by run, and say what moved");
  const auto folders = std::make_shared<Folders>();
  app->add_option("A", folders->before, "folder of a suite, as it was")->type_name("")->required();
  app->add_option("B", folders->after, "folder of a suite, as it is")->type_name("")->required();
  app->footer(
      "Rows, scenes, seeds and bodies are paired; differences are B - A. Results that mean "
      "different\n"
      "things by the same metric are refused.\n"
      "Example: clustervo experiment compare results/before results/after");
  return {app, [folders] { return Compare(folders->before, folders->after); }};
}

}  // namespace cvo
