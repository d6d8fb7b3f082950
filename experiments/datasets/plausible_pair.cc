// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/plausible_pair.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/base/lists.h"
#include "core/features/descriptor.h"
#include "experiments/datasets/images.h"

namespace cvo {

SeenImage See(const Sequence& sequence, std::size_t index, int side) {
  SeenImage seen;
  const cv::Mat grey = LoadFrameImage(sequence, index, side).grey;
  if (grey.empty()) return seen;
  // Whatever the estimator uses: with more corners of fine levels, some match by chance.
  seen.corners = ExtractOrb(grey, {.features = 1000, .levels = 8}).keypoints;
  const double scale = std::min(0.5, 640.0 / grey.cols);
  cv::resize(grey, seen.small, cv::Size(), scale, scale, cv::INTER_AREA);
  cv::minMaxLoc(grey, nullptr, &seen.brightest);
  return seen;
}

namespace {

// The most similar of the corners offered.
struct MostSimilar {
  int corner = -1;
  int distance = 257;
  int second = 257;

  void Offer(int other, int other_distance) {
    if (other_distance < distance) {
      second = std::exchange(distance, other_distance);
      corner = other;
    } else {
      second = std::min(second, other_distance);
    }
  }
  bool IsClear() const {
    constexpr int kFarthest = 64;        // of 256 bits
    constexpr double kUniqueness = 0.8;  // best / second-best distance
    return distance <= kFarthest && distance < kUniqueness * second;
  }
};

}  // namespace

std::vector<const OrbKeypoint*> MatchAnywhere(const Corners& from, const Corners& to) {
  std::vector<Descriptor> descriptors;
  for (const OrbKeypoint& corner : to) descriptors.push_back(corner.descriptor);
  std::vector<int> distances(to.size());
  std::vector<MostSimilar> there(from.size()), back(to.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    HammingDistances(from[i].descriptor, descriptors, distances);
    for (std::size_t k = 0; k < to.size(); ++k) {
      there[i].Offer(static_cast<int>(k), distances[k]);
      back[k].Offer(static_cast<int>(i), distances[k]);
    }
  }
  std::vector<const OrbKeypoint*> partners(from.size(), nullptr);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!there[i].IsClear()) continue;
    const MostSimilar& other = back[there[i].corner];
    if (other.IsClear() && other.corner == static_cast<int>(i)) partners[i] = &to[there[i].corner];
  }
  return partners;
}

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

std::optional<PairCheck> CheckMiddlePair(const Sequence& sequence) {
  const std::size_t middle = sequence.images.size() / 2;
  const Corners left = See(sequence, middle, 0).corners;
  const Corners right = See(sequence, middle, 1).corners;
  std::optional<PairCheck> pair = CheckPair(left, MatchAnywhere(left, right));
  if (pair) pair->frame = sequence.first_frame + static_cast<int>(middle);
  return pair;
}

}  // namespace cvo
