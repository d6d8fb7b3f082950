// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/dense_crf.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <type_traits>

#include "core/base/error.h"

namespace cvo {

namespace {

// Cap on energies relative to the lowest one of the node, and the value for padding labels.
constexpr double kLargestEnergy = 1e30;
constexpr double kLargestCoordinate_m = 1e15;
// Nodes that are all updated at once can swap their labels back and forth for ever. If a change
// reverses direction and is not smaller than this fraction of the last one, all further changes are
// halved, again and again down to a sixteenth.
constexpr float kShrinking = 0.99F;
constexpr float kSmallestStep = 1.0F / 16.0F;

void CheckInput(const CrfMatrix& energies, const Eigen::Matrix3Xd& points) {
  Require(energies.rows() == points.cols() && (energies.rows() == 0 || energies.cols() > 0) &&
              energies.allFinite() && (points.array().abs() <= kLargestCoordinate_m).all(),
          "InferDenseCrf: needs a finite point and finite energies of labels for every node");
}

CrfMatrix Softmax(const CrfMatrix& energies) {
  CrfMatrix q(energies.rows(), energies.cols());
  for (Eigen::Index i = 0; i < q.rows(); ++i) {
    q.row(i) = (energies.row(i).minCoeff() - energies.row(i).array()).exp();
    q.row(i) /= q.row(i).sum();
  }
  return q;
}

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

// The Gaussian kernel between all nodes, exp(-d^2 / (2 b^2)), 0 on the diagonal and beyond 6 b.
// Nodes are reordered so that neighbours are close to each other. The upper triangle is divided
// into square tiles of kCrfTile nodes, of which only those within reach of the kernel are stored:
// at most 2 N^2 bytes.
class PairwiseTiles {
 public:
  // points: 3 x N, m, finite. `memory` holds the tiles and must outlive this object.
  PairwiseTiles(const Eigen::Matrix3Xd& points, double bandwidth_m, CrfMemory& memory)
      : order_(points.cols()),
        degrees_(points.cols(), 0.0),
        padded_(static_cast<int>((points.cols() + kCrfTile - 1) / kCrfTile) * kCrfTile),
        tiles_(memory) {
    std::iota(order_.begin(), order_.end(), 0);
    OrderByPlace(points, order_);
    ListTiles(points, kCutoffBandwidths * bandwidth_m);
    FillTiles(points, bandwidth_m);
    AddDegrees();
  }

  // order()[i] is the column of `points` that is node i of this class.
  const std::vector<int>& order() const { return order_; }
  // Row sums of the kernel, in that order.
  const std::vector<double>& degrees() const { return degrees_; }
  // Number of nodes including those that pad the last tile, whose q must be 0.
  int padded() const { return padded_; }

  // message += K q; both have blocks x padded() elements.
  void Multiply(const CrfLanes* q, int blocks, CrfLanes* message) const {
    for (std::size_t t = 0; t < places_.size(); ++t) {
      const Place& place = places_[t];
      for (int b = 0; b < blocks; ++b) {
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(b) * padded_;
        const CrfLanes* q_rows = q + first + place.row;
        CrfLanes* message_rows = message + first + place.row;
        if (place.row != place.column) {
          MultiplyTile(tiles_[t], q_rows, q + first + place.column, message_rows,
                       message + first + place.column);
          continue;
        }
        // Rows and columns are the same nodes: messages to the columns need a buffer of their own,
        // or they would be overwritten.
        CrfLanes apart[kCrfTile] = {};
        MultiplyTile(tiles_[t], q_rows, q_rows, message_rows, apart);
        for (int i = 0; i < kCrfTile; ++i) {
          message_rows[i].label += apart[i].label;
        }
      }
    }
  }

 private:
  struct Place {
    int row;  // index of the first node
    int column;
  };

  void ListTiles(const Eigen::Matrix3Xd& points, double reach_m) {
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

  void FillTiles(const Eigen::Matrix3Xd& points, double bandwidth_m) {
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
      FillTile(rows, FromOrigin(points, NodesOfTile(order_, place.column), origin), scale,
               tiles_[t]);
      if (place.row == place.column) KeepUpperTriangle(tiles_[t]);
    }
  }

  void AddDegrees() {
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

  std::vector<int> order_;
  std::vector<double> degrees_;
  int padded_;
  std::vector<Place> places_;
  CrfMemory& tiles_;  // one per place; may hold more
};

// The mean-field iteration, on blocks of kCrfLanes labels and nodes in the order of the tiles.
class MeanField {
 public:
  MeanField(const CrfMatrix& energies, const PairwiseTiles& tiles,
            const std::vector<double>& scales, double alpha)
      : tiles_(tiles),
        nodes_(static_cast<int>(energies.rows())),
        labels_(static_cast<int>(energies.cols())),
        blocks_((labels_ + kCrfLanes - 1) / kCrfLanes),
        energy_(Padded()),
        message_(energy_.size()),
        q_(energy_.size()),
        previous_(energy_.size()),
        next_(energy_.size()),
        scaled_(energy_.size()) {
    for (const double scale : scales) {
      scale_.push_back(static_cast<float>(scale));
      weight_.push_back(static_cast<float>(alpha * scale));
    }
    Load(energies);
  }

  CrfResult Run(const PairwiseOptions& options) {
    int sweep = 0;
    float step = 1.0F;
    float last_change = std::numeric_limits<float>::infinity();
    while (sweep < options.sweeps) {
      ++sweep;
      const float change = Sweep();
      if (change > kShrinking * last_change && TurnsBack()) {
        step = std::max(0.5F * step, kSmallestStep);
      }
      if (step < 1.0F) Damp(step);
      std::swap(previous_, q_);
      std::swap(q_, next_);
      if (change < options.tolerance) break;
      last_change = change;
    }
    return {Unload(), sweep};
  }

 private:
  std::size_t Padded() const { return static_cast<std::size_t>(blocks_) * tiles_.padded(); }
  CrfLanes::Values& Lanes(std::vector<CrfLanes>& values, int node, int label) const {
    return values[static_cast<std::size_t>(label / kCrfLanes) * tiles_.padded() + node].label;
  }

  void Load(const CrfMatrix& energies) {
    const CrfMatrix q = Softmax(energies);
    std::fill(energy_.begin(), energy_.end(), NoLabel());
    for (int node = 0; node < nodes_; ++node) {
      const int row = tiles_.order()[node];
      const double least = energies.row(row).minCoeff();
      for (int label = 0; label < labels_; ++label) {
        Lanes(energy_, node, label)[label % kCrfLanes] =
            static_cast<float>(std::min(energies(row, label) - least, kLargestEnergy));
        Lanes(q_, node, label)[label % kCrfLanes] = static_cast<float>(q(row, label));
      }
    }
  }

  static CrfLanes NoLabel() { return {CrfLanes::Values{} + static_cast<float>(kLargestEnergy)}; }

  float Sweep() {
    for (int b = 0; b < blocks_; ++b) {
      const std::size_t first = static_cast<std::size_t>(b) * tiles_.padded();
      for (int node = 0; node < nodes_; ++node) {
        scaled_[first + node].label = scale_[node] * q_[first + node].label;
      }
    }
    std::fill(message_.begin(), message_.end(), CrfLanes{});
    tiles_.Multiply(scaled_.data(), blocks_, message_.data());
    return UpdateNodes({nodes_, blocks_, tiles_.padded(), energy_.data(), message_.data(),
                        weight_.data(), q_.data(), next_.data()});
  }

  // Whether the step from Q to the next Q points back towards the previous one.
  bool TurnsBack() const {
    double product = 0.0;
    for (std::size_t i = 0; i < q_.size(); ++i) {
      for (int l = 0; l < kCrfLanes; ++l) {
        const float q = q_[i].label[l];
        product += (next_[i].label[l] - q) * (q - previous_[i].label[l]);
      }
    }
    return product < 0.0;
  }

  void Damp(float step) {
    for (std::size_t i = 0; i < q_.size(); ++i) {
      next_[i].label = q_[i].label + step * (next_[i].label - q_[i].label);
    }
  }

  CrfMatrix Unload() {
    CrfMatrix q(nodes_, labels_);
    for (int node = 0; node < nodes_; ++node) {
      auto row = q.row(tiles_.order()[node]);
      for (int label = 0; label < labels_; ++label)
        row[label] = Lanes(q_, node, label)[label % kCrfLanes];
      row /= row.sum();
    }
    return q;
  }

  const PairwiseTiles& tiles_;
  int nodes_;
  int labels_;
  int blocks_;
  std::vector<float> scale_;   // s_i
  std::vector<float> weight_;  // alpha s_i
  std::vector<CrfLanes> energy_;
  std::vector<CrfLanes> message_;
  std::vector<CrfLanes> q_;
  std::vector<CrfLanes> previous_;
  std::vector<CrfLanes> next_;
  std::vector<CrfLanes> scaled_;  // s_i Q_i
};

}  // namespace

double NormalizedGaussianKernel::Scale(double degree) { return 1.0 / std::sqrt(1.0 + degree); }

double RawGaussianKernel::BandwidthM(const PairwiseOptions&) { return std::sqrt(0.5); }
double RawGaussianKernel::Scale(double) { return 1.0; }

template <typename Kernel>
CrfResult InferDenseCrf(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                        const PairwiseOptions& options, CrfMemory& memory) {
  CheckInput(energies, points);
  if constexpr (std::is_same_v<Kernel, NoPairwise>) {
    return {Softmax(energies), 0};
  } else {
    const PairwiseTiles tiles(points, Kernel::BandwidthM(options), memory);
    std::vector<double> scales;
    for (const double degree : tiles.degrees()) scales.push_back(Kernel::Scale(degree));
    return MeanField(energies, tiles, scales, options.alpha).Run(options);
  }
}

template CrfResult InferDenseCrf<NormalizedGaussianKernel>(const CrfMatrix&,
                                                           const Eigen::Matrix3Xd&,
                                                           const PairwiseOptions&, CrfMemory&);
template CrfResult InferDenseCrf<RawGaussianKernel>(const CrfMatrix&, const Eigen::Matrix3Xd&,
                                                    const PairwiseOptions&, CrfMemory&);
template CrfResult InferDenseCrf<NoPairwise>(const CrfMatrix&, const Eigen::Matrix3Xd&,
                                             const PairwiseOptions&, CrfMemory&);

Eigen::Matrix3Xd MovingPlaces(const CrfScene& scene) {
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(scene.nodes.size()));
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    places.col(i) = scene.nodes[static_cast<std::size_t>(i)].MovingPlace().p_in_camera;
  }
  return places;
}

std::vector<int> MostLikelyLabels(const CrfMatrix& q) {
  std::vector<int> labels(q.rows(), 0);
  for (Eigen::Index i = 0; i < q.rows(); ++i) {
    Eigen::Index best = 0;
    for (Eigen::Index label = 1; label < q.cols(); ++label) {
      if (q(i, label) > q(i, best)) best = label;
    }
    labels[i] = static_cast<int>(best);
  }
  return labels;
}

}  // namespace cvo
