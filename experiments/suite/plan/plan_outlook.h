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
  std::function<bool(const PlannedJob& job)> done;  // whether its files exist
  std::function<std::string(const std::string& job)>
      failed;  // message of its last failure, or empty
};

// Returns one state per job of the plan. If a job had another identity in the earlier plan, the
// reason names what differs: the build, the sequence, the options, or else boxes or files.
std::vector<PredictedState> PredictStates(const Plan& plan, const EarlierRuns& earlier);

// Seconds per frame of one process, by variant ("": the mean over all files read), from timing.json
// of the finished jobs of both plans. Reads only a few files per variant and ignores unreadable
// ones.
std::map<std::string, double> MeasuredFrameTimes(
    const Plan& plan, const EarlierRuns& earlier,
    const std::function<std::filesystem::path(const std::string& job)>& folder_of);

// Seconds per frame to assume if nothing was measured.
inline constexpr double kAssumedFrame_s = 1.0 / 35.0;
inline constexpr double kAssumedDrawnFrame_s = 0.25;
inline constexpr double kAssumedNoisyFrame_s = 0.03;
inline constexpr double kAssumedBoxesFrame_s = 0.2;

// Estimates the seconds that one process takes to prepare and run everything, each job once.
double EstimatedSeconds(const BuiltPlan& built, const std::vector<PredictedState>& outlook,
                        const std::map<std::string, double>& frame_times_s);

}  // namespace cvo
