// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/features/stereo_feature.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

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

}  // namespace cvo
