// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "core/files/json/json.h"
#include "experiments/cli/command.h"
#include "experiments/jobs/planned_job.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

int RunOne(const SuiteFolder& folder, const std::string& id) {
  FileHashHooks hooks;
  hooks.notice = [](const std::string& line) { std::cerr << "clustervo: " << line << '\n'; };
  const JobCache cache(synth::CacheFolder(), CacheLimit(""), hooks);
  RunPlannedJob(ParsePlan(ReadJson(folder.plan()), folder.plan().string()), id, folder, cache);
  return 0;
}

}  // namespace

Command AddExperimentJobCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "job", "Run one job of a suite folder; experiment run starts this for each job");
  const auto folder = std::make_shared<std::string>();
  const auto id = std::make_shared<std::string>();
  app->add_option("DIR", *folder, "the suite's folder")->type_name("")->required();
  app->add_option("ID", *id, "id of the job in DIR/plan.json")->type_name("")->required();
  return {app, [folder, id] { return RunOne({*folder}, *id); }};
}

}  // namespace cvo
