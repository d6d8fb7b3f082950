// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/dense_crf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/clustering/pairwise_tiles.h"

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

void CheckInput(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                const PairwiseOptions& options) {
  CheckRanges(options);
  if (energies.rows() != points.cols()) {
    ThrowError("InferDenseCrf",
               StrCat(energies.rows(), " rows of energies and ", points.cols(), " points"),
               "one of each per node");
  }
  if (energies.rows() > 0 && energies.cols() == 0) {
    ThrowError("InferDenseCrf", "no labels", "at least one");
  }
  if (!energies.allFinite()) ThrowError("InferDenseCrf", "an energy that is not finite", "nats");
  if (!(points.array().abs() <= kLargestCoordinate_m).all()) {
    ThrowError("InferDenseCrf", "a point that is not finite", "metres");
  }
}

CrfMatrix Softmax(const CrfMatrix& energies) {
  CrfMatrix q(energies.rows(), energies.cols());
  for (Eigen::Index i = 0; i < q.rows(); ++i) {
    q.row(i) = (energies.row(i).minCoeff() - energies.row(i).array()).exp();
    q.row(i) /= q.row(i).sum();
  }
  return q;
}

// The mean-field iteration, on blocks of kCrfLanes labels and nodes in the order of the tiles.
class MeanField {
 public:
  MeanField(const CrfMatrix& energies, const PairwiseTiles& tiles,
            const std::vector<double>& scales, double alpha, const CrfLoops& loops)
      : tiles_(tiles),
        loops_(loops),
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
  float& At(std::vector<CrfLanes>& values, int node, int label) const {
    return values[static_cast<std::size_t>(label / kCrfLanes) * tiles_.padded() + node]
        .label[label % kCrfLanes];
  }

  void Load(const CrfMatrix& energies) {
    const CrfMatrix q = Softmax(energies);
    std::fill(energy_.begin(), energy_.end(), NoLabel());
    for (int node = 0; node < nodes_; ++node) {
      const int row = tiles_.order()[node];
      const double least = energies.row(row).minCoeff();
      for (int label = 0; label < labels_; ++label) {
        At(energy_, node, label) =
            static_cast<float>(std::min(energies(row, label) - least, kLargestEnergy));
        At(q_, node, label) = static_cast<float>(q(row, label));
      }
    }
  }

  static CrfLanes NoLabel() {
    CrfLanes none;
    std::fill_n(none.label, kCrfLanes, static_cast<float>(kLargestEnergy));
    return none;
  }

  float Sweep() {
    for (int b = 0; b < blocks_; ++b) {
      const std::size_t first = static_cast<std::size_t>(b) * tiles_.padded();
      for (int node = 0; node < nodes_; ++node) {
        for (int l = 0; l < kCrfLanes; ++l) {
          scaled_[first + node].label[l] = scale_[node] * q_[first + node].label[l];
        }
      }
    }
    std::fill(message_.begin(), message_.end(), CrfLanes{});
    tiles_.Multiply(scaled_.data(), blocks_, message_.data());
    return loops_.update({nodes_, blocks_, tiles_.padded(), energy_.data(), message_.data(),
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
      for (int l = 0; l < kCrfLanes; ++l) {
        const float q = q_[i].label[l];
        next_[i].label[l] = q + step * (next_[i].label[l] - q);
      }
    }
  }

  CrfMatrix Unload() {
    CrfMatrix q(nodes_, labels_);
    for (int node = 0; node < nodes_; ++node) {
      auto row = q.row(tiles_.order()[node]);
      for (int label = 0; label < labels_; ++label) row[label] = At(q_, node, label);
      row /= row.sum();
    }
    return q;
  }

  const PairwiseTiles& tiles_;
  const CrfLoops& loops_;
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

template <typename Kernel>
CrfResult Infer(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                const PairwiseOptions& options, const CrfLoops& loops, CrfMemory& memory) {
  CheckInput(energies, points, options);
  const PairwiseTiles tiles(points, Kernel::BandwidthM(options), loops, memory);
  std::vector<double> scales;
  for (const double degree : tiles.degrees()) scales.push_back(Kernel::Scale(degree));
  return MeanField(energies, tiles, scales, options.alpha, loops).Run(options);
}

template <>
CrfResult Infer<NoPairwise>(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                            const PairwiseOptions& options, const CrfLoops&, CrfMemory&) {
  CheckInput(energies, points, options);
  return {Softmax(energies), 0};
}

}  // namespace

double NormalizedGaussianKernel::Scale(double degree) { return 1.0 / std::sqrt(1.0 + degree); }

double RawGaussianKernel::BandwidthM(const PairwiseOptions&) { return std::sqrt(0.5); }
double RawGaussianKernel::Scale(double) { return 1.0; }

template <PairwisePolicy Kernel>
CrfResult InferDenseCrf(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                        const PairwiseOptions& options, CrfMemory& memory) {
  return Infer<Kernel>(energies, points, options, FastCrfLoops(), memory);
}

template <PairwisePolicy Kernel>
CrfResult InferDenseCrfPlain(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                             const PairwiseOptions& options) {
  CrfMemory memory;
  return Infer<Kernel>(energies, points, options, PlainCrfLoops(), memory);
}

template CrfResult InferDenseCrf<NormalizedGaussianKernel>(const CrfMatrix&,
                                                           const Eigen::Matrix3Xd&,
                                                           const PairwiseOptions&, CrfMemory&);
template CrfResult InferDenseCrf<RawGaussianKernel>(const CrfMatrix&, const Eigen::Matrix3Xd&,
                                                    const PairwiseOptions&, CrfMemory&);
template CrfResult InferDenseCrf<NoPairwise>(const CrfMatrix&, const Eigen::Matrix3Xd&,
                                             const PairwiseOptions&, CrfMemory&);
template CrfResult InferDenseCrfPlain<NormalizedGaussianKernel>(const CrfMatrix&,
                                                                const Eigen::Matrix3Xd&,
                                                                const PairwiseOptions&);
template CrfResult InferDenseCrfPlain<RawGaussianKernel>(const CrfMatrix&, const Eigen::Matrix3Xd&,
                                                         const PairwiseOptions&);

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
