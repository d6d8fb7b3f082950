// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

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
  constexpr double kShortest_m = 0.01;
  constexpr double kLongest_m = 3.0;
  if (baseline_m == 0.0 || (baseline_m >= kShortest_m && baseline_m <= kLongest_m)) return;
  lines.push_back(StrCat("calibration: a baseline of ", baseline_m, " m, where ", kShortest_m,
                         " to ", kLongest_m, " m are usual"));
}

std::vector<double> StepsOf(const Sequence& sequence) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < sequence.timestamps_ns.size(); ++i) {
    steps_s.push_back(
        1e-9 * static_cast<double>(sequence.timestamps_ns[i] - sequence.timestamps_ns[i - 1]));
  }
  return steps_s;
}

void FindSlowRate(const std::vector<double>& steps_s, std::vector<std::string>& lines) {
  constexpr double kLongest_s = 1.0;
  const double step_s = Median(steps_s);
  if (step_s > kLongest_s) lines.push_back(StrCat("times: a median of ", step_s, " s per frame"));
}

// Finds boxes in pixels of a larger image, such as one of twice the size.
void FindBoxesBeyond(const Sequence& sequence, const char* what,
                     const std::vector<ObjectBox>& boxes, std::vector<std::string>& lines) {
  constexpr double kMargin_px = 8.0;
  constexpr double kMost = 0.1;  // part of the boxes
  const StereoCamera& camera = sequence.camera;
  const auto beyond = std::ranges::count_if(boxes, [&](const ObjectBox& box) {
    return box.right_px > camera.width_px + kMargin_px ||
           box.bottom_px > camera.height_px + kMargin_px;
  });
  if (static_cast<double>(beyond) <= kMost * static_cast<double>(boxes.size())) return;
  lines.push_back(StrCat(what, ": ", beyond, " of ", boxes.size(),
                         " boxes end beyond the image of ", camera.width_px, "x", camera.height_px,
                         " px"));
}

// Throws Error for boxes as fractions of the image.
void RefuseFractions(const std::filesystem::path& file, const std::vector<ObjectBox>& boxes) {
  constexpr double kLargest = 2.0;
  constexpr std::size_t kFewest = 3;
  double largest = 0.0;
  for (const ObjectBox& box : boxes) largest = std::max({largest, box.right_px, box.bottom_px});
  if (boxes.size() < kFewest || largest > kLargest || largest <= 0.0) return;
  ThrowError(file.string(), StrCat("boxes that end at ", largest, " or before"),
             "boxes in pixels, not in parts of the image");
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
  for (std::size_t i = 0; i + 1 < truth.size(); ++i) {
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

void RefuseImpossible(const Sequence& sequence) {
  constexpr double kShortest_s = 0.001;
  const std::vector<double> steps_s = StepsOf(sequence);
  if (!steps_s.empty() && Median(steps_s) < kShortest_s) {
    ThrowError(sequence.folder.string() + ", times",
               StrCat("a median of ", Median(steps_s), " s per frame"),
               "at most 1000 frames per second (is their unit another one?)");
  }
  RefuseFractions(sequence.box_sources.detections, sequence.detections);
  RefuseFractions(sequence.box_sources.labels, sequence.labels);
}

std::vector<std::string> FindImplausible(const Sequence& sequence, std::size_t repeated) {
  constexpr double kMostRepeated = 0.05;
  const std::vector<double> steps_s = StepsOf(sequence);
  std::vector<std::string> lines = sequence.notes;
  FindBaseline(sequence.camera.baseline_m, lines);
  FindBoxesBeyond(sequence, "detections", sequence.detections, lines);
  FindBoxesBeyond(sequence, "labels", sequence.labels, lines);
  const std::size_t frames = sequence.images.size();
  if (static_cast<double>(repeated) > kMostRepeated * static_cast<double>(frames)) {
    lines.push_back(StrCat("images: ", repeated, " of ", frames, " frames repeat the one before"));
  }
  if (steps_s.empty()) return lines;
  FindSlowRate(steps_s, lines);
  FindGaps(sequence, steps_s, lines);
  FindJumps(sequence, steps_s, lines);
  return lines;
}

}  // namespace cvo
