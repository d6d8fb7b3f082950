// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"
#include "core/base/lists.h"
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

}  // namespace

std::vector<std::string> FindImplausible(const Sequence& sequence) {
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
  return lines;
}

}  // namespace cvo
