// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/suite/plan/build_plan.h"

namespace cvo {

enum class JobState {
  kDone,
  kRuns,      // its input exists
  kPrepares,  // runs after its scene is rendered or its boxes are found
  kMissing,
};

// What will happen to a planned job.
struct PredictedState {
  JobState state = JobState::kRuns;
  std::string why;  // reason that it runs or is missing, shown to the user
};

// Contents of an existing output folder.
struct EarlierRuns {
  std::optional<Plan> plan;                         // of the previous run
  std::function<bool(const PlannedJob& job)> done;  // its files exist
  std::function<std::string(const std::string& job)>
      failed;  // message of its last failure, or empty
};

// One per job of the plan. For a job that the earlier plan had under another identity, the reason
// names what differs: the build, the options, the sequence.
std::vector<PredictedState> PredictStates(const Plan& plan, const EarlierRuns& earlier);

// Seconds per frame and process, by variant ("": the mean over those measured), of timing.json of
// the finished jobs of both plans; a few files of each variant are read, unreadable ones are
// ignored.
std::map<std::string, double> MeasuredFrameTimes(
    const Plan& plan, const EarlierRuns& earlier,
    const std::function<std::filesystem::path(const std::string& job)>& folder_of);

// Assumed where nothing was measured.
inline constexpr double kAssumedFrame_s = 1.0 / 35.0;
inline constexpr double kAssumedDrawnFrame_s = 0.25;
inline constexpr double kAssumedNoisyFrame_s = 0.03;
inline constexpr double kAssumedBoxesFrame_s = 0.2;

// Seconds that one process takes to render and run everything, each job once.
double EstimatedSeconds(const BuiltPlan& built, const std::vector<PredictedState>& outlook,
                        const std::map<std::string, double>& frame_times_s);

}  // namespace cvo
