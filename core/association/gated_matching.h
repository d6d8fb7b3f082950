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

// A cluster's landmark where its predicted motion puts it in the current frame.
struct PredictedLandmark {
  Eigen::Vector3d zeta_px = Eigen::Vector3d::Zero();              // (u_left, v, u_right)
  Eigen::Matrix3d position_px2 = Eigen::Matrix3d::Identity();     // Gamma, of its position alone
  Eigen::Matrix3d measurement_px2 = Eigen::Matrix3d::Identity();  // Sigma_z of a feature there
  Eigen::Matrix3d innovation_px2 = Eigen::Matrix3d::Identity();   // S, of feature minus prediction
  int octave = 0;
  Descriptor descriptor{};
};

// Landmarks that are left of what the right image shows, among the features of the left image
// alone: the most similar descriptor within the gate on (u_left, v); unique and one-to-one.
// Features with is_taken are left out. `matches` grow.
void AddLeftOnlyMatches(std::span<const PredictedLandmark> landmarks, const FeatureGrid& grid,
                        const std::vector<char>& is_taken, const ClusterAssociationOptions& options,
                        std::vector<Match>& matches);

// How a feature is found for a predicted landmark (Eq. 2 of the paper): the most similar descriptor
// among the features within the gate; unique and one-to-one. Features with is_taken, and those of
// the left image alone, are left out.
template <typename Policy>
concept LandmarkAssociationPolicy = requires(std::span<const PredictedLandmark> landmarks,
                                             const FeatureGrid& grid,
                                             const std::vector<char>& is_taken,
                                             const ClusterAssociationOptions& options) {
  { Policy::Find(landmarks, grid, is_taken, options) } -> std::same_as<std::vector<Match>>;
};

// Policy: Mahalanobis distance in the innovation covariance (METHOD.md 4.2).
struct ProbabilisticAssociation {
  static std::vector<Match> Find(std::span<const PredictedLandmark> landmarks,
                                 const FeatureGrid& grid, const std::vector<char>& is_taken,
                                 const ClusterAssociationOptions& options);
};
// Policy: as printed, in the covariance of the landmark's position alone.
struct ProbabilisticAssociationLiteral {
  static std::vector<Match> Find(std::span<const PredictedLandmark> landmarks,
                                 const FeatureGrid& grid, const std::vector<char>& is_taken,
                                 const ClusterAssociationOptions& options);
};
// Policy: the same radius for every landmark, as for the static scene.
struct FixedRadiusAssociation {
  static std::vector<Match> Find(std::span<const PredictedLandmark> landmarks,
                                 const FeatureGrid& grid, const std::vector<char>& is_taken,
                                 const ClusterAssociationOptions& options);
};

}  // namespace cvo
