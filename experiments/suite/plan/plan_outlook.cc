// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/plan/plan_outlook.h"

#include <set>

#include "core/base/error.h"
#include "core/files/json/options_json.h"
#include "experiments/suite/cell_input.h"
#include "reports/results/timing.h"

namespace cvo {
namespace {

constexpr int kFilesRead = 5;  // per variant

struct Mean {
  double sum_s = 0.0;
  int files = 0;

  void Add(double seconds) {
    sum_s += seconds;
    ++files;
  }
};

// Identifies a cell as the user sees it, regardless of what it is computed from.
std::string NameOf(const Cell& cell) {
  return DumpJson({{"sequence", cell.sequence.name},
                   {"detections", cell.sequence.detections},
                   {"variant", cell.variant},
                   {"system", cell.system},
                   {"seed", cell.seed},
                   {"oracle", cell.oracle},
                   {"parameters", ParametersOf(cell)}});
}

Json ResolvedOptions(const Suite& suite, const Cell& cell) {
  Options options = OptionsOf(suite, cell.variant, cell.parameters);
  return OptionsToJson(OptionLeaves(options));
}

std::string Differences(const Plan& plan, const PlannedJob& job, const Plan& earlier,
                        const PlannedJob& before) {
  std::string why;
  const auto add = [&why](bool differs, const char* what) {
    if (differs) why += (why.empty() ? "" : ", ") + std::string(what);
  };
  add(plan.build != earlier.build, "different build of the program");
  add(job.content != before.content, "the sequence has changed");
  if (job.cell.system.empty()) {
    add(ResolvedOptions(plan.suite, job.cell) != ResolvedOptions(earlier.suite, before.cell),
        "different options");
  }
  return why.empty() ? "different boxes or files" : why;
}

std::string ReasonToRun(const Plan& plan, const PlannedJob& job, const EarlierRuns& earlier,
                        const std::map<std::string, const PlannedJob*>& before) {
  if (const std::string message = earlier.failed(job.job); !message.empty()) {
    return "failed before: " + message;
  }
  const auto found = before.find(NameOf(job.cell));
  if (found == before.end()) return earlier.plan ? "not in the previous plan" : "new";
  if (found->second->job == job.job || found->second->job.empty()) return "not run yet";
  // A job that was never computed cannot be outdated.
  if (!earlier.done(*found->second)) return "not run yet";
  return Differences(plan, job, *earlier.plan, *found->second);
}

// Empty if the file cannot be read: the estimate can do without it.
std::optional<double> FrameTimeOf(const std::filesystem::path& file) {
  try {
    const auto timing = ReadRecord<reports::TimingData>(file);
    const double frames = static_cast<double>(timing.frames.size());
    if (frames > 0.0) return timing.wall_s / frames;
  } catch (const Error&) {
  }
  return std::nullopt;
}

double AssumedFrame_s(Stage stage) {
  if (stage == Stage::kBoxes) return kAssumedBoxesFrame_s;
  return kAssumedNoisyFrame_s + (stage == Stage::kDrawing ? kAssumedDrawnFrame_s : 0.0);
}

}  // namespace

std::vector<PredictedState> PredictStates(const Plan& plan, const EarlierRuns& earlier) {
  std::map<std::string, const PlannedJob*> before;
  if (earlier.plan) {
    for (const PlannedJob& job : earlier.plan->jobs) before.emplace(NameOf(job.cell), &job);
  }
  std::vector<PredictedState> outlook;
  for (const PlannedJob& job : plan.jobs) {
    if (IsPending(job.missing)) {
      outlook.push_back({JobState::kPrepares, job.missing});
    } else if (!job.missing.empty()) {
      outlook.push_back({JobState::kMissing, job.missing});
    } else if (earlier.done(job)) {
      outlook.push_back({JobState::kDone, ""});
    } else {
      outlook.push_back({JobState::kRuns, ReasonToRun(plan, job, earlier, before)});
    }
  }
  return outlook;
}

std::map<std::string, double> MeasuredFrameTimes(
    const Plan& plan, const EarlierRuns& earlier,
    const std::function<std::filesystem::path(const std::string& job)>& folder_of) {
  std::map<std::string, Mean> means;
  const auto measure = [&](const PlannedJob& job) {
    const std::string& variant = job.cell.variant;
    if (job.job.empty() || variant.empty() || means[variant].files == kFilesRead) return;
    if (!earlier.done(job)) return;
    const auto frame_s = FrameTimeOf(folder_of(job.job) / "timing.json");
    if (!frame_s) return;
    means[variant].Add(*frame_s);
    means[""].Add(*frame_s);
  };
  for (const PlannedJob& job : plan.jobs) measure(job);
  if (earlier.plan) {
    for (const PlannedJob& job : earlier.plan->jobs) measure(job);
  }
  std::map<std::string, double> times_s;
  for (const auto& [variant, mean] : means) {
    if (mean.files > 0) times_s[variant] = mean.sum_s / mean.files;
  }
  return times_s;
}

double EstimatedSeconds(const BuiltPlan& built, const std::vector<PredictedState>& outlook,
                        const std::map<std::string, double>& frame_times_s) {
  double seconds = 0.0;
  for (const Preparation& preparation : built.preparations) {
    seconds += preparation.frames * AssumedFrame_s(preparation.stage);
  }
  std::set<std::string> counted;
  for (std::size_t i = 0; i < built.plan.jobs.size(); ++i) {
    const PlannedJob& job = built.plan.jobs[i];
    const JobState state = outlook.at(i).state;
    if (state == JobState::kDone || state == JobState::kMissing || !job.cell.system.empty()) {
      continue;
    }
    if (!job.job.empty() && !counted.insert(job.job).second) continue;
    auto found = frame_times_s.find(job.cell.variant);
    if (found == frame_times_s.end()) found = frame_times_s.find("");
    seconds += job.frames * (found == frame_times_s.end() ? kAssumedFrame_s : found->second);
  }
  return seconds;
}

}  // namespace cvo
