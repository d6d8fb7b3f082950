// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/features/front_end.h"
#include "experiments/scene_check/checks.h"
#include "experiments/scene_check/limits.h"

namespace cvo {
namespace {

struct FrameFeatures {
  int matches = 0;
  std::vector<int> on_body;                // [id - 1], on matchable pixels
  std::vector<int> matchable_px;           // [id - 1]
  std::vector<float> disparity_errors_px;  // signed, matched - true
  std::vector<double> foreign;  // [visible box with enough matches]: fraction not on its body
};

// Returns 255 where a stereo match is possible, else 0: both cameras see the pixel, it is no nearer
// to the edges of their images than a descriptor reaches, and what surrounds it is of the same
// body, as a corner that spans two depths has no match.
cv::Mat FindMatchable(const StereoCamera& camera, const cv::Mat& depth, const cv::Mat& instances) {
  const int border = limits::kDescriptorBorder_px;
  const int side = 2 * limits::kCornerRadius_px + 1;
  cv::Mat lowest, highest;
  cv::erode(instances, lowest, cv::Mat::ones(side, side, CV_8U));
  cv::dilate(instances, highest, cv::Mat::ones(side, side, CV_8U));
  cv::Mat matchable = cv::Mat::zeros(depth.size(), CV_8U);
  for (int v = border; v < depth.rows - border; ++v) {
    for (int u = border; u < depth.cols - border; ++u) {
      const double disparity_px = camera.fx * camera.baseline_m / depth.at<float>(v, u);
      const bool within = lowest.at<std::uint16_t>(v, u) == highest.at<std::uint16_t>(v, u);
      if (within && u - disparity_px >= border) matchable.at<std::uint8_t>(v, u) = 255;
    }
  }
  return matchable;
}

std::vector<int> CountBodies(const cv::Mat& instances, const cv::Mat& mask, std::size_t bodies) {
  std::vector<int> counts(bodies);
  for (int v = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u) {
      const std::size_t body = instances.at<std::uint16_t>(v, u);
      if (body > 0 && body <= bodies && mask.at<std::uint8_t>(v, u) != 0) ++counts[body - 1];
    }
  }
  return counts;
}

// Returns the fraction of the matches in the body's visible box that are not on the body. Empty if
// there are too few of them, or no visible box.
std::optional<double> ForeignPart(const std::vector<StereoFeature>& features,
                                  const cv::Mat& instances, const SceneBody& body) {
  if (!body.visible_box) return std::nullopt;
  int inside = 0;
  int own = 0;
  for (const StereoFeature& feature : features) {
    const double u = feature.z_px[0];
    const double v = feature.z_px[1];
    if (u < body.visible_box->left_px || u > body.visible_box->right_px ||
        v < body.visible_box->top_px || v > body.visible_box->bottom_px) {
      continue;
    }
    ++inside;
    const auto id = instances.at<std::uint16_t>(static_cast<int>(std::lround(v)),
                                                static_cast<int>(std::lround(u)));
    if (id == body.id) ++own;
  }
  if (inside < limits::kMinBoxMatches) return std::nullopt;
  return 1.0 - static_cast<double>(own) / inside;
}

FrameFeatures FindFeatures(const SceneFolder& scene, int frame, TaskPool& pool) {
  const auto index = static_cast<std::size_t>(frame);
  const StereoPaths& paths = scene.sequence.images[index];
  const StereoCamera& camera = scene.sequence.camera;
  const std::vector<StereoFeature> features =
      ExtractStereoFeatures(ReadGrey(paths.left), ReadGrey(paths.right), camera,
                            OrbOptions{.reserve = 0.0}, StereoMatchOptions(), pool);
  const cv::Mat depth = scene.Depth(frame);
  const cv::Mat instances = scene.Instances(frame);
  FrameFeatures result;
  result.matches = static_cast<int>(features.size());
  result.on_body.resize(scene.bodies[index].size());
  const cv::Mat matchable = FindMatchable(camera, depth, instances);
  result.matchable_px = CountBodies(instances, matchable, result.on_body.size());
  for (const StereoFeature& feature : features) {
    const int u = static_cast<int>(std::lround(feature.z_px[0]));
    const int v = static_cast<int>(std::lround(feature.z_px[1]));
    if (u < 0 || v < 0 || u >= depth.cols || v >= depth.rows) continue;
    const std::size_t body = instances.at<std::uint16_t>(v, u);
    if (body > 0 && body <= result.on_body.size() && matchable.at<std::uint8_t>(v, u) != 0) {
      ++result.on_body[body - 1];
    }
    const double z_m = depth.at<float>(v, u);
    if (z_m > 0.0) {
      const double true_px = camera.fx * camera.baseline_m / z_m;
      result.disparity_errors_px.push_back(
          static_cast<float>(camera.Disparity(feature.z_px) - true_px));
    }
  }
  for (const SceneBody& body : scene.bodies[index]) {
    const std::optional<double> part = ForeignPart(features, instances, body);
    if (part) result.foreign.push_back(*part);
  }
  return result;
}

float MedianOf(std::vector<float> values) {
  if (values.empty()) return std::numeric_limits<float>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<SceneCheck> CheckDisparities(const std::vector<FrameFeatures>& results) {
  std::vector<float> errors;
  for (const FrameFeatures& result : results) {
    errors.insert(errors.end(), result.disparity_errors_px.begin(),
                  result.disparity_errors_px.end());
  }
  const double bias_px = MedianOf(errors);
  for (float& error : errors) error = std::abs(error);
  return {{"match_disparity_bias", std::abs(bias_px), "px", Bound::kAtMost,
           limits::kMatchDisparityBias_px, ""},
          {"match_disparity_median", MedianOf(errors), "px", Bound::kAtMost,
           limits::kMatchDisparity_px, ""}};
}

struct MoverMatches {
  double matches = 0.0;
  double pixels = 0.0;
  std::string name;
};

// Reports the matches per pixel of the mover that has the fewest over all its frames, and those of
// the worst single frame. Uses only frames in which enough of the mover is visible and next to
// nothing of it is occluded: the visible part of an occluded body is mostly edges, where patches
// contain both surfaces.
std::vector<SceneCheck> CheckMovers(const SceneFolder& scene,
                                    const std::vector<FrameFeatures>& results) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  SceneCheck least = {"mover_matches_per_200_px", kNone, "matches", Bound::kAtLeast, 1.0,
                      "no mover is large enough"};
  SceneCheck worst = {"the_same_in_one_frame", kNone, "matches", Bound::kNone, 0.0, ""};
  std::map<int, MoverMatches> movers;  // by id
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto frame = static_cast<std::size_t>(scene.image_frames[i]);
    for (const SceneBody& body : scene.bodies[frame]) {
      const auto at = static_cast<std::size_t>(body.id) - 1;
      const int pixels = results[i].matchable_px[at];
      if (pixels < limits::kMinMoverPixels ||
          body.visible_fraction < limits::kMinUnoccludedFraction ||
          !IsMover(scene.bodies, body.id)) {
        continue;
      }
      const int matches = results[i].on_body[at];
      MoverMatches& mover = movers[body.id];
      mover.name = body.name;
      mover.matches += matches;
      mover.pixels += pixels;
      const double figure = limits::kPixelsPerMatch * matches / pixels;
      if (figure >= worst.figure) continue;
      worst.figure = figure;
      worst.where = StrCat(body.name, ", frame ", frame, ": ", matches, " on ", pixels, " px");
    }
  }
  for (const auto& [id, mover] : movers) {
    const double figure = limits::kPixelsPerMatch * mover.matches / mover.pixels;
    if (figure >= least.figure) continue;
    least.figure = figure;
    least.where = mover.name;
  }
  if (movers.empty()) return {least};
  return {least, worst};
}

}  // namespace

std::vector<SceneCheck> CheckFeatures(const SceneFolder& scene, TaskPool& pool) {
  const std::vector<FrameFeatures> results =
      ForAll<FrameFeatures>(static_cast<int>(scene.image_frames.size()), pool, [&](int i) {
        TaskPool alone(1);  // a task must not wait on the pool that runs it
        return FindFeatures(scene, scene.image_frames[static_cast<std::size_t>(i)], alone);
      });
  SceneCheck fewest = {
      "matches_fewest", std::numeric_limits<double>::infinity(), "matches", Bound::kNone, 0.0, ""};
  int enough = 0;
  std::vector<double> foreign;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].matches >= limits::kMatches) ++enough;
    foreign.insert(foreign.end(), results[i].foreign.begin(), results[i].foreign.end());
    if (results[i].matches >= fewest.figure) continue;
    fewest.figure = results[i].matches;
    fewest.where = StrCat("frame ", scene.image_frames[i]);
  }
  std::vector<SceneCheck> checks = {
      {"frames_with_600_matches", enough / static_cast<double>(results.size()), "of frames",
       Bound::kAtLeast, limits::kFramesWithMatches, ""},
      fewest};
  for (SceneCheck& check : CheckMovers(scene, results)) checks.push_back(std::move(check));
  for (SceneCheck& check : CheckDisparities(results)) checks.push_back(std::move(check));
  const double sum = std::accumulate(foreign.begin(), foreign.end(), 0.0);
  checks.push_back({"foreign_matches_in_boxes",
                    foreign.empty() ? 0.0 : sum / static_cast<double>(foreign.size()), "of matches",
                    Bound::kNone, 0.0, "mean over boxes"});
  return checks;
}

}  // namespace cvo
