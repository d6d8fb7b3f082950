// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What the images of a few frames contradict.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/association/matching.h"
#include "core/base/lists.h"
#include "core/features/orb/orb.h"
#include "core/files/text/number.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/plausibility.h"

namespace cvo {
namespace {

using Corners = std::vector<OrbKeypoint>;

// What is kept of an image: its corners and a smaller copy; empty if it cannot be decoded.
struct SeenImage {
  Corners corners;
  cv::Mat small;
  double brightest = 0.0;
};

SeenImage See(const Sequence& sequence, std::size_t index, int side) {
  SeenImage seen;
  const cv::Mat grey = LoadFrameImage(sequence, index, side).grey;
  if (grey.empty()) return seen;
  seen.corners = ExtractOrb(grey, {.features = 1000}).keypoints;
  const double scale = std::min(0.5, 640.0 / grey.cols);
  cv::resize(grey, seen.small, cv::Size(), scale, scale, cv::INTER_AREA);
  cv::minMaxLoc(grey, nullptr, &seen.brightest);
  return seen;
}

// Pixels of the left image with their disparities in the third coordinate.
std::vector<Eigen::Vector3d> DisparitiesOf(const cv::Mat& left, const cv::Mat& right,
                                           double scale) {
  constexpr int kMost_px = 64, kWindow_px = 11, kStep_px = 3;
  std::vector<Eigen::Vector3d> points;
  if (left.empty() || left.size() != right.size() || left.rows <= kMost_px) return points;
  cv::Mat left_wide, right_wide, disparities;  // so that some are found up to the left end
  cv::copyMakeBorder(left, left_wide, 0, 0, kMost_px, 0, cv::BORDER_REPLICATE);
  cv::copyMakeBorder(right, right_wide, 0, 0, kMost_px, 0, cv::BORDER_REPLICATE);
  const auto matcher = cv::StereoBM::create(kMost_px, kWindow_px);
  matcher->setUniquenessRatio(15);
  matcher->setDisp12MaxDiff(1);
  matcher->setSpeckleWindowSize(50);
  matcher->setSpeckleRange(32);
  matcher->compute(left_wide, right_wide, disparities);
  for (int v = 1; v < left.rows; v += kStep_px) {
    for (int u = 1; u < left.cols; u += kStep_px) {
      const int sixteenths = disparities.at<std::int16_t>(v, u + kMost_px);
      if (sixteenths >= 0) points.push_back(Eigen::Vector3d(u, v, sixteenths / 16.0) / scale);
    }
  }
  return points;
}

// For each corner of `from`, the one of `to` if each is clearly the most similar to the other; or
// null.
std::vector<const OrbKeypoint*> MatchAnywhere(const Corners& from, const Corners& to) {
  const auto match = [](const Corners& these, const Corners& those) {
    constexpr int kFarthest = 64;        // of 256 bits
    constexpr double kUniqueness = 0.8;  // best / second-best distance
    std::vector<Descriptor> descriptors;
    std::vector<StereoFeature> features;
    for (const OrbKeypoint& corner : these) descriptors.push_back(corner.descriptor);
    for (const OrbKeypoint& corner : those) features.emplace_back().descriptor = corner.descriptor;
    return MatchDescriptors(descriptors, features, kFarthest, kUniqueness);
  };
  std::vector<int> back(to.size(), -1);
  for (const Match& found : match(to, from)) back[found.landmark] = found.feature;
  std::vector<const OrbKeypoint*> partners(from.size(), nullptr);
  for (const Match& found : match(from, to)) {
    if (back[found.feature] == found.landmark) partners[found.landmark] = &to[found.feature];
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

constexpr double kLeastFlow_px = 3.0;  // less tells nothing

// What the images of a frame and a later one tell: medians over corners.
struct Sample {
  SeenFrame seen;
  bool dark = false;  // the left image is nearly black or has no corner
  bool rich = false;  // it has many corners
  std::optional<PairCheck> pair;
  double depth_m = 0.0;
  double flow_px = 0.0;  // of the left image
  // Of what depths and ground truth predict, over the motion that is not due to the camera's turns,
  // which would hide a wrong scale. A quarter of the points fits better: others may be on moving
  // bodies or matched wrongly. Empty: too little motion.
  std::optional<double> error;
  bool still = false;  // the ground truth has the same pose for both
};

// Compares the corners of a frame, triangulated, with where the ground truth puts them later.
// Points that it moves out of view were matched wrongly, if it is not far off: they count if `all`
// do.
void Predict(const StereoCamera& camera, const RigidTransform& later_from_camera, bool all,
             const Corners& left, const std::vector<const OrbKeypoint*>& right,
             const std::vector<const OrbKeypoint*>& later, Sample& sample) {
  constexpr double kLeastDisparity_px = 1.0;
  std::vector<double> flows_px, motions_px, errors;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (right[i] == nullptr || later[i] == nullptr) continue;
    const Eigen::Vector2d from = PixelOf(left[i]), to = PixelOf(*later[i]);
    const Eigen::Vector3d z_px(from.x(), from.y(), right[i]->u_px);
    if (camera.Disparity(z_px) < kLeastDisparity_px) continue;
    const Eigen::Vector3d p_in_camera = *camera.BackProject(z_px);
    const auto predicted = camera.Project(later_from_camera * p_in_camera);
    const auto turned = camera.Project(later_from_camera.rotation() * p_in_camera);
    if (!all && !(predicted && camera.InImage(predicted->x(), predicted->y()))) continue;
    flows_px.push_back((to - from).norm());
    constexpr double kBehind_px = 1e9;
    double error_px = kBehind_px, motion_px = kBehind_px;
    if (predicted && turned) {
      error_px = (to - predicted->head<2>()).norm();
      motion_px =
          std::max((to - turned->head<2>()).norm(), (*predicted - *turned).head<2>().norm());
    }
    motions_px.push_back(motion_px);
    if (motion_px >= kLeastFlow_px) errors.push_back(error_px / motion_px);
  }
  if (flows_px.size() < kFewestMatches) return;
  sample.flow_px = Median(std::move(flows_px));
  if (Median(std::move(motions_px)) < kLeastFlow_px) return;
  std::ranges::sort(errors);
  sample.error = errors[errors.size() / 4];
}

// Looks at frame i, and at one that is apart[0] frames later; at apart[1] if too little moves.
Sample SampleFrame(const Sequence& sequence, std::size_t i,
                   const std::array<std::size_t, 2>& apart) {
  constexpr std::size_t kMany = 200;  // corners
  constexpr double kDark = 64.0;
  const auto& truth = sequence.groundtruth_world_from_camera;
  Sample sample;
  sample.seen.frame = sequence.first_frame + static_cast<int>(i);
  const SeenImage left = See(sequence, i, 0);
  const SeenImage right = See(sequence, i, 1);
  const std::vector<const OrbKeypoint*> partners = MatchAnywhere(left.corners, right.corners);
  sample.dark = !left.small.empty() && (left.corners.empty() || left.brightest < kDark);
  sample.rich = left.corners.size() >= kMany;
  sample.pair = CheckPair(left.corners, partners);
  if (!sequence.detections.empty() || !sequence.labels.empty()) {
    const double scale = static_cast<double>(left.small.cols) / sequence.camera.width_px;
    sample.seen.points = DisparitiesOf(left.small, right.small, scale);
  }
  if (sample.pair && sample.pair->disparity_px > 0.0) {
    sample.depth_m = sequence.camera.fx * sequence.camera.baseline_m / sample.pair->disparity_px;
  }
  for (const bool first : {true, false}) {
    const std::size_t then = i + apart[first ? 0 : 1];
    if (sample.error || then >= sequence.images.size()) break;
    const Corners corners = See(sequence, then, 0).corners;
    const std::vector<const OrbKeypoint*> later = MatchAnywhere(left.corners, corners);
    if (first) sample.seen.later = sequence.first_frame + static_cast<int>(then);
    for (std::size_t c = 0; first && c < later.size(); ++c) {
      if (later[c]) sample.seen.moves.emplace_back(PixelOf(left.corners[c]), PixelOf(*later[c]));
    }
    if (!truth[i] || !truth[then]) break;
    const RigidTransform later_from_camera = truth[then]->Inverse() * *truth[i];
    Predict(sequence.camera, later_from_camera, first, left.corners, partners, later, sample);
    sample.still = truth[then]->Minus(*truth[i]).norm() == 0.0;
  }
  return sample;
}

// Of a few frames over the sequence, each compared with the one a tenth of a second later, or half
// a second where the camera moves slowly.
std::vector<Sample> SampleImages(const Sequence& sequence, double step_s) {
  constexpr std::size_t kSamples = 10;
  const auto frames_in = [&](double time_s) {
    return static_cast<std::size_t>(std::max(1.0, std::round(time_s / step_s)));
  };
  const std::array apart = {frames_in(0.1), frames_in(0.5)};
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < kSamples && sequence.images.size() > apart[0]; ++k) {
    const std::size_t last = sequence.images.size() - 1 - apart[0];
    const std::size_t i = k * last / (kSamples - 1);
    if (k > 0 && i == (k - 1) * last / (kSamples - 1)) continue;
    samples.push_back(SampleFrame(sequence, i, apart));
  }
  return samples;
}

// A small copy of a left image without its mean, as exposures vary; empty if it is damaged.
cv::Mat Outline(const Sequence& sequence, std::size_t index) {
  const double scale = std::min(0.125, 160.0 / sequence.camera.width_px);
  cv::Mat image = LoadFrameImage(sequence, index, 0).grey;
  if (image.empty()) return image;
  cv::resize(image, image, cv::Size(), scale, scale, cv::INTER_AREA);
  image.convertTo(image, CV_32F, 1.0, -cv::mean(image)[0]);
  return image;
}

constexpr double kMostBetter = 1.05;  // by which neighbours may differ less in another order

// Finds frames that are not in the order of time: of four in a row, neighbours would differ less in
// another order. Of a camera that does not move, all orders are about equally good.
void FindDisorder(const Sequence& sequence, const std::vector<Sample>& samples,
                  std::vector<std::string>& lines) {
  constexpr double kFewest = 3.0;
  double rows = 0.0, in_order = 0.0, given = 0.0, best = 0.0;
  for (const Sample& sample : samples) {
    const auto begin = static_cast<std::size_t>(sample.seen.frame - sequence.first_frame);
    std::vector<cv::Mat> row;
    for (std::size_t i = begin; i < std::min(begin + 4, sequence.images.size()); ++i) {
      row.push_back(Outline(sequence, i));
    }
    if (row.size() < 4 || std::ranges::any_of(row, &cv::Mat::empty)) continue;
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    std::vector<double> lengths;
    do {
      lengths.push_back(0.0);
      for (std::size_t i = 1; i < row.size(); ++i) {
        lengths.back() += cv::norm(row[order[i - 1]], row[order[i]], cv::NORM_L1);
      }
    } while (std::ranges::next_permutation(order).found);
    const double shortest = std::ranges::min(lengths);
    rows += 1.0;
    in_order += lengths[0] <= shortest ? 1.0 : 0.0;
    given += lengths[0];
    best += shortest;
  }
  if (rows < kFewest || 2.0 * in_order >= rows || given <= kMostBetter * best) return;
  lines.push_back(StrCat("images: in ", rows - in_order, " of ", rows,
                         " places, four frames in a row would differ less in another order"));
}

// Finds frames in the order of their numbers as text: 0, 1, 10, 11, ..., 2, 20. In ten places where
// that is not the order of the numbers, the next number would differ less than the next frame.
void FindTextOrder(const Sequence& sequence, std::vector<std::string>& lines) {
  for (const std::size_t first : {0, 1}) {
    std::vector<std::size_t> numbers(sequence.images.size());
    std::iota(numbers.begin(), numbers.end(), first);
    std::ranges::sort(numbers, {}, [](std::size_t number) { return std::to_string(number); });
    const auto frame_of = [&](std::size_t number) {
      return static_cast<std::size_t>(std::ranges::find(numbers, number) - numbers.begin());
    };
    double given = 0.0, better = 0.0;
    for (std::size_t k = first, looked = 0; k + 1 < first + numbers.size() && looked < 10; ++k) {
      const std::size_t frame = frame_of(k), next = frame_of(k + 1);
      if (next == frame + 1 || frame + 1 == numbers.size()) continue;
      ++looked;
      const cv::Mat at = Outline(sequence, frame);
      const cv::Mat after = Outline(sequence, frame + 1), instead = Outline(sequence, next);
      if (at.empty() || after.size() != at.size() || instead.size() != at.size()) continue;
      given += cv::norm(at, after, cv::NORM_L1);
      better += cv::norm(at, instead, cv::NORM_L1);
    }
    if (given <= kMostBetter * better) continue;
    lines.push_back(StrCat(
        "images: neighbours would differ by ", FormatFixed(100.0 * (1.0 - better / given), 0),
        " % less in the order of numbers (sorted as text: ", first, ", 10, 11, ...?)"));
    return;
  }
}

// Finds contradictions between images, calibration and ground truth, in the median of the samples.
void FindContradictions(const std::vector<Sample>& samples, std::vector<std::string>& lines) {
  constexpr double kMostRows_px = 1.0, kNearest_m = 0.1, kFarthest_m = 150.0;
  constexpr double kMostError = 0.15;  // part of the motion
  std::vector<double> rows_px, depths_m, flows_px, errors;
  std::vector<std::string> problems;
  for (const Sample& sample : samples) {
    if (sample.pair) rows_px.push_back(sample.pair->row_error_px);
    if (sample.pair && !sample.pair->problem.empty()) problems.push_back(sample.pair->problem);
    if (sample.depth_m > 0.0) depths_m.push_back(sample.depth_m);
    if (!sample.error) continue;
    flows_px.push_back(sample.flow_px);
    errors.push_back(*sample.error);
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
      samples, [](const Sample& sample) { return sample.rich && !sample.pair; });
  const auto dark = std::ranges::count_if(samples, &Sample::dark);
  if (most(dark)) {
    lines.push_back(StrCat("images: ", dark, " of ", samples.size(),
                           " looked at are nearly black or show no corner (10 to 14 bits in files "
                           "of 16: scale them to all 16)"));
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
  } else if (3 * errors.size() > samples.size() && Median(errors) > kMostError) {
    lines.push_back(StrCat("ground truth of the camera: points move by ",
                           FormatFixed(Median(flows_px), 1), " px in the images, and most end ",
                           FormatFixed(100.0 * Median(errors), 0),
                           " % of their way or more from where it puts them (another scale, order "
                           "or clock, or a wrong baseline?)"));
  }
}

}  // namespace

std::optional<PairCheck> CheckMiddlePair(const Sequence& sequence) {
  const std::size_t middle = sequence.images.size() / 2;
  const Corners left = See(sequence, middle, 0).corners;
  const Corners right = See(sequence, middle, 1).corners;
  std::optional<PairCheck> pair = CheckPair(left, MatchAnywhere(left, right));
  if (pair) pair->frame = sequence.first_frame + static_cast<int>(middle);
  return pair;
}

void FindInImages(const Sequence& sequence, double step_s, std::vector<std::string>& lines) {
  std::vector<Sample> samples = SampleImages(sequence, step_s);
  FindContradictions(samples, lines);
  FindDisorder(sequence, samples, lines);
  FindTextOrder(sequence, lines);
  std::vector<SeenFrame> frames;
  for (Sample& sample : samples) frames.push_back(std::move(sample.seen));
  FindMisplaced(sequence, frames, "detections", sequence.detections, lines);
  FindMisplaced(sequence, frames, "labels", sequence.labels, lines);
}

}  // namespace cvo
