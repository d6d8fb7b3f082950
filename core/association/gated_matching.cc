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

// Within this distance of its border, few corners are found in the right image.
constexpr double kRightBorder_px = 16.0;
// A covariance with a smaller pivot is too close to singular for a test.
constexpr double kMinPivot_px2 = 1e-9;

double SearchRadius(const auto& innovation_px2, const ClusterAssociationOptions& options) {
  const double variance_px2 = std::max(innovation_px2(0, 0), innovation_px2(1, 1));
  return std::min(std::sqrt(options.gamma * variance_px2), options.max_radius_px);
}

constexpr Match kNoMatch{-1, -1, 257};

// Returns the feature with the most similar descriptor among those that is_wanted and is_inside
// accept, or kNoMatch if it is not similar enough or not unique.
template <typename IsWanted, typename IsInside>
Match FindSimilar(const PredictedLandmark& landmark, const FeatureGrid& grid, double radius_px,
                  const ClusterAssociationOptions& options, IsWanted is_wanted,
                  IsInside is_inside) {
  Match best = kNoMatch;
  int second = kNoMatch.hamming;
  grid.VisitNear(landmark.zeta_px[0], landmark.zeta_px[1], radius_px, [&](int index) {
    const StereoFeature& feature = grid.features()[index];
    if (!is_wanted(index) || std::abs(feature.octave - landmark.octave) > 1) return;
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
  const bool is_unique = best.hamming < options.ratio * second;
  return best.hamming <= options.max_hamming && is_unique ? best : kNoMatch;
}

// Matches the landmarks one-to-one to the features that `find` returns for them.
template <typename Find>
std::vector<Match> FindOneToOne(std::span<const PredictedLandmark> landmarks,
                                const FeatureGrid& grid, Find find) {
  std::vector<Match> candidates;
  for (int i = 0; i < static_cast<int>(landmarks.size()); ++i) {
    Match match = find(landmarks[i]);
    match.landmark = i;
    if (match.feature >= 0) candidates.push_back(match);
  }
  return KeepOneToOne(std::move(candidates), static_cast<int>(landmarks.size()),
                      static_cast<int>(grid.features().size()));
}

// Returns a predicate for free features: left-only ones, or those that were also found in the right
// image.
auto IsFree(const FeatureGrid& grid, const std::vector<char>& is_taken, bool left_only) {
  return [&grid, &is_taken, left_only](int index) {
    return !is_taken[index] && IsLeftOnly(grid.features()[index]) == left_only;
  };
}

std::vector<Match> FindGated(std::span<const PredictedLandmark> landmarks, const FeatureGrid& grid,
                             const std::vector<char>& is_taken,
                             const ClusterAssociationOptions& options,
                             Eigen::Matrix3d PredictedLandmark::*covariance) {
  return FindOneToOne(landmarks, grid, [&](const PredictedLandmark& landmark) {
    const Eigen::Matrix3d& S = landmark.*covariance;
    const Eigen::LDLT<Eigen::Matrix3d> factor(S);
    if (!(factor.vectorD().minCoeff() > kMinPivot_px2)) return kNoMatch;
    return FindSimilar(landmark, grid, SearchRadius(S, options), options,
                       IsFree(grid, is_taken, false), [&](const Eigen::Vector3d& innovation) {
                         return innovation.dot(factor.solve(innovation)) < options.gamma;
                       });
  });
}

}  // namespace

void AddLeftOnlyMatches(std::span<const PredictedLandmark> landmarks, const FeatureGrid& grid,
                        const std::vector<char>& is_taken, const ClusterAssociationOptions& options,
                        std::vector<Match>& matches) {
  std::vector<char> is_matched(landmarks.size(), 0);
  for (const Match& match : matches) is_matched[match.landmark] = 1;
  const std::vector<Match> added =
      FindOneToOne(landmarks, grid, [&](const PredictedLandmark& landmark) {
        const bool is_found = is_matched[&landmark - landmarks.data()] != 0;
        if (is_found || landmark.zeta_px[2] > kRightBorder_px) return kNoMatch;
        const Eigen::Matrix2d S = landmark.innovation_px2.topLeftCorner<2, 2>();
        const Eigen::Matrix2d information = S.inverse();
        return FindSimilar(landmark, grid, SearchRadius(S, options), options,
                           IsFree(grid, is_taken, true), [&](const Eigen::Vector3d& innovation) {
                             const Eigen::Vector2d d = innovation.head<2>();
                             return d.dot(information * d) < options.gamma;
                           });
      });
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
  const double radius = options.fixed_radius_px;
  return FindOneToOne(landmarks, grid, [&](const PredictedLandmark& landmark) {
    return FindSimilar(landmark, grid, radius, options, IsFree(grid, is_taken, false),
                       [&](const Eigen::Vector3d& d) { return std::abs(d[2]) <= radius; });
  });
}

}  // namespace cvo
