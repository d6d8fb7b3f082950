// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/eval_clock.h"

#include <iostream>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/text/number.h"
#include "experiments/cli/command.h"
#include "experiments/metrics/clock_offset.h"
#include "experiments/runner/system_files.h"

namespace cvo {
namespace {

Trajectory ReadTimed(const std::string& path) {
  if (DetectPoseFormat(path) != "tum") {
    ThrowError(path, "a trajectory in kitti format", "tum: clocks are compared by times");
  }
  return ReadTumTrajectory(path);
}

Trajectory AtFrames(const OptionalPoses& poses, const Sequence& sequence) {
  Trajectory trajectory;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (poses[i]) trajectory.push_back({sequence.timestamps_ns[i], *poses[i]});
  }
  return trajectory;
}

int Print(const ClockOffset& clock, bool json) {
  if (json) {
    std::cout << DumpJson(
        {{"schema_version", 1}, {"kind", "clock offset"}, {"clock", ToJson(clock)}});
    return 0;
  }
  std::cout << "clock offset (ground truth minus estimate): " << (clock.offset_s > 0.0 ? "+" : "")
            << FormatFixed(clock.offset_s, 5) << " s, standard deviation "
            << FormatFixed(clock.deviation_s, 5) << " s\n"
            << "rotation rates of " << clock.pairs
            << " pairs of consecutive poses: " << FormatFixed(100.0 * clock.explained, 1)
            << " % explained, residual " << FormatFixed(clock.residual_rad_per_s, 5) << " rad/s\n";
  return 0;
}

}  // namespace

void EvalClock::AddTo(CLI::App& app) {
  app.add_option("--clock-offset", most_s,
                 "instead of scoring, estimate from rotation rates how far the ground-truth clock "
                 "is ahead of the estimate's; search range: -SECONDS to SECONDS (0.01 to 10)")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.01, kMostClockOffset_s).description(""))
      ->check(FiniteProblem);
}

int EvaluateClock(const EvalClock& eval, const std::string& groundtruth,
                  const std::string& estimate, bool json) {
  return Print(EstimateClockOffset(ReadTimed(groundtruth), ReadTimed(estimate), *eval.most_s),
               json);
}

int EvaluateClock(const EvalClock& eval, const SequenceRequest& request,
                  const std::string& estimate, bool json) {
  const Sequence sequence = OpenSequence(request);
  const Trajectory truth = sequence.truth_track.empty()
                               ? AtFrames(sequence.groundtruth_world_from_camera, sequence)
                               : sequence.truth_track;
  if (truth.empty()) ThrowError(sequence.folder.string(), "no ground truth of the camera", "one");
  const SystemEstimate system = ReadSystem(sequence, {"", estimate, ""});
  return Print(EstimateClockOffset(truth, AtFrames(system.objects.world_from_camera, sequence),
                                   *eval.most_s),
               json);
}

}  // namespace cvo
