// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/association/feature_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cvo {

namespace {

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

}  // namespace cvo
