// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>

#include <iostream>
#include <memory>
#include <new>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/files/json.h"
#include "experiments/cli/suite/experiment_command.h"
#include "experiments/jobs/planned_job.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

void RunOne(const SuiteFolder& folder, const std::string& id) {
  FileHashHooks hooks;
  hooks.notice = [](const std::string& line) { std::cerr << "clustervo: " << line << '\n'; };
  const JobCache cache(synth::CacheFolder(), CacheLimit(""), hooks);
  RunPlannedJob(ParsePlan(ReadJson(folder.plan()), folder.plan().string()), id, folder, cache);
}

std::string OutOfMemory() {
  rlimit limit{};
  const bool limited = ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  if (!limited) return "out of memory";
  return StrCat("out of memory: memory limit of ", static_cast<double>(limit.rlim_cur) / 1e6,
                " MB");
}

// Memory runs out where a limit was set for the job: its failure, and no error of the program.
int RunWithinMemory(const SuiteFolder& folder, const std::string& id) {
  try {
    RunOne(folder, id);
    return 0;
  } catch (const std::bad_alloc&) {
    throw Error(OutOfMemory());
  } catch (const cv::Exception& error) {
    if (error.code != cv::Error::StsNoMem) throw;
    throw Error(OutOfMemory());
  }
}

}  // namespace

Command AddExperimentJobCommand(CLI::App& experiment) {
  CLI::App* app = experiment.add_subcommand(
      "job", "Run one job of a suite folder; experiment run starts this for each job");
  const auto folder = std::make_shared<std::string>();
  const auto id = std::make_shared<std::string>();
  app->add_option("DIR", *folder, "the suite's folder")->type_name("")->required();
  app->add_option("ID", *id, "the job's identity, as in DIR/plan.json")->type_name("")->required();
  return {app, [folder, id] { return RunWithinMemory({*folder}, *id); }};
}

}  // namespace cvo
