// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <span>
#include <vector>

#include "core/association/cluster_association_options.h"
#include "core/association/feature_grid.h"
#include "core/association/match.h"

namespace cvo {

// A landmark of a cluster at its position in the current frame, as predicted from the motion of the
// cluster.
struct PredictedLandmark {
  Eigen::Vector3d zeta_px = Eigen::Vector3d::Zero();              // (u_left, v, u_right)
  Eigen::Matrix3d position_px2 = Eigen::Matrix3d::Identity();     // Gamma, of its position only
  Eigen::Matrix3d measurement_px2 = Eigen::Matrix3d::Identity();  // Sigma_z of a feature there
  Eigen::Matrix3d innovation_px2 = Eigen::Matrix3d::Identity();   // S, of feature minus prediction
  int octave = 0;
  Descriptor descriptor{};
};

// Matches landmarks to the left of the field of view of the right image (METHOD.md 4.7) to
// left-only features: the most similar descriptor within the gate on (u_left, v); unique and
// one-to-one. Ignores features with is_taken and landmarks that are already in `matches`, and
// appends to `matches`.
void AddLeftOnlyMatches(std::span<const PredictedLandmark> landmarks, const FeatureGrid& grid,
                        const std::vector<char>& is_taken, const ClusterAssociationOptions& options,
                        std::vector<Match>& matches);

// Finds features for predicted landmarks (Eq. 2 of the paper): the most similar descriptor among
// the features within the gate; unique and one-to-one. Ignores left-only features and those with
// is_taken.
template <typename Policy>
concept LandmarkAssociationPolicy = requires(std::span<const PredictedLandmark> landmarks,
                                             const FeatureGrid& grid,
                                             const std::vector<char>& is_taken,
                                             const ClusterAssociationOptions& options) {
  { Policy::Find(landmarks, grid, is_taken, options) } -> std::same_as<std::vector<Match>>;
};

// Policy: gates the Mahalanobis distance under the innovation covariance (METHOD.md 4.2).
struct ProbabilisticAssociation {
  static std::vector<Match> Find(std::span<const PredictedLandmark> landmarks,
                                 const FeatureGrid& grid, const std::vector<char>& is_taken,
                                 const ClusterAssociationOptions& options);
};
// Policy: as printed in the paper, under the covariance of the position of the landmark only.
struct ProbabilisticAssociationLiteral {
  static std::vector<Match> Find(std::span<const PredictedLandmark> landmarks,
                                 const FeatureGrid& grid, const std::vector<char>& is_taken,
                                 const ClusterAssociationOptions& options);
};
// Policy: uses the same search radius for every landmark, as for the static scene.
struct FixedRadiusAssociation {
  static std::vector<Match> Find(std::span<const PredictedLandmark> landmarks,
                                 const FeatureGrid& grid, const std::vector<char>& is_taken,
                                 const ClusterAssociationOptions& options);
};

}  // namespace cvo
