// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/gated_matching.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/features/descriptor.h"

namespace cvo {
namespace {

// Within this distance of its border the right image shows few corners.
constexpr double kRightBorder_px = 16.0;
// Below this pivot, px^2, a covariance says nothing that could be tested.
constexpr double kMinPivot_px2 = 1e-9;

double SearchRadius(const auto& innovation_px2, const ClusterAssociationOptions& options) {
  const double variance_px2 = std::max(innovation_px2(0, 0), innovation_px2(1, 1));
  return std::clamp(std::sqrt(options.gamma * variance_px2), options.min_radius_px,
                    options.max_radius_px);
}

// The unique most similar feature that is_inside accepts, or -1.
template <typename IsInside>
Match FindSimilar(const PredictedLandmark& landmark, const FeatureGrid& grid,
                  const std::vector<char>& is_taken, double radius_px,
                  const ClusterAssociationOptions& options, IsInside is_inside) {
  Match best{-1, -1, 257};
  int second = 257;
  grid.VisitNear(landmark.zeta_px[0], landmark.zeta_px[1], radius_px, [&](int index) {
    const StereoFeature& feature = grid.features()[index];
    if (is_taken[index] || std::abs(feature.octave - landmark.octave) > 1) return;
    if (!is_inside(feature.z_px - landmark.zeta_px)) return;
    const int hamming = HammingDistance(feature.descriptor, landmark.descriptor);
    if (hamming < best.hamming) {
      second = best.hamming;
      best.hamming = hamming;
      best.feature = index;
    } else {
      second = std::min(second, hamming);
    }
  });
  if (best.hamming > options.max_hamming || best.hamming >= options.ratio * second) {
    best.feature = -1;
  }
  return best;
}

std::vector<Match> FindGated(std::span<const PredictedLandmark> landmarks, const FeatureGrid& grid,
                             const std::vector<char>& is_taken,
                             const ClusterAssociationOptions& options,
                             Eigen::Matrix3d PredictedLandmark::*covariance) {
  std::vector<Match> candidates;
  for (int i = 0; i < static_cast<int>(landmarks.size()); ++i) {
    const Eigen::Matrix3d& S = landmarks[i].*covariance;
    const Eigen::LDLT<Eigen::Matrix3d> factor(S);
    if (!(factor.vectorD().minCoeff() > kMinPivot_px2)) continue;
    Match match = FindSimilar(landmarks[i], grid, is_taken, SearchRadius(S, options), options,
                              [&](const Eigen::Vector3d& innovation) {
                                return innovation.dot(factor.solve(innovation)) < options.gamma;
                              });
    match.landmark = i;
    if (match.feature >= 0) candidates.push_back(match);
  }
  return KeepOneToOne(std::move(candidates), static_cast<int>(landmarks.size()),
                      static_cast<int>(grid.features().size()));
}

}  // namespace

void AddLeftOnlyMatches(std::span<const PredictedLandmark> landmarks, const FeatureGrid& grid,
                        const ClusterAssociationOptions& options, std::vector<Match>& matches) {
  std::vector<char> is_matched(landmarks.size(), 0);
  for (const Match& match : matches) is_matched[match.landmark] = 1;
  std::vector<char> has_disparity;
  for (const StereoFeature& feature : grid.features())
    has_disparity.push_back(!IsLeftOnly(feature));
  std::vector<Match> candidates;
  for (int i = 0; i < static_cast<int>(landmarks.size()); ++i) {
    if (is_matched[i] || landmarks[i].zeta_px[2] > kRightBorder_px) continue;
    const Eigen::Matrix2d S = landmarks[i].innovation_px2.topLeftCorner<2, 2>();
    const Eigen::Matrix2d information = S.inverse();
    Match match = FindSimilar(landmarks[i], grid, has_disparity, SearchRadius(S, options), options,
                              [&](const Eigen::Vector3d& innovation) {
                                const Eigen::Vector2d d = innovation.head<2>();
                                return d.dot(information * d) < options.gamma;
                              });
    match.landmark = i;
    if (match.feature >= 0) candidates.push_back(match);
  }
  const std::vector<Match> added =
      KeepOneToOne(std::move(candidates), static_cast<int>(landmarks.size()),
                   static_cast<int>(grid.features().size()));
  matches.insert(matches.end(), added.begin(), added.end());
}

std::vector<Match> ProbabilisticAssociation::Find(std::span<const PredictedLandmark> landmarks,
                                                  const FeatureGrid& grid,
                                                  const std::vector<char>& is_taken,
                                                  const ClusterAssociationOptions& options) {
  return FindGated(landmarks, grid, is_taken, options, &PredictedLandmark::innovation_px2);
}

std::vector<Match> ProbabilisticAssociationLiteral::Find(
    std::span<const PredictedLandmark> landmarks, const FeatureGrid& grid,
    const std::vector<char>& is_taken, const ClusterAssociationOptions& options) {
  return FindGated(landmarks, grid, is_taken, options, &PredictedLandmark::position_px2);
}

std::vector<Match> FixedRadiusAssociation::Find(std::span<const PredictedLandmark> landmarks,
                                                const FeatureGrid& grid,
                                                const std::vector<char>& is_taken,
                                                const ClusterAssociationOptions& options) {
  std::vector<Match> candidates;
  const double radius = options.fixed_radius_px;
  for (int i = 0; i < static_cast<int>(landmarks.size()); ++i) {
    Match match = FindSimilar(landmarks[i], grid, is_taken, radius, options,
                              [&](const Eigen::Vector3d& d) { return std::abs(d[2]) <= radius; });
    match.landmark = i;
    if (match.feature >= 0) candidates.push_back(match);
  }
  return KeepOneToOne(std::move(candidates), static_cast<int>(landmarks.size()),
                      static_cast<int>(grid.features().size()));
}

}  // namespace cvo
