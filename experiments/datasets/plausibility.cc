// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/plausibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/features/orb/orb.h"
#include "core/files/text/number.h"
#include "experiments/datasets/images.h"

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

// Finds boxes in pixels of a smaller image, or in per cent: all lie in a quarter of this one.
void FindHalfSize(const Sequence& sequence, const char* what, const std::vector<ObjectBox>& boxes,
                  std::vector<std::string>& lines) {
  constexpr std::size_t kFewest = 20;
  constexpr double kLargest = 0.525;  // detectors end boxes a little beyond the image
  const StereoCamera& camera = sequence.camera;
  const bool small = std::ranges::all_of(boxes, [&](const ObjectBox& box) {
    return box.right_px < kLargest * camera.width_px && box.bottom_px < kLargest * camera.height_px;
  });
  if (boxes.size() < kFewest || !small) return;
  lines.push_back(StrCat(what, ": all ", boxes.size(), " boxes lie in the upper left quarter of ",
                         "the image (of an image of half the size?)"));
}

void FindDoubled(const char* what, const std::vector<ObjectBox>& boxes,
                 std::vector<std::string>& lines) {
  std::set<std::tuple<int, std::string, double, double, double, double>> seen;
  std::size_t doubled = 0;
  for (const ObjectBox& box : boxes) {
    const bool fresh =
        seen.insert({box.frame, box.type, box.left_px, box.top_px, box.right_px, box.bottom_px})
            .second;
    doubled += fresh ? 0 : 1;
  }
  constexpr double kMost = 0.05;
  if (static_cast<double>(doubled) <= kMost * static_cast<double>(boxes.size())) return;
  lines.push_back(StrCat(what, ": ", doubled, " of ", boxes.size(), " boxes repeat another one"));
}

// Finds values beyond what KITTI defines, and boxes in 3D that are elsewhere than those in the
// image.
void FindOddBoxes(const Sequence& sequence, const char* what, const std::vector<ObjectBox>& boxes,
                  std::vector<std::string>& lines) {
  constexpr double kMost = 0.2;
  const StereoCamera& camera = sequence.camera;
  std::vector<std::string> odd;
  std::size_t solid = 0;
  std::size_t aside = 0;
  for (const ObjectBox& box : boxes) {
    const auto find = [&](const char* name, double value, double least, double most) {
      if (value >= least && value <= most) return;
      odd.push_back(StrCat(what, ", frame ", box.frame, ": ", name, " ", value, ", where ", least,
                           " to ", most, " are defined"));
    };
    find("occlusion", box.occlusion, -1.0, 3.0);
    find("truncation", box.truncation, -1.0, 2.0);
    if (!box.box3d) continue;
    find("heading", box.box3d->heading_rad, -6.3, 6.3);
    find("length", box.box3d->length_m, 0.0, 40.0);
    const Eigen::Vector3d centre =
        box.box3d->bottom_in_camera +
        Eigen::Vector3d(sequence.left_offset_m, -0.5 * box.box3d->height_m, 0.0);
    if (!box.IsInImage() || box.truncation > 0.0 || box.occlusion > 0) continue;
    // The box in the image may show only a part of the body.
    const double margin_px = std::max(box.right_px - box.left_px, box.bottom_px - box.top_px);
    const double u_px = camera.fx * centre.x() / centre.z() + camera.cx;
    const double v_px = camera.fy * centre.y() / centre.z() + camera.cy;
    const bool within = u_px > box.left_px - margin_px && u_px < box.right_px + margin_px &&
                        v_px > box.top_px - margin_px && v_px < box.bottom_px + margin_px;
    ++solid;
    aside += centre.z() > 0.0 && within ? 0 : 1;
  }
  Tell(odd, lines);
  if (static_cast<double>(aside) <= kMost * static_cast<double>(solid)) return;
  lines.push_back(StrCat(what, ": of ", solid, " boxes in 3D, ", aside,
                         " have their centre beside their box in the image"));
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

using Corners = std::vector<OrbKeypoint>;

Corners CornersOf(const Sequence& sequence, std::size_t index, int side, int count) {
  const cv::Mat grey = LoadFrameImage(sequence, index, side).grey;
  return grey.empty() ? Corners() : ExtractOrb(grey, {.features = count}).keypoints;
}

// Returns the corner that looks most like this one; nullptr if none is similar enough or another is
// about as similar.
const OrbKeypoint* MostAlike(const OrbKeypoint& corner, const Corners& others) {
  constexpr int kFarthest = 64;        // of 256 bits
  constexpr double kUniqueness = 0.8;  // best / second-best distance
  int best = 257;
  int second = 257;
  const OrbKeypoint* alike = nullptr;
  for (const OrbKeypoint& other : others) {
    const int distance = HammingDistance(corner.descriptor, other.descriptor);
    if (distance < best) {
      second = best;
      best = distance;
      alike = &other;
    } else {
      second = std::min(second, distance);
    }
  }
  return best <= kFarthest && best < kUniqueness * second ? alike : nullptr;
}

// For each corner of `from`, the one of `to` of which it is the most alike as well; null: none.
std::vector<const OrbKeypoint*> MatchAnywhere(const Corners& from, const Corners& to) {
  std::vector<const OrbKeypoint*> partners;
  for (const OrbKeypoint& corner : from) {
    const OrbKeypoint* partner = MostAlike(corner, to);
    const bool mutual = partner != nullptr && MostAlike(*partner, from) == &corner;
    partners.push_back(mutual ? partner : nullptr);
  }
  return partners;
}

Eigen::Vector2d PixelOf(const OrbKeypoint& corner) { return {corner.u_px, corner.v_px}; }

constexpr std::size_t kFewestMatches = 20;

std::optional<PairCheck> CheckPair(const Corners& left,
                                   const std::vector<const OrbKeypoint*>& right) {
  std::vector<double> rows_px;
  std::vector<double> disparities_px;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (right[i] == nullptr) continue;
    const Eigen::Vector2d apart_px = PixelOf(left[i]) - PixelOf(*right[i]);
    disparities_px.push_back(apart_px.x());
    rows_px.push_back(std::abs(apart_px.y()));
  }
  if (rows_px.size() < kFewestMatches) return std::nullopt;
  const bool same = *std::ranges::max_element(rows_px) == 0.0 &&
                    std::ranges::all_of(disparities_px, [](double px) { return px == 0.0; });
  PairCheck pair{0, rows_px.size(), Median(std::move(rows_px)), Median(std::move(disparities_px)),
                 ""};
  if (same) {
    pair.problem = "the left and right images are the same";
  } else if (pair.disparity_px < 0.0) {
    pair.problem =
        "left and right seem to be swapped: points are farther right in the right image than in "
        "the left";
  }
  return pair;
}

// What the images of a frame and a later one tell: medians over corners.
struct Sample {
  std::optional<PairCheck> pair;
  double depth_m = 0.0;
  double flow_px = 0.0;   // of the left image
  double error_px = 0.0;  // of what depths and ground truth predict for the later frame
};

// Compares the corners of a frame, triangulated, with where the ground truth puts them later.
void Predict(const StereoCamera& camera, const RigidTransform& later_from_camera,
             const Corners& left, const std::vector<const OrbKeypoint*>& right,
             const std::vector<const OrbKeypoint*>& later, Sample& sample) {
  constexpr double kLeastDisparity_px = 1.0;
  std::vector<double> flows_px;
  std::vector<double> errors_px;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (right[i] == nullptr || later[i] == nullptr) continue;
    const double disparity_px = left[i].u_px - right[i]->u_px + camera.right_shift_px;
    if (disparity_px < kLeastDisparity_px) continue;
    const double depth_m = camera.fx * camera.baseline_m / disparity_px;
    const Eigen::Vector3d p_in_later =
        later_from_camera * Eigen::Vector3d((left[i].u_px - camera.cx) * depth_m / camera.fx,
                                            (left[i].v_px - camera.cy) * depth_m / camera.fy,
                                            depth_m);
    flows_px.push_back((PixelOf(*later[i]) - PixelOf(left[i])).norm());
    const Eigen::Vector2d predicted(camera.fx * p_in_later.x() / p_in_later.z() + camera.cx,
                                    camera.fy * p_in_later.y() / p_in_later.z() + camera.cy);
    errors_px.push_back(p_in_later.z() > 0.0 ? (PixelOf(*later[i]) - predicted).norm() : 1e9);
  }
  if (flows_px.size() < kFewestMatches) return;
  sample.flow_px = Median(std::move(flows_px));
  sample.error_px = Median(std::move(errors_px));
}

// Of a few frames over the sequence, each compared with the one a tenth of a second later.
std::vector<Sample> SampleImages(const Sequence& sequence, double step_s) {
  constexpr std::size_t kSamples = 6;
  constexpr double kApart_s = 0.1;
  constexpr int kCorners = 1000;
  const std::size_t frames = sequence.images.size();
  const auto apart = static_cast<std::size_t>(std::max(1.0, std::round(kApart_s / step_s)));
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < kSamples && apart < frames; ++k) {
    const std::size_t i = k * (frames - 1 - apart) / (kSamples - 1);
    if (k > 0 && i == (k - 1) * (frames - 1 - apart) / (kSamples - 1)) continue;
    const Corners left = CornersOf(sequence, i, 0, kCorners);
    const Corners right = CornersOf(sequence, i, 1, kCorners);
    const std::vector<const OrbKeypoint*> partners = MatchAnywhere(left, right);
    samples.push_back({CheckPair(left, partners)});
    if (samples.back().pair && samples.back().pair->disparity_px > 0.0) {
      samples.back().depth_m =
          sequence.camera.fx * sequence.camera.baseline_m / samples.back().pair->disparity_px;
    }
    const auto& now = sequence.groundtruth_world_from_camera[i];
    const auto& then = sequence.groundtruth_world_from_camera[i + apart];
    if (!now || !then) continue;
    const Corners later = CornersOf(sequence, i + apart, 0, kCorners);
    Predict(sequence.camera, then->Inverse() * *now, left, partners, MatchAnywhere(left, later),
            samples.back());
  }
  return samples;
}

// Finds contradictions between images, calibration and ground truth, in the median of the samples.
void FindInImages(const std::vector<Sample>& samples, std::vector<std::string>& lines) {
  constexpr double kMostRows_px = 1.0;
  constexpr double kNearest_m = 0.1;
  constexpr double kFarthest_m = 150.0;
  constexpr double kLeastFlow_px = 3.0;  // less tells nothing
  constexpr double kMostError = 0.4;     // part of the flow
  std::vector<double> rows_px, depths_m, flows_px, errors;
  std::vector<std::string> problems;
  for (const Sample& sample : samples) {
    if (sample.pair) rows_px.push_back(sample.pair->row_error_px);
    if (sample.pair && !sample.pair->problem.empty()) problems.push_back(sample.pair->problem);
    if (sample.depth_m > 0.0) depths_m.push_back(sample.depth_m);
    if (sample.flow_px < kLeastFlow_px) continue;
    flows_px.push_back(sample.flow_px);
    errors.push_back(sample.error_px / sample.flow_px);
  }
  const auto most = [&](std::size_t count) { return 2 * count > samples.size(); };
  if (most(problems.size())) {
    lines.push_back("stereo pair: " + problems[0]);
  } else if (most(rows_px.size()) && Median(rows_px) > kMostRows_px) {
    lines.push_back(StrCat("stereo pair: points lie ", FormatFixed(Median(rows_px), 1),
                           " px apart in rows (right images of other frames, or not rectified?)"));
  } else if (most(depths_m.size()) &&
             !(Median(depths_m) > kNearest_m && Median(depths_m) < kFarthest_m)) {
    lines.push_back(StrCat("calibration: a median depth of ", FormatGeneral(Median(depths_m), 3),
                           " m (is the baseline right?)"));
  } else if (most(errors.size()) && Median(errors) > kMostError) {
    lines.push_back(StrCat("ground truth of the camera: points move by ",
                           FormatFixed(Median(flows_px), 1), " px in the images and end ",
                           FormatFixed(100.0 * Median(errors), 0),
                           " % of that away from where it puts them (another scale, order or "
                           "clock, or a wrong baseline?)"));
  }
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

std::optional<PairCheck> CheckMiddlePair(const Sequence& sequence) {
  constexpr int kCorners = 1000;
  const std::size_t middle = sequence.images.size() / 2;
  const Corners left = CornersOf(sequence, middle, 0, kCorners);
  std::optional<PairCheck> pair =
      CheckPair(left, MatchAnywhere(left, CornersOf(sequence, middle, 1, kCorners)));
  if (pair) pair->frame = sequence.first_frame + static_cast<int>(middle);
  return pair;
}

std::vector<std::string> FindImplausible(const Sequence& sequence, std::size_t repeated) {
  constexpr double kMostRepeated = 0.05;
  std::vector<std::string> lines = sequence.notes;
  FindBaseline(sequence.camera.baseline_m, lines);
  for (const auto& [what, boxes] :
       {std::pair{"detections", &sequence.detections}, std::pair{"labels", &sequence.labels}}) {
    FindBoxesBeyond(sequence, what, *boxes, lines);
    FindHalfSize(sequence, what, *boxes, lines);
    FindDoubled(what, *boxes, lines);
    FindOddBoxes(sequence, what, *boxes, lines);
  }
  const std::size_t frames = sequence.images.size();
  if (static_cast<double>(repeated) > kMostRepeated * static_cast<double>(frames)) {
    lines.push_back(StrCat("images: ", repeated, " of ", frames, " frames repeat the one before"));
  }
  const std::vector<double> steps_s = StepsOf(sequence);
  if (steps_s.empty()) return lines;
  FindSlowRate(steps_s, lines);
  FindGaps(sequence, steps_s, lines);
  FindJumps(sequence, steps_s, lines);
  const bool rendered = std::filesystem::exists(sequence.folder / "manifest.json");
  if (!rendered && PerturbationToJson(sequence.perturbation).empty()) {
    FindInImages(SampleImages(sequence, Median(steps_s)), lines);
  }
  return lines;
}

}  // namespace cvo
