// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/suite/build_plan.h"

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
  std::optional<Plan> plan;                      // of the previous run
  std::function<bool(const PlanJob& job)> done;  // whether its files exist
  // Message of its last failure, or empty.
  std::function<std::string(const std::string& job)> failed;
};

// Returns one state per job of the plan. If a job had another identity in the earlier plan, the
// reason names what differs: the build, the sequence, the options, or else boxes or files.
std::vector<PredictedState> PredictStates(const Plan& plan, const EarlierRuns& earlier);

// Returns the mean seconds per frame in timing.json of a few finished jobs of variants in both
// plans; empty if there is none.
std::optional<double> MeasuredFrameTime_s(
    const Plan& plan, const EarlierRuns& earlier,
    const std::function<std::filesystem::path(const std::string& job)>& folder_of);

// Estimates the seconds that one process takes to prepare and run everything, each job once. Jobs
// take 35 frames per second if nothing was measured; drawing takes 4.
double EstimatedSeconds(const BuiltPlan& built, const std::vector<PredictedState>& outlook,
                        const std::optional<double>& frame_time_s);

}  // namespace cvo
