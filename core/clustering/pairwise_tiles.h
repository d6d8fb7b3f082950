// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/clustering/crf_lanes.h"

namespace cvo {

// The Gaussian kernel between all nodes, exp(-d^2 / (2 b^2)), 0 on the diagonal and beyond 6 b.
// Nodes are reordered so that neighbours are close to each other. The upper triangle is divided
// into square tiles of kCrfTile nodes, of which only those within reach of the kernel are stored:
// at most 2 N^2 bytes.
class PairwiseTiles {
 public:
  // points: 3 x N, m, finite. `memory` holds the tiles and must outlive this object.
  PairwiseTiles(const Eigen::Matrix3Xd& points, double bandwidth_m, const CrfLoops& loops,
                CrfMemory& memory);

  // order()[i] is the column of `points` that is node i of this class.
  const std::vector<int>& order() const { return order_; }
  // Row sums of the kernel, in that order.
  const std::vector<double>& degrees() const { return degrees_; }
  // Number of nodes including those that pad the last tile, whose q must be 0.
  int padded() const { return padded_; }

  // message += K q; both have blocks x padded() elements.
  void Multiply(const CrfLanes* q, int blocks, CrfLanes* message) const;

 private:
  struct Place {
    int row;  // index of the first node
    int column;
  };

  void ListTiles(const Eigen::Matrix3Xd& points, double reach_m);
  void FillTiles(const Eigen::Matrix3Xd& points, double bandwidth_m);
  void AddDegrees();

  CrfLoops loops_;
  std::vector<int> order_;
  std::vector<double> degrees_;
  int padded_;
  std::vector<Place> places_;
  CrfMemory& tiles_;  // one per place; may hold more
};

}  // namespace cvo
