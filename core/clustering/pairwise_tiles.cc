// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/pairwise_tiles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <span>

namespace cvo {
namespace {

constexpr double kCutoffBandwidths = 6.0;  // beyond, the kernel is 0
constexpr float kFarAway_m = 1e18F;        // padding of the last tile, where the kernel is 0

Eigen::AlignedBox3d BoxAround(const Eigen::Matrix3Xd& points, std::span<const int> nodes) {
  Eigen::AlignedBox3d box;
  for (const int node : nodes) box.extend(points.col(node));
  return box;
}

// Orders nodes by location: splits them across their longest extent until each part fits into a
// tile. All tiles but the last are full.
void OrderByPlace(const Eigen::Matrix3Xd& points, std::span<int> nodes) {
  if (nodes.size() <= kCrfTile) {
    std::sort(nodes.begin(), nodes.end());
    return;
  }
  Eigen::Index axis = 0;
  BoxAround(points, nodes).sizes().maxCoeff(&axis);
  const std::size_t tiles = (nodes.size() + kCrfTile - 1) / kCrfTile;
  const std::size_t middle = tiles / 2 * kCrfTile;
  std::nth_element(nodes.begin(), nodes.begin() + middle, nodes.end(), [&](int a, int b) {
    const double along_a = points(axis, a);
    const double along_b = points(axis, b);
    return along_a != along_b ? along_a < along_b : a < b;
  });
  OrderByPlace(points, nodes.first(middle));
  OrderByPlace(points, nodes.subspan(middle));
}

CrfTilePoints FromOrigin(const Eigen::Matrix3Xd& points, std::span<const int> nodes,
                         const Eigen::Vector3d& origin) {
  CrfTilePoints tile;
  std::fill_n(tile.x, kCrfTile, kFarAway_m);
  std::fill_n(tile.y, kCrfTile, kFarAway_m);
  std::fill_n(tile.z, kCrfTile, kFarAway_m);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    tile.x[i] = static_cast<float>(points(0, nodes[i]) - origin[0]);
    tile.y[i] = static_cast<float>(points(1, nodes[i]) - origin[1]);
    tile.z[i] = static_cast<float>(points(2, nodes[i]) - origin[2]);
  }
  return tile;
}

std::span<const int> NodesOfTile(const std::vector<int>& order, int first) {
  const std::size_t count = std::min<std::size_t>(kCrfTile, order.size() - first);
  return std::span(order).subspan(first, count);
}

// Keeps each pair of nodes once and clears the diagonal.
void KeepUpperTriangle(CrfTile& tile) {
  for (int i = 0; i < kCrfTile; ++i) std::fill_n(tile.k[i], i + 1, 0.0F);
}

}  // namespace

PairwiseTiles::PairwiseTiles(const Eigen::Matrix3Xd& points, double bandwidth_m,
                             const CrfLoops& loops, CrfMemory& memory)
    : loops_(loops),
      order_(points.cols()),
      degrees_(points.cols(), 0.0),
      padded_(static_cast<int>((points.cols() + kCrfTile - 1) / kCrfTile) * kCrfTile),
      tiles_(memory) {
  std::iota(order_.begin(), order_.end(), 0);
  OrderByPlace(points, order_);
  ListTiles(points, kCutoffBandwidths * bandwidth_m);
  FillTiles(points, bandwidth_m);
  AddDegrees();
}

void PairwiseTiles::ListTiles(const Eigen::Matrix3Xd& points, double reach_m) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (int first = 0; first < padded_; first += kCrfTile) {
    boxes.push_back(BoxAround(points, NodesOfTile(order_, first)));
  }
  const int count = static_cast<int>(boxes.size());
  for (int row = 0; row < count; ++row) {
    for (int column = row; column < count; ++column) {
      if (boxes[row].exteriorDistance(boxes[column]) > reach_m) continue;
      places_.push_back({row * kCrfTile, column * kCrfTile});
    }
  }
}

void PairwiseTiles::FillTiles(const Eigen::Matrix3Xd& points, double bandwidth_m) {
  if (tiles_.size() < places_.size()) {
    tiles_ = {};
    tiles_.resize(places_.size());
  }
  const float scale = static_cast<float>(0.5 / (bandwidth_m * bandwidth_m));
  CrfTilePoints rows{};
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (std::size_t t = 0; t < places_.size(); ++t) {
    const Place& place = places_[t];
    const auto row_nodes = NodesOfTile(order_, place.row);
    // With an origin near the nodes, single precision suffices wherever in the world they are.
    if (place.row == place.column) {
      origin = BoxAround(points, row_nodes).center();
      rows = FromOrigin(points, row_nodes, origin);
    }
    loops_.fill(rows, FromOrigin(points, NodesOfTile(order_, place.column), origin), scale,
                tiles_[t]);
    if (place.row == place.column) KeepUpperTriangle(tiles_[t]);
  }
}

void PairwiseTiles::AddDegrees() {
  std::vector<double> sums(padded_, 0.0);
  for (std::size_t t = 0; t < places_.size(); ++t) {
    const Place& place = places_[t];
    float of_column[kCrfTile] = {};
    for (int i = 0; i < kCrfTile; ++i) {
      const float* k = tiles_[t].k[i];
      float lanes[kCrfLanes] = {};
      for (int j = 0; j < kCrfTile; ++j) of_column[j] += k[j];
      for (int j = 0; j < kCrfTile; j += kCrfLanes) {
        for (int l = 0; l < kCrfLanes; ++l) lanes[l] += k[j + l];
      }
      for (const float part : lanes) sums[place.row + i] += part;
    }
    for (int j = 0; j < kCrfTile; ++j) sums[place.column + j] += of_column[j];
  }
  std::copy_n(sums.begin(), degrees_.size(), degrees_.begin());
}

void PairwiseTiles::Multiply(const CrfLanes* q, int blocks, CrfLanes* message) const {
  for (std::size_t t = 0; t < places_.size(); ++t) {
    const Place& place = places_[t];
    for (int b = 0; b < blocks; ++b) {
      const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(b) * padded_;
      const CrfLanes* q_rows = q + first + place.row;
      CrfLanes* message_rows = message + first + place.row;
      if (place.row != place.column) {
        loops_.multiply(tiles_[t], q_rows, q + first + place.column, message_rows,
                        message + first + place.column);
        continue;
      }
      // Rows and columns are the same nodes: messages to the columns need a buffer of their own, or
      // they would be overwritten.
      CrfLanes apart[kCrfTile] = {};
      loops_.multiply(tiles_[t], q_rows, q_rows, message_rows, apart);
      for (int i = 0; i < kCrfTile; ++i) {
        for (int l = 0; l < kCrfLanes; ++l) message_rows[i].label[l] += apart[i].label[l];
      }
    }
  }
}

}  // namespace cvo
