// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What the images of a few frames contradict.
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/lists.h"
#include "core/features/orb/orb.h"
#include "core/files/text/number.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/plausibility.h"

namespace cvo {
namespace {

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
  SeenFrame seen;
  Corners left;
  bool dark = false;  // the left image has no corner
  bool both = false;  // both images have many corners
  std::optional<PairCheck> pair;
  double depth_m = 0.0;
  double flow_px = 0.0;      // of the left image
  double error_px = 0.0;     // of what depths and ground truth predict for the later frame
  double mirrored_px = 0.0;  // the same of the ground truth mirrored along x or y
  bool still = false;        // the ground truth has the same pose for both
};

// The same motion in a frame whose axis points the other way.
RigidTransform Mirrored(const RigidTransform& motion, int axis) {
  Eigen::Vector3d turn = -LogSo3(motion.rotation());
  Eigen::Vector3d step = motion.translation();
  turn[axis] *= -1.0;
  step[axis] *= -1.0;
  return RigidTransform(ExpSo3(turn), step);
}

// Compares the corners of a frame, triangulated, with where the ground truth puts them later.
void Predict(const StereoCamera& camera, const RigidTransform& later_from_camera,
             const Corners& left, const std::vector<const OrbKeypoint*>& right,
             const std::vector<const OrbKeypoint*>& later, Sample& sample) {
  constexpr double kLeastDisparity_px = 1.0;
  std::vector<double> flows_px;
  std::array<std::vector<double>, 3> errors_px;  // as it is, and mirrored along x and y
  const std::array<RigidTransform, 3> motions = {later_from_camera, Mirrored(later_from_camera, 0),
                                                 Mirrored(later_from_camera, 1)};
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (right[i] == nullptr || later[i] == nullptr) continue;
    const double disparity_px = left[i].u_px - right[i]->u_px + camera.right_shift_px;
    if (disparity_px < kLeastDisparity_px) continue;
    const double depth_m = camera.fx * camera.baseline_m / disparity_px;
    const Eigen::Vector3d p_in_camera((left[i].u_px - camera.cx) * depth_m / camera.fx,
                                      (left[i].v_px - camera.cy) * depth_m / camera.fy, depth_m);
    flows_px.push_back((PixelOf(*later[i]) - PixelOf(left[i])).norm());
    for (std::size_t k = 0; k < motions.size(); ++k) {
      const Eigen::Vector3d p_in_later = motions[k] * p_in_camera;
      const Eigen::Vector2d predicted(camera.fx * p_in_later.x() / p_in_later.z() + camera.cx,
                                      camera.fy * p_in_later.y() / p_in_later.z() + camera.cy);
      errors_px[k].push_back(p_in_later.z() > 0.0 ? (PixelOf(*later[i]) - predicted).norm() : 1e9);
    }
  }
  if (flows_px.size() < kFewestMatches) return;
  sample.flow_px = Median(std::move(flows_px));
  sample.error_px = Median(std::move(errors_px[0]));
  sample.mirrored_px = std::min(Median(std::move(errors_px[1])), Median(std::move(errors_px[2])));
}

constexpr double kLeastFlow_px = 3.0;  // less tells nothing

// Of a few frames over the sequence, each compared with the one a tenth of a second later, or half
// a second where the camera moves slowly.
std::vector<Sample> SampleImages(const Sequence& sequence, double step_s) {
  constexpr std::size_t kSamples = 10;
  constexpr int kCorners = 1000;
  constexpr std::size_t kMany = 200;  // corners
  constexpr double kMostRows_px = 2.0;
  const std::size_t frames = sequence.images.size();
  const auto frames_in = [&](double time_s) {
    return static_cast<std::size_t>(std::max(1.0, std::round(time_s / step_s)));
  };
  const auto& truth = sequence.groundtruth_world_from_camera;
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < kSamples && frames > frames_in(0.1); ++k) {
    const std::size_t last = frames - 1 - frames_in(0.1);
    const std::size_t i = k * last / (kSamples - 1);
    if (k > 0 && i == (k - 1) * last / (kSamples - 1)) continue;
    Sample sample;
    sample.seen.frame = sequence.first_frame + static_cast<int>(i);
    sample.left = CornersOf(sequence, i, 0, kCorners);
    const Corners right = CornersOf(sequence, i, 1, kCorners);
    const std::vector<const OrbKeypoint*> partners = MatchAnywhere(sample.left, right);
    sample.dark = sample.left.empty() && !LoadFrameImage(sequence, i, 0).grey.empty();
    sample.both = std::min(sample.left.size(), right.size()) >= kMany;
    sample.pair = CheckPair(sample.left, partners);
    for (std::size_t c = 0; c < partners.size(); ++c) {
      sample.seen.corners.push_back(PixelOf(sample.left[c]));
      if (partners[c] == nullptr) continue;
      const Eigen::Vector2d apart_px = PixelOf(sample.left[c]) - PixelOf(*partners[c]);
      if (std::abs(apart_px.y()) > kMostRows_px) continue;
      sample.seen.points.emplace_back(sample.left[c].u_px, sample.left[c].v_px, apart_px.x());
    }
    if (sample.pair && sample.pair->disparity_px > 0.0) {
      sample.depth_m = sequence.camera.fx * sequence.camera.baseline_m / sample.pair->disparity_px;
    }
    for (const double apart_s : {0.1, 0.5}) {
      const std::size_t then = i + frames_in(apart_s);
      if (sample.flow_px >= kLeastFlow_px || then >= frames || !truth[i] || !truth[then]) break;
      const Corners later = CornersOf(sequence, then, 0, kCorners);
      const RigidTransform later_from_camera = truth[then]->Inverse() * *truth[i];
      Predict(sequence.camera, later_from_camera, sample.left, partners,
              MatchAnywhere(sample.left, later), sample);
      sample.still = truth[then]->Minus(*truth[i]).norm() == 0.0;
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

// Finds rotations that are all the same, as of a truth of positions alone.
void FindNoRotations(const Sequence& sequence, std::vector<std::string>& lines) {
  constexpr std::size_t kFewest = 20;
  std::vector<RigidTransform> poses;
  for (const auto& pose : sequence.groundtruth_world_from_camera) {
    if (pose) poses.push_back(*pose);
  }
  const auto same = [&](auto part) {
    return std::ranges::all_of(poses, [&](const RigidTransform& pose) {
      return (part(pose) - part(poses[0])).norm() == 0.0;
    });
  };
  if (poses.size() < kFewest || same([](const auto& pose) { return pose.translation(); }) ||
      !same([](const auto& pose) { return pose.rotation().coeffs(); })) {
    return;
  }
  lines.push_back("ground truth of the camera: it moves, but all its rotations are the same");
}

// Finds contradictions between images, calibration and ground truth, in the median of the samples.
void FindContradictions(const std::vector<Sample>& samples, std::vector<std::string>& lines) {
  constexpr double kMostRows_px = 1.0;
  constexpr double kNearest_m = 0.1;
  constexpr double kFarthest_m = 150.0;
  constexpr double kMostError = 0.35;  // part of the flow
  constexpr double kLeastMirrored_px = 0.4;
  constexpr double kMostMirrored = 0.6;  // part of the error
  std::vector<double> rows_px, depths_m, flows_px, errors, errors_px, mirrored_px;
  std::vector<std::string> problems;
  for (const Sample& sample : samples) {
    if (sample.pair) rows_px.push_back(sample.pair->row_error_px);
    if (sample.pair && !sample.pair->problem.empty()) problems.push_back(sample.pair->problem);
    if (sample.depth_m > 0.0) depths_m.push_back(sample.depth_m);
    if (sample.flow_px < kLeastFlow_px) continue;
    flows_px.push_back(sample.flow_px);
    errors.push_back(sample.error_px / sample.flow_px);
    errors_px.push_back(sample.error_px);
    mirrored_px.push_back(sample.mirrored_px);
  }
  const auto still = std::ranges::find_if(samples, [&](const Sample& sample) {
    return sample.still && sample.flow_px >= kLeastFlow_px;
  });
  if (still != samples.end()) {
    lines.push_back(StrCat("ground truth of the camera, frame ", still->seen.frame,
                           ": it stands still while points move by ",
                           FormatFixed(still->flow_px, 1), " px in the images"));
  }
  const auto most = [&](auto count) {
    return 2 * static_cast<std::size_t>(count) > samples.size();
  };
  const auto apart = std::ranges::count_if(
      samples, [](const Sample& sample) { return sample.both && !sample.pair; });
  const auto dark = std::ranges::count_if(samples, &Sample::dark);
  if (most(dark)) {
    lines.push_back(StrCat("images: ", dark, " of ", samples.size(), " looked at show no corner"));
  } else if (most(apart)) {
    lines.push_back("stereo pair: the left and right images show nothing in common");
  } else if (most(problems.size())) {
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
  } else if (most(errors.size()) && Median(mirrored_px) < kMostMirrored * Median(errors_px) &&
             Median(mirrored_px) < Median(errors_px) - kLeastMirrored_px) {
    lines.push_back(StrCat("ground truth of the camera: points end ",
                           FormatFixed(Median(errors_px), 1), " px from where it puts them, and ",
                           FormatFixed(Median(mirrored_px), 1), " px if it is mirrored"));
  }
}

}  // namespace

std::optional<PairCheck> CheckMiddlePair(const Sequence& sequence) {
  constexpr int kCorners = 1000;
  const std::size_t middle = sequence.images.size() / 2;
  const Corners left = CornersOf(sequence, middle, 0, kCorners);
  std::optional<PairCheck> pair =
      CheckPair(left, MatchAnywhere(left, CornersOf(sequence, middle, 1, kCorners)));
  if (pair) pair->frame = sequence.first_frame + static_cast<int>(middle);
  return pair;
}

void FindInImages(const Sequence& sequence, double step_s, std::vector<std::string>& lines) {
  constexpr double kDark = 64.0;
  double brightest = 255.0;
  if (!sequence.images.empty()) {
    const cv::Mat middle = LoadFrameImage(sequence, sequence.images.size() / 2, 0).grey;
    if (!middle.empty()) cv::minMaxLoc(middle, nullptr, &brightest);
  }
  if (brightest < kDark) {
    lines.push_back(StrCat("images: the brightest pixel of the middle one is ", brightest,
                           " of 255 (10 to 14 bits in files of 16: scale them to all 16)"));
  }
  std::vector<Sample> samples = SampleImages(sequence, step_s);
  FindContradictions(samples, lines);
  FindNoRotations(sequence, lines);
  std::vector<SeenFrame> frames;
  for (Sample& sample : samples) frames.push_back(std::move(sample.seen));
  FindMisplaced(sequence, frames, "detections", sequence.detections, lines);
  FindMisplaced(sequence, frames, "labels", sequence.labels, lines);
}

}  // namespace cvo
