// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What the images of a few frames contradict.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/lists.h"
#include "core/base/task_pool.h"
#include "core/files/text/number.h"
#include "experiments/datasets/plausibility.h"
#include "experiments/datasets/plausible_pair.h"

namespace cvo {
namespace {

// What makes an image useless; empty for one that cannot be decoded, which is told elsewhere.
std::string LackOf(const SeenImage& seen) {
  constexpr double kDark = 64.0, kWhite = 254.0, kMostWhite = 0.5;
  if (seen.small.empty()) return "";
  if (seen.brightest < kDark || seen.corners.empty()) {
    return "are nearly black or show no corner (10 to 14 bits in files of 16: scale them to all "
           "16)";
  }
  if (cv::countNonZero(seen.small >= kWhite) > kMostWhite * static_cast<double>(seen.small.total()))
    return "are nearly white (overexposed?)";
  return "";
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

constexpr double kLeastFlow_px = 3.0;  // less tells nothing
constexpr double kLeastMove_px = 8.0;  // of corners in boxes, which detectors place less well

// What the images of a frame and a later one tell: medians over corners.
struct Sample {
  std::size_t index = 0;  // in the sequence
  Corners left;
  SeenFrame seen;
  std::string lack;     // of the left image
  bool rich = false;    // it has many corners
  bool sparse = false;  // it has few
  std::optional<PairCheck> pair;
  double depth_m = 0.0;
  double flow_px = 0.0;  // of the left image
  // Of what depths and ground truth predict, over the motion that is not due to the camera's turns,
  // which would hide a wrong scale. A quarter of the points fits better: others may be on moving
  // bodies or matched wrongly. Empty: too little motion.
  std::optional<double> error;
  bool still = false;        // the ground truth has the same pose for both
  bool upside_down = false;  // what is seen below is farther than what is seen above
};

// Whether points in the lowest third of the image have smaller disparities than those in the
// highest third.
bool IsUpsideDown(const Corners& left, const std::vector<const OrbKeypoint*>& right,
                  int height_px) {
  constexpr std::size_t kFewest = 10;
  constexpr double kMost = 0.8;
  std::vector<double> above_px, below_px;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (right[i] == nullptr) continue;
    const double disparity_px = left[i].u_px - right[i]->u_px;
    if (3.0 * left[i].v_px < height_px) above_px.push_back(disparity_px);
    if (3.0 * left[i].v_px > 2.0 * height_px) below_px.push_back(disparity_px);
  }
  if (std::min(above_px.size(), below_px.size()) < kFewest) return false;
  const double above = Median(std::move(above_px));
  return above > 0.0 && Median(std::move(below_px)) < kMost * above;
}

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

double MedianMove_px(const SeenFrame& seen) {
  std::vector<double> moves_px;
  for (const auto& [from, to] : seen.moves) moves_px.push_back((to - from).norm());
  return moves_px.empty() ? 0.0 : Median(std::move(moves_px));
}

// Looks at frame i, and at one that is apart[0] frames later; at apart[1] if too little moves.
Sample SampleFrame(const Sequence& sequence, std::size_t i,
                   const std::array<std::size_t, 2>& apart) {
  constexpr std::size_t kMany = 200, kFew = 350;  // corners
  const auto& truth = sequence.groundtruth_world_from_camera;
  Sample sample;
  sample.index = i;
  sample.seen.frame = sequence.first_frame + static_cast<int>(i);
  SeenImage left = See(sequence, i, 0);
  const SeenImage right = See(sequence, i, 1);
  const std::vector<const OrbKeypoint*> partners = MatchAnywhere(left.corners, right.corners);
  sample.lack = LackOf(left);
  sample.rich = left.corners.size() >= kMany;
  sample.sparse = !left.small.empty() && left.corners.size() < kFew;
  sample.pair = CheckPair(left.corners, partners);
  sample.upside_down = IsUpsideDown(left.corners, partners, sequence.camera.height_px);
  const bool boxes = !sequence.detections.empty() || !sequence.labels.empty();
  if (boxes) {
    const double scale = static_cast<double>(left.small.cols) / sequence.camera.width_px;
    sample.seen.points = DisparitiesOf(left.small, right.small, scale);
  }
  if (sample.pair && sample.pair->disparity_px > 0.0) {
    sample.depth_m = sequence.camera.fx * sequence.camera.baseline_m / sample.pair->disparity_px;
  }
  for (const bool first : {true, false}) {
    const std::size_t then = i + apart[first ? 0 : 1];
    const bool predict = !sample.error && truth[i];
    const bool follow = boxes && MedianMove_px(sample.seen) < kLeastMove_px;
    if (then >= sequence.images.size() || !(predict || follow)) break;
    const Corners corners = See(sequence, then, 0).corners;
    const std::vector<const OrbKeypoint*> later = MatchAnywhere(left.corners, corners);
    if (follow) {
      sample.seen.later = sequence.first_frame + static_cast<int>(then);
      sample.seen.moves.clear();
      for (std::size_t c = 0; c < later.size(); ++c) {
        if (later[c]) sample.seen.moves.emplace_back(PixelOf(left.corners[c]), PixelOf(*later[c]));
      }
    }
    if (!predict || !truth[then]) continue;
    const RigidTransform later_from_camera = truth[then]->Inverse() * *truth[i];
    Predict(sequence.camera, later_from_camera, first, left.corners, partners, later, sample);
    sample.still = truth[then]->Minus(*truth[i]).norm() == 0.0;
  }
  sample.left = std::move(left.corners);
  return sample;
}

// Of a few frames over the sequence, each compared with the one a tenth of a second later, or half
// a second where the camera moves slowly.
std::vector<Sample> SampleImages(const Sequence& sequence, double step_s, int threads) {
  constexpr std::size_t kSamples = 10;
  const auto frames_in = [&](double time_s) {
    return static_cast<std::size_t>(std::max(1.0, std::round(time_s / step_s)));
  };
  const std::array apart = {frames_in(0.1), frames_in(0.5)};
  std::vector<std::size_t> frames;
  for (std::size_t k = 0; k < kSamples && sequence.images.size() > apart[0]; ++k) {
    const std::size_t last = sequence.images.size() - 1 - apart[0];
    const std::size_t i = k * last / (kSamples - 1);
    if (frames.empty() || frames.back() != i) frames.push_back(i);
  }
  std::vector<Sample> samples(frames.size());
  TaskPool(threads).ParallelFor(static_cast<int>(frames.size()), [&](int k) {
    samples[k] = SampleFrame(sequence, frames[k], apart);
  });
  return samples;
}

constexpr std::size_t kFewestSamples = 5;

// How much smaller row errors of a sample are with the right image of the frame before (k = 0) or
// of the next one.
std::optional<double> GainOf(const Sequence& sequence, const Sample& sample, std::size_t k) {
  const std::size_t beside = sample.index + 2 * k - 1;
  if (!sample.pair || beside >= sequence.images.size()) return std::nullopt;
  const auto other =
      CheckPair(sample.left, MatchAnywhere(sample.left, See(sequence, beside, 1).corners));
  if (!other) return std::nullopt;
  return sample.pair->row_error_px - other->row_error_px;
}

// Describes right images that are of other frames: some samples in a row have smaller row errors
// with those of the frame before, or of the next one. Empty: there are none.
std::string DescribeLate(const Sequence& sequence, const std::vector<Sample>& samples) {
  constexpr double kLeast_px = 0.02;
  for (const std::size_t k : {0, 1}) {
    std::vector<double> gains_px;
    const auto is_better = [&](const Sample& sample) {
      const std::optional<double> gain_px = GainOf(sequence, sample, k);
      if (!gain_px || *gain_px <= 0.0) return false;
      gains_px.push_back(*gain_px);
      return true;
    };
    // Looks for kFewestSamples in a row from the last of them: of good images, few are looked at.
    for (std::size_t begin = 0; begin + kFewestSamples <= samples.size();) {
      gains_px.clear();
      std::size_t i = begin + kFewestSamples;
      while (i > begin && is_better(samples[i - 1])) --i;
      if (i > begin) {
        begin = i;
        continue;
      }
      for (i = begin + kFewestSamples; i < samples.size() && is_better(samples[i]);) ++i;
      if (Median(gains_px) >= kLeast_px) {
        return StrCat("stereo pair: in ", gains_px.size(), " of ", samples.size(),
                      " places, rows differ by ", FormatFixed(Median(gains_px), 2),
                      " px less with the right image of the frame ", k == 0 ? "before" : "after",
                      " (right images of other frames?)");
      }
      begin = i + 1;
    }
  }
  return "";
}

// Finds contradictions between images, calibration and ground truth, in the median of the samples.
void FindContradictions(const Sequence& sequence, const std::vector<Sample>& samples,
                        std::vector<std::string>& lines) {
  constexpr double kMostRows_px = 1.0, kNearest_m = 0.1, kFarthest_m = 150.0;
  constexpr double kMostError = 0.15;  // part of the motion
  std::vector<double> depths_m, flows_px, errors;
  std::ptrdiff_t apart_in_rows = 0;
  std::vector<std::string> problems;
  for (const Sample& sample : samples) {
    apart_in_rows += sample.pair && sample.pair->row_error_px > kMostRows_px;
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
  std::map<std::string, std::ptrdiff_t> lacks;
  for (const Sample& sample : samples) ++lacks[sample.lack];
  lacks.erase("");
  const auto lack = std::ranges::max_element(lacks, {}, [](const auto& l) { return l.second; });
  const auto upside_down = std::ranges::count_if(samples, &Sample::upside_down);
  if (lack != lacks.end()) {
    lines.push_back(
        StrCat("images: ", lack->second, " of ", samples.size(), " looked at ", lack->first));
  } else if (const auto sparse = std::ranges::count_if(samples, &Sample::sparse); most(sparse)) {
    lines.push_back(StrCat("images: ", sparse, " of ", samples.size(),
                           " looked at show few corners (out of focus, or nothing to see?)"));
  } else if (most(apart)) {
    lines.push_back("stereo pair: the left and right images show nothing in common");
  } else if (5 * problems.size() > samples.size()) {
    lines.push_back(StrCat("stereo pair: in ", problems.size(), " of ", samples.size(), " places, ",
                           problems[0]));
  } else if (const std::string late = DescribeLate(sequence, samples); !late.empty()) {
    lines.push_back(late);
  } else if (5 * apart_in_rows > std::ssize(samples)) {
    lines.push_back(StrCat("stereo pair: in ", apart_in_rows, " of ", samples.size(),
                           " places, points lie more than ", kMostRows_px,
                           " px apart in rows (right images of other frames, or not rectified?)"));
  } else if (samples.size() >= kFewestSamples && upside_down + 1 >= std::ssize(samples)) {
    lines.push_back(StrCat("images: in ", upside_down, " of ", samples.size(),
                           " looked at, what is below is farther than what is above (upside "
                           "down?)"));
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

void FindInImages(const Sequence& sequence, double step_s, int threads,
                  std::vector<std::string>& lines) {
  std::vector<Sample> samples = SampleImages(sequence, step_s, threads);
  FindContradictions(sequence, samples, lines);
  FindDisorder(sequence, lines);
  std::vector<SeenFrame> frames;
  for (Sample& sample : samples) frames.push_back(std::move(sample.seen));
  FindMisplaced(sequence, frames, "detections", sequence.detections, lines);
  FindMisplaced(sequence, frames, "labels", sequence.labels, lines);
}

}  // namespace cvo
