// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "core/base/lists.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_place.h"
#include "experiments/cli/run/text_table.h"
#include "reports/runs/suite_times.h"

namespace cvo {
namespace {

int ShowTimes(const std::string& folder) {
  CheckNoCollection(folder);
  const reports::SuiteTimes times = reports::ReadSuiteTimes(folder);
  const std::vector<std::vector<std::string>> rows = reports::TimesTable(times);
  TextTable table(rows.front());
  for (std::size_t i = 1; i < rows.size(); ++i) table.Add(rows[i]);
  table.Print(std::cout);
  std::cout << "machine: " << Joined(times.machines, "; ") << '\n';
  return 0;
}

}  // namespace

Command AddExperimentTimesCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "times", "Print frames per second and the time of each stage of a suite's runs");
  const auto folder = std::make_shared<std::string>();
  app->add_option("DIR", *folder, "output folder of the suite")->type_name("")->required();
  app->footer(
      "Medians over the runs of a row; stages are means over frames. Times are comparable only if "
      "every\nrun had the machine to itself, as in a suite with timed_threads, which runs one job "
      "at a time\nwithout cached features.\nExample: clustervo experiment times results/timing");
  return {app, [folder] { return ShowTimes(*folder); }};
}

}  // namespace cvo
