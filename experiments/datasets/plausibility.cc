// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/plausibility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/median.h"

namespace cvo {
namespace {

// Steps from one frame to the next that are too large: the first is told, the others are counted.
class LargeSteps {
 public:
  void Add(const std::string& about, int frame, const std::string& what) {
    if (count_++ == 0) first_ = StrCat(about, ", frame ", frame, ": ", what);
  }
  void Tell(std::vector<std::string>& lines) const {
    if (count_ == 0) return;
    const std::string others = count_ > 1 ? StrCat(", and ", count_ - 1, " more like it") : "";
    lines.push_back(first_ + others);
  }

 private:
  int count_ = 0;
  std::string first_;
};

// Of another unit than metres, most likely.
void FindBaseline(double baseline_m, std::vector<std::string>& lines) {
  constexpr double kShortest_m = 1e-3;
  constexpr double kLongest_m = 10.0;
  if (baseline_m == 0.0 || (baseline_m >= kShortest_m && baseline_m <= kLongest_m)) return;
  lines.push_back(StrCat("calibration: a baseline of ", baseline_m, " m"));
}

void FindGaps(const Sequence& sequence, const std::vector<double>& steps_s,
              std::vector<std::string>& lines) {
  constexpr double kLongest = 5.0;  // times the usual interval
  const double usual_s = Median(steps_s);
  LargeSteps gaps;
  for (std::size_t i = 0; i < steps_s.size(); ++i) {
    if (steps_s[i] <= kLongest * usual_s) continue;
    gaps.Add("times", sequence.first_frame + static_cast<int>(i) + 1,
             StrCat(steps_s[i], " s after the one before, where ", usual_s, " s is usual"));
  }
  gaps.Tell(lines);
}

void FindJumps(const Sequence& sequence, const std::vector<double>& steps_s,
               std::vector<std::string>& lines) {
  constexpr double kFastest_m_s = 100.0;
  constexpr double kNoise_m = 1.0;  // of a truth that was measured
  const auto& truth = sequence.groundtruth_world_from_camera;
  LargeSteps jumps;
  for (std::size_t i = 0; i < steps_s.size(); ++i) {
    if (!truth[i] || !truth[i + 1]) continue;
    const double moved_m = (truth[i + 1]->translation() - truth[i]->translation()).norm();
    if (moved_m <= kNoise_m + kFastest_m_s * steps_s[i]) continue;
    jumps.Add("ground truth of the camera", sequence.first_frame + static_cast<int>(i) + 1,
              StrCat(moved_m, " m from the one before, ", steps_s[i], " s earlier"));
  }
  jumps.Tell(lines);
}

// Velocity from each frame to the next, m/s; empty where one of the two has no truth.
std::vector<std::optional<Eigen::Vector3d>> Velocities(const TruthBody& body,
                                                       const std::vector<double>& steps_s) {
  std::vector<std::optional<Eigen::Vector3d>> velocities(steps_s.size());
  for (std::size_t i = 0; i < steps_s.size(); ++i) {
    const auto& from = body.frames[i];
    const auto& to = body.frames[i + 1];
    if (!from || !to) continue;
    velocities[i] =
        (to->world_from_object.translation() - from->world_from_object.translation()) / steps_s[i];
  }
  return velocities;
}

// The two steps beside a step, at an end or a gap the next two; empty where there are fewer.
std::vector<std::size_t> Beside(std::size_t i,
                                const std::vector<std::optional<Eigen::Vector3d>>& velocities) {
  const auto known = [&](std::size_t k) { return k < velocities.size() && velocities[k]; };
  if (!known(i)) return {};
  if (known(i - 1) && known(i + 1)) return {i - 1, i + 1};
  if (known(i + 1) && known(i + 2)) return {i + 1, i + 2};
  if (known(i - 1) && known(i - 2)) return {i - 1, i - 2};
  return {};
}

// A jump is a step unlike those beside it: what bounces or brakes goes on with its new velocity.
void FindBodyJumps(const ObjectTruth& truth, const std::vector<double>& steps_s,
                   std::vector<std::string>& lines) {
  constexpr double kHardest_m_s2 = 100.0;
  constexpr double kNoise_m = 0.2;  // of labels, in the difference of two steps
  LargeSteps jumps;
  for (const TruthBody& body : truth.bodies) {
    const auto velocities = Velocities(body, steps_s);
    for (std::size_t i = 0; i < steps_s.size(); ++i) {
      double least_m_s = std::numeric_limits<double>::infinity();  // change, 0: a possible one
      for (const std::size_t other : Beside(i, velocities)) {
        const double change_m_s = (*velocities[i] - *velocities[other]).norm();
        const double possible_m_s = kHardest_m_s2 * 0.5 * (steps_s[i] + steps_s[other]) +
                                    kNoise_m / std::min(steps_s[i], steps_s[other]);
        least_m_s = std::min(least_m_s, change_m_s > possible_m_s ? change_m_s : 0.0);
      }
      if (least_m_s == 0.0 || std::isinf(least_m_s)) continue;
      jumps.Add("ground truth of body " + body.name, truth.first_frame + static_cast<int>(i) + 1,
                StrCat("moves ", std::round(10.0 * least_m_s) / 10.0,
                       " m/s otherwise than just before and after"));
    }
  }
  jumps.Tell(lines);
}

}  // namespace

std::vector<std::string> FindImplausible(const Sequence& sequence, const ObjectTruth* bodies) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < sequence.timestamps_ns.size(); ++i) {
    steps_s.push_back(
        1e-9 * static_cast<double>(sequence.timestamps_ns[i] - sequence.timestamps_ns[i - 1]));
  }
  std::vector<std::string> lines;
  FindBaseline(sequence.camera.baseline_m, lines);
  if (steps_s.empty()) return lines;
  FindGaps(sequence, steps_s, lines);
  FindJumps(sequence, steps_s, lines);
  if (bodies != nullptr) FindBodyJumps(*bodies, steps_s, lines);
  return lines;
}

}  // namespace cvo
