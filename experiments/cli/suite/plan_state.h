// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/jobs/suite_folder.h"
#include "experiments/suite/plan_outlook.h"

namespace cvo {

// A plan and what of it the output folder already has.
struct PlanState {
  BuiltPlan built;
  std::vector<PredictedState> outlook;
  std::map<std::string, double> frame_times_s;  // MeasuredFrameTimes
};

// A plan.json that cannot be read counts as none.
PlanState FindPlanState(const Suite& suite, const PlanRequest& request, const SuiteFolder& folder);

}  // namespace cvo
