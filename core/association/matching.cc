// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/matching.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numeric>

#include "core/features/descriptor.h"

namespace cvo {

std::vector<Match> KeepOneToOne(std::vector<Match> candidates, int landmarks, int features) {
  std::sort(candidates.begin(), candidates.end(), [](const Match& a, const Match& b) {
    if (a.hamming != b.hamming) return a.hamming < b.hamming;
    if (a.landmark != b.landmark) return a.landmark < b.landmark;
    return a.feature < b.feature;
  });
  std::vector<bool> landmark_taken(static_cast<std::size_t>(landmarks), false);
  std::vector<bool> feature_taken(static_cast<std::size_t>(features), false);
  std::vector<Match> kept;
  kept.reserve(candidates.size());
  for (const Match& match : candidates) {
    if (landmark_taken[match.landmark] || feature_taken[match.feature]) continue;
    landmark_taken[match.landmark] = true;
    feature_taken[match.feature] = true;
    kept.push_back(match);
  }
  std::sort(kept.begin(), kept.end(),
            [](const Match& a, const Match& b) { return a.landmark < b.landmark; });
  return kept;
}

std::vector<Match> MatchDescriptors(std::span<const Descriptor> landmarks,
                                    std::span<const StereoFeature> features,
                                    const std::function<bool(int)>& is_wanted, int max_hamming,
                                    double ratio) {
  constexpr int kFarthest = 257;
  std::vector<Descriptor> descriptors;  // close together: features are large
  std::vector<int> feature_of;
  for (int i = 0; i < static_cast<int>(features.size()); ++i) {
    if (IsLeftOnly(features[i]) || !is_wanted(i)) continue;
    descriptors.push_back(features[i].descriptor);
    feature_of.push_back(i);
  }
  std::vector<int> distances(descriptors.size());
  std::vector<int> best_of_feature(features.size(), kFarthest);
  std::vector<Match> candidates;
  for (int i = 0; i < static_cast<int>(landmarks.size()); ++i) {
    HammingDistances(landmarks[i], descriptors, distances);
    int best = kFarthest;
    int second = kFarthest;
    int best_feature = -1;
    for (std::size_t k = 0; k < distances.size(); ++k) {
      const int hamming = distances[k];
      int& best_here = best_of_feature[feature_of[k]];
      best_here = std::min(best_here, hamming);
      if (hamming < best) {
        second = best;
        best = hamming;
        best_feature = feature_of[k];
      } else if (hamming < second) {
        second = hamming;
      }
    }
    if (best <= max_hamming && best < ratio * second) candidates.push_back({i, best_feature, best});
  }
  std::erase_if(candidates,
                [&](const Match& match) { return match.hamming > best_of_feature[match.feature]; });
  return KeepOneToOne(std::move(candidates), static_cast<int>(landmarks.size()),
                      static_cast<int>(features.size()));
}

namespace {

// Search radius of variants without probabilistic association (as the wide search of static
// landmarks).
constexpr double kFixedRadius_px = 20.0;

std::vector<int> All(std::size_t count) {
  std::vector<int> indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

}  // namespace

FeatureGrid::FeatureGrid(std::span<const StereoFeature> features, const StereoCamera& camera)
    : FeatureGrid(features, camera, All(features.size())) {}

FeatureGrid::FeatureGrid(std::span<const StereoFeature> features, const StereoCamera& camera,
                         std::span<const int> which)
    : features_(features),
      columns_(static_cast<int>(camera.width_px / kCell_px) + 1),
      rows_(static_cast<int>(camera.height_px / kCell_px) + 1),
      cell_begin_(static_cast<std::size_t>(columns_ * rows_ + 1), 0),
      sorted_(which.size()) {
  const auto cell = [this](int i) {
    return Row(features_[i].z_px[1]) * columns_ + Column(features_[i].z_px[0]);
  };
  for (const int i : which) ++cell_begin_[cell(i) + 1];
  for (std::size_t i = 1; i < cell_begin_.size(); ++i) cell_begin_[i] += cell_begin_[i - 1];
  std::vector<int> next(cell_begin_.begin(), cell_begin_.end() - 1);
  for (const int i : which) sorted_[next[cell(i)]++] = i;
}

int FeatureGrid::Column(double u_px) const {
  return static_cast<int>(std::clamp(std::floor(u_px / kCell_px), 0.0, columns_ - 1.0));
}

int FeatureGrid::Row(double v_px) const {
  return static_cast<int>(std::clamp(std::floor(v_px / kCell_px), 0.0, rows_ - 1.0));
}

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
Match FindSimilar(const ProjectedLandmark& landmark, const FeatureGrid& grid, double radius_px,
                  const auto& options, auto is_wanted, auto is_inside) {
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
std::vector<Match> FindOneToOne(const auto& landmarks, const FeatureGrid& grid, auto find) {
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
  return FindOneToOne(landmarks, grid, [&](const PredictedLandmark& landmark) {
    return FindSimilar(landmark, grid, kFixedRadius_px, options, IsFree(grid, is_taken, false),
                       [&](const Eigen::Vector3d& d) { return std::abs(d[2]) <= kFixedRadius_px; });
  });
}

std::vector<Match> MatchProjected(std::span<const ProjectedLandmark> landmarks,
                                  const FeatureGrid& grid, double radius_px, double scale_factor,
                                  const MatchingOptions& options) {
  return FindOneToOne(landmarks, grid, [&](const ProjectedLandmark& landmark) {
    const double radius = radius_px * std::pow(scale_factor, landmark.octave);
    return FindSimilar(
        landmark, grid, radius, options, [](int) { return true; },
        [&](const Eigen::Vector3d& d) { return std::abs(d[2]) <= radius; });
  });
}

}  // namespace cvo
