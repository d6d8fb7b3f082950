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

// Adds the first of the findings and the number of the others.
void Tell(const std::vector<std::string>& found, std::vector<std::string>& lines) {
  if (found.empty()) return;
  const std::size_t others = found.size() - 1;
  lines.push_back(found[0] + (others > 0 ? StrCat(", and ", others, " more like it") : ""));
}

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
  std::vector<std::string> gaps;
  for (std::size_t i = 0; i < steps_s.size(); ++i) {
    if (steps_s[i] <= kLongest * usual_s) continue;
    gaps.push_back(StrCat("times, frame ", sequence.first_frame + static_cast<int>(i) + 1, ": ",
                          steps_s[i], " s after the one before, where ", usual_s, " s is usual"));
  }
  Tell(gaps, lines);
}

void FindJumps(const Sequence& sequence, const std::vector<double>& steps_s,
               std::vector<std::string>& lines) {
  constexpr double kFastest_m_s = 100.0;
  constexpr double kNoise_m = 1.0;  // of a measured ground truth
  const auto& truth = sequence.groundtruth_world_from_camera;
  std::vector<std::string> jumps;
  for (std::size_t i = 0; i < steps_s.size(); ++i) {
    if (!truth[i] || !truth[i + 1]) continue;
    const double moved_m = (truth[i + 1]->translation() - truth[i]->translation()).norm();
    if (moved_m <= kNoise_m + kFastest_m_s * steps_s[i]) continue;
    jumps.push_back(StrCat("ground truth of the camera, frame ",
                           sequence.first_frame + static_cast<int>(i) + 1, ": ", moved_m,
                           " m from the one before, ", steps_s[i], " s earlier"));
  }
  Tell(jumps, lines);
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
  std::vector<std::string> jumps;
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
      jumps.push_back(StrCat("ground truth of body ", body.name, ", frame ",
                             truth.first_frame + static_cast<int>(i) + 1,
                             ": its velocity differs by ", std::round(10.0 * least_m_s) / 10.0,
                             " m/s from those just before and after"));
    }
  }
  Tell(jumps, lines);
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
