// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/geometry/rigid_transform.h"
#include "experiments/datasets/sequence.h"

namespace cvo {
namespace {

// Collects the steps between consecutive frames that are too large. Describes the first one and
// counts the others.
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

// Finds a baseline that is most likely in another unit than metres.
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
  constexpr double kNoise_m = 1.0;  // of a measured ground truth
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

// The motion of a camera from one frame to the next.
struct CameraStep {
  double length_m = 0.0;
  double sideways_m = 0.0;  // to the right, in the frame of the earlier camera
  double turn_rad = 0.0;
};

// A stretch of the path of a camera on a car.
struct Stretch {
  int first = 0;  // frame
  int last = 0;
  double sideways_rad = 0.0;    // angle from the optical axis to the direction of travel
  double by_turning_rad = 0.0;  // how much of it the turning of the car can explain
};

// Returns the stretches of 10 m that start at each of the frames.
std::vector<Stretch> StretchesOf(int first_frame, const std::vector<CameraStep>& steps) {
  constexpr double kLength_m = 10.0;
  constexpr double kLever_m = 3.0;  // from a car's rear axle to its camera, at most
  std::vector<Stretch> stretches;
  CameraStep sum;  // running sum from begin to end, as a car may stand for thousands of frames
  const auto add = [&sum](const CameraStep& step, double sign) {
    sum.length_m += sign * step.length_m;
    sum.sideways_m += sign * step.sideways_m;
    sum.turn_rad += sign * step.turn_rad;
  };
  for (std::size_t begin = 0, end = 0; begin < steps.size(); ++begin) {
    for (; end < steps.size() && sum.length_m < kLength_m; ++end) add(steps[end], 1.0);
    if (sum.length_m < kLength_m) break;
    stretches.push_back({first_frame + static_cast<int>(begin), first_frame + static_cast<int>(end),
                         sum.sideways_m / sum.length_m, kLever_m * sum.turn_rad / sum.length_m});
    add(steps[begin], -1.0);
  }
  return stretches;
}

// A car moves where it heads. Positions that move sideways are wrong: those of OxTS drift by a
// metre on KITTI drive 0013.
void FindSideslip(const Sequence& sequence, std::vector<std::string>& lines) {
  constexpr double kLeast_rad = 0.02;  // our sequences stay within 0.004 of their median
  const auto& truth = sequence.groundtruth_world_from_camera;
  std::vector<CameraStep> steps;
  for (std::size_t i = 0; i + 1 < truth.size(); ++i) {
    if (!truth[i] || !truth[i + 1]) return;
    const RigidTransform step = truth[i]->Inverse() * *truth[i + 1];
    steps.push_back(
        {step.translation().norm(), step.translation().x(), std::abs(LogSo3(step.rotation()).y())});
  }
  const std::vector<Stretch> stretches = StretchesOf(sequence.first_frame, steps);
  if (stretches.empty()) return;
  std::vector<double> angles_rad;
  for (const Stretch& stretch : stretches) angles_rad.push_back(stretch.sideways_rad);
  const double usual_rad = Median(angles_rad);  // the camera need not look straight ahead
  const auto slip_rad = [&](const Stretch& stretch) {
    return std::abs(stretch.sideways_rad - usual_rad) - stretch.by_turning_rad;
  };
  const Stretch worst = *std::max_element(
      stretches.begin(), stretches.end(),
      [&](const Stretch& a, const Stretch& b) { return slip_rad(a) < slip_rad(b); });
  if (slip_rad(worst) < kLeast_rad) return;
  lines.push_back(StrCat("ground truth of the camera, frames ", worst.first, " to ", worst.last,
                         ": the car slips sideways by ",
                         std::round(1000.0 * slip_rad(worst)) / 100.0,
                         " m in 10 m: its positions do not fit its orientations"));
}

// Returns the velocity from each frame to the next, m/s; empty if one of the two has no truth.
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

// Returns the two steps next to step i: one on either side, or two on the same side at an end or a
// gap. Empty if there are fewer.
std::vector<std::size_t> Beside(std::size_t i,
                                const std::vector<std::optional<Eigen::Vector3d>>& velocities) {
  const auto known = [&](std::size_t k) { return k < velocities.size() && velocities[k]; };
  if (!known(i)) return {};
  if (known(i - 1) && known(i + 1)) return {i - 1, i + 1};
  if (known(i + 1) && known(i + 2)) return {i + 1, i + 2};
  if (known(i - 1) && known(i - 2)) return {i - 1, i - 2};
  return {};
}

// A jump is a step that differs from those next to it: a body that bounces or brakes continues with
// its new velocity.
void FindBodyJumps(const ObjectTruth& truth, const std::vector<double>& steps_s,
                   std::vector<std::string>& lines) {
  constexpr double kHardest_m_s2 = 100.0;
  constexpr double kNoise_m = 0.2;  // of labels, in the difference of two steps
  LargeSteps jumps;
  for (const TruthBody& body : truth.bodies) {
    const auto velocities = Velocities(body, steps_s);
    for (std::size_t i = 0; i < steps_s.size(); ++i) {
      // The smallest impossible change of velocity, or 0 if one of the changes is possible.
      double least_m_s = std::numeric_limits<double>::infinity();
      for (const std::size_t other : Beside(i, velocities)) {
        const double change_m_s = (*velocities[i] - *velocities[other]).norm();
        const double possible_m_s = kHardest_m_s2 * 0.5 * (steps_s[i] + steps_s[other]) +
                                    kNoise_m / std::min(steps_s[i], steps_s[other]);
        least_m_s = std::min(least_m_s, change_m_s > possible_m_s ? change_m_s : 0.0);
      }
      if (least_m_s == 0.0 || std::isinf(least_m_s)) continue;
      jumps.Add("ground truth of body " + body.name, truth.first_frame + static_cast<int>(i) + 1,
                StrCat("its velocity differs by ", std::round(10.0 * least_m_s) / 10.0,
                       " m/s from those just before and after"));
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
  if (sequence.dataset == "kitti") FindSideslip(sequence, lines);
  if (bodies != nullptr) FindBodyJumps(*bodies, steps_s, lines);
  return lines;
}

}  // namespace cvo
