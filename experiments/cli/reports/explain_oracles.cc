// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <iostream>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/base/mean.h"
#include "core/files/json/json_record.h"
#include "core/files/json/options_json.h"
#include "experiments/cli/progress.h"
#include "experiments/cli/reports/explain.h"
#include "experiments/cli/scratch_folder.h"
#include "experiments/cli/stop_signal.h"
#include "experiments/runner/run_job.h"
#include "reports/results/run_summary.h"

namespace cvo {
namespace {

constexpr std::array<const char*, 3> kOracles = {"boxes", "labels", "camera"};

Options OptionsOf(const reports::RunSummary& run, const VariantInfo& variant) {
  Options options = variant.defaults();
  MergeOptions(run.options, run.file.string() + ", options", OptionLeaves(options));
  return options;
}

// The switch `name`, in addition to those that the run already had.
OracleSwitches With(const char* name, const reports::RunSummary& run) {
  OracleSwitches switches = ParseOracle(name);
  for (const Json& given : run.given.value("oracle", Json::array())) {
    const OracleSwitches more = ParseOracle(given.get<std::string>());
    switches.boxes = switches.boxes || more.boxes;
    switches.labels = switches.labels || more.labels;
    switches.camera = switches.camera || more.camera;
  }
  return switches;
}

}  // namespace

OracleResult ResultOf(const std::string& oracle, const reports::BodyDetail& body) {
  OracleResult result;
  result.oracle = oracle;
  result.judged = static_cast<int>(body.visible.size());
  result.estimated = static_cast<int>(body.estimated.size());
  for (const reports::BodyPosition& position : body.estimated) {
    result.good += position.error_m <= reports::kGoodError_m ? 1 : 0;
  }
  // The ATE of a single pose is zero by alignment.
  if (body.estimated.size() > 1) {
    result.ate_m = RootMeanSquare(body.estimated, &reports::BodyPosition::error_m);
  }
  return result;
}

std::optional<std::vector<OracleResult>> TryOracles(const std::string& run_folder,
                                                    const Sequence& sequence, int body, int threads,
                                                    bool quiet) {
  const reports::RunSummary run =
      reports::ReadRun(std::filesystem::path(run_folder) / "result.json", {});
  if (run.system) ThrowError(run_folder, "a run of another system", "one of clustervo run");
  if (run.sequence.perturbation) {
    ThrowError(run_folder, "a run with a perturbation", "one that --oracles can repeat, without");
  }
  const VariantInfo& variant = FindVariant(run.variant);
  std::vector<OracleResult> results;
  const StopSignal stop;
  for (const char* name : kOracles) {
    RunRequest request = {.sequence = sequence,
                          .variant = variant,
                          .options = OptionsOf(run, variant),
                          .seed = run.seed,
                          .threads = threads,
                          .oracle = With(name, run),
                          .stop = [&stop] { return stop.Requested(); }};
    if (run.given.contains("classes")) {
      request.classes = FromJson<std::vector<std::string>>(run.given["classes"], run_folder);
    }
    if (!quiet) std::cerr << "clustervo: with true " << name << '\n';
    Progress progress(sequence.images.size(), quiet);
    request.progress = [&progress](std::size_t done) { progress.Report(done); };
    const ScratchFolder folder;
    const std::optional<JobOutcome> outcome = RunJob(request, folder.path());
    if (!outcome) return std::nullopt;
    if (outcome->run.status == RunStatus::kFailed) throw Error(outcome->run.message);
    const reports::RunDetail detail = reports::ReadRunDetail(folder.path());
    const auto* judged = FindBy(detail.bodies, &reports::BodyDetail::id, body);
    Require(judged != nullptr, "TryOracles: the body has truth");
    results.push_back(ResultOf(StrCat("true ", name), *judged));
  }
  return results;
}

}  // namespace cvo
