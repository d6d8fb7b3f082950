// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/association/cluster_association_options.h"
#include "core/base/options.h"
#include "core/features/stereo_feature.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// An observation of landmark `landmark` of a list as feature `feature` of a frame.
struct Match {
  int landmark = 0;
  int feature = 0;
  int hamming = 0;  // bits
};

// Keeps the best pairs, such that each landmark and each feature occurs at most once. Ties go to
// the lower landmark, then to the lower feature. The result is sorted by landmark.
std::vector<Match> KeepOneToOne(std::vector<Match> candidates, int landmarks, int features);

// Matches by descriptors alone, by brute force: mutually nearest pairs within max_hamming whose
// distance is less than `ratio` times the second best. Ignores left-only features and those, by
// index, that is_wanted refuses. For frames for which no prediction can be trusted.
std::vector<Match> MatchDescriptors(std::span<const Descriptor> landmarks,
                                    std::span<const StereoFeature> features,
                                    const std::function<bool(int)>& is_wanted, int max_hamming,
                                    double ratio);

// Features of one frame, bucketed by their left pixel. Holds a view of the features, which must
// outlive it.
class FeatureGrid {
 public:
  FeatureGrid(std::span<const StereoFeature> features, const StereoCamera& camera);
  // Contains only the features with the indices `which`.
  FeatureGrid(std::span<const StereoFeature> features, const StereoCamera& camera,
              std::span<const int> which);

  // Calls visit(index) for each feature whose left pixel is within radius_px of (u_px, v_px) in
  // both coordinates, cell by cell in a fixed order.
  template <typename Visit>
  void VisitNear(double u_px, double v_px, double radius_px, Visit visit) const {
    const int first_column = Column(u_px - radius_px);
    const int last_column = Column(u_px + radius_px);
    const int last_row = Row(v_px + radius_px);
    for (int row = Row(v_px - radius_px); row <= last_row; ++row) {
      const int begin = cell_begin_[row * columns_ + first_column];
      const int end = cell_begin_[row * columns_ + last_column + 1];
      for (int i = begin; i < end; ++i) {
        const StereoFeature& feature = features_[sorted_[i]];
        if (std::abs(feature.z_px[0] - u_px) <= radius_px &&
            std::abs(feature.z_px[1] - v_px) <= radius_px) {
          visit(sorted_[i]);
        }
      }
    }
  }

  std::span<const StereoFeature> features() const { return features_; }

 private:
  static constexpr double kCell_px = 24.0;
  int Column(double u_px) const;
  int Row(double v_px) const;

  std::span<const StereoFeature> features_;
  int columns_;
  int rows_;
  std::vector<int> cell_begin_;  // start of each cell in sorted_, row-major, and the end
  std::vector<int> sorted_;      // feature indices by cell
};

// A landmark at its predicted position in the current frame.
struct ProjectedLandmark {
  Eigen::Vector3d zeta_px = Eigen::Vector3d::Zero();  // predicted (u_left, v, u_right)
  int octave = 0;                                     // predicted pyramid level
  Descriptor descriptor{};
};

// A landmark of a cluster, as predicted from the motion of the cluster.
struct PredictedLandmark : ProjectedLandmark {
  Eigen::Matrix3d position_px2 = Eigen::Matrix3d::Identity();     // Gamma, of its position only
  Eigen::Matrix3d measurement_px2 = Eigen::Matrix3d::Identity();  // Sigma_z of a feature there
  Eigen::Matrix3d innovation_px2 = Eigen::Matrix3d::Identity();   // S, of feature minus prediction
  int cluster = 0;                                                // index in the list of clusters
  int landmark = 0;                                               // index in that cluster
};

// Matches landmarks to the left of the field of view of the right image (METHOD.md 4.7) to
// left-only features: the most similar descriptor within the gate on (u_left, v); unique and
// one-to-one. Ignores features with is_taken and landmarks that are already in `matches`, and
// appends to `matches`.
void AddLeftOnlyMatches(std::span<const PredictedLandmark> landmarks, const FeatureGrid& grid,
                        const std::vector<char>& is_taken, const ClusterAssociationOptions& options,
                        std::vector<Match>& matches);

// Policies that find features for predicted landmarks (Eq. 2 of the paper): the most similar
// descriptor among the features within the gate; unique and one-to-one. They ignore left-only
// features and those with is_taken.

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

struct MatchingOptions {
  double wide_radius_px = 20.0;
  int max_hamming = 80;
  double ratio = 0.9;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("wide_radius_px", self.wide_radius_px,
                {"px", 1, 500,
                 "search radius with the predicted camera pose, at level 0; larger tolerates "
                 "sharper turns, smaller gives fewer false matches",
                 "chosen on KITTI at 10 Hz"});
    visit.Field("max_hamming", self.max_hamming,
                {"bits", 1, 256, "maximum descriptor distance of a match", "METHOD.md 3.1"});
    visit.Field(
        "ratio", self.ratio,
        {"1", 0.1, 1.0, "maximum ratio of the best to the second best distance", "METHOD.md 3.1"});
  }
};

// Matches each landmark to the feature with the nearest descriptor within radius_px *
// scale_factor^octave of its projection, in all three coordinates, and within one pyramid level.
// Matches are unique and one-to-one.
std::vector<Match> MatchProjected(std::span<const ProjectedLandmark> landmarks,
                                  const FeatureGrid& grid, double radius_px, double scale_factor,
                                  const MatchingOptions& options);

}  // namespace cvo
