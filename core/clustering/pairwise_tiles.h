// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/clustering/crf_lanes.h"

namespace cvo {

// The Gaussian kernel between all nodes, exp(-d^2 / (2 b^2)), 0 on the diagonal and beyond 6 b.
// Nodes are ordered so that neighbours are together; of the upper triangle, cut into squares of
// kCrfTile nodes, those are stored that are not all zero: at most 2 N^2 bytes.
class PairwiseTiles {
 public:
  // points: 3 x N, m, finite. `memory` is written to and must outlive it.
  PairwiseTiles(const Eigen::Matrix3Xd& points, double bandwidth_m, const CrfLoops& loops,
                CrfMemory& memory);

  // order()[i] is the column of `points` that is node i here.
  const std::vector<int>& order() const { return order_; }
  // Sums of the rows, in that order.
  const std::vector<double>& degrees() const { return degrees_; }
  // Nodes with those that fill the last tile, which must have q = 0.
  int padded() const { return padded_; }

  // message += K q, each of blocks x padded() elements.
  void Multiply(const CrfLanes* q, int blocks, CrfLanes* message) const;

 private:
  struct Place {
    int row;  // first nodes
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
  CrfMemory& tiles_;  // by place; there may be more
};

}  // namespace cvo
