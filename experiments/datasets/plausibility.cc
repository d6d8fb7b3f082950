// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/plausibility.h"

#include "core/base/error.h"
#include "core/base/median.h"

namespace cvo {
namespace {

// Steps from one frame to the next that are too large: the first is told, the others are counted.
class LargeSteps {
 public:
  void Add(int frame, const std::string& what) {
    if (count_++ == 0) first_ = StrCat("frame ", frame, ": ", what);
  }
  void Tell(const std::string& about, std::vector<std::string>& lines) const {
    if (count_ == 0) return;
    const std::string others = count_ > 1 ? StrCat(", and ", count_ - 1, " more like it") : "";
    lines.push_back(StrCat(about, ", ", first_, others));
  }

 private:
  int count_ = 0;
  std::string first_;
};

void FindGaps(const Sequence& sequence, const std::vector<double>& steps_s,
              std::vector<std::string>& lines) {
  constexpr double kLongest = 5.0;  // times the usual interval
  const double usual_s = Median(steps_s);
  LargeSteps gaps;
  for (std::size_t i = 0; i < steps_s.size(); ++i) {
    if (steps_s[i] <= kLongest * usual_s) continue;
    gaps.Add(sequence.first_frame + static_cast<int>(i) + 1,
             StrCat(steps_s[i], " s after the one before, where ", usual_s, " s is usual"));
  }
  gaps.Tell("times", lines);
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
    jumps.Add(sequence.first_frame + static_cast<int>(i) + 1,
              StrCat(moved_m, " m from the one before, ", steps_s[i], " s earlier"));
  }
  jumps.Tell("ground truth of the camera", lines);
}

}  // namespace

std::vector<std::string> FindImplausible(const Sequence& sequence) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < sequence.timestamps_ns.size(); ++i) {
    steps_s.push_back(
        1e-9 * static_cast<double>(sequence.timestamps_ns[i] - sequence.timestamps_ns[i - 1]));
  }
  std::vector<std::string> lines;
  if (steps_s.empty()) return lines;
  FindGaps(sequence, steps_s, lines);
  FindJumps(sequence, steps_s, lines);
  return lines;
}

}  // namespace cvo
