// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <vector>

#include "core/clustering/crf_lanes.h"
#include "core/clustering/pairwise_options.h"

namespace cvo {

// By node (row) and label (column).
using CrfMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct CrfResult {
  CrfMatrix q;     // probabilities; rows sum to 1
  int sweeps = 0;  // done
};

// A kernel says how wide it is and how it is normalised: k_ij = s_i s_j g_ij for i != j,
// g_ij = exp(-d_ij^2 / (2 BandwidthM^2)), s_i = Scale(sum_{j != i} g_ij).

// Policy: D^-1/2 K D^-1/2. D counts the node itself, so that a far node's only neighbour, however
// faint, is not raised to full weight; the node has no message from itself. Rows sum to less than
// about 1.
struct NormalizedGaussianKernel {
  static double BandwidthM(const PairwiseOptions& options) { return options.bandwidth_m; }
  static double Scale(double degree);
};

// Policy: exp(-d^2) with d in m, as the paper prints it (equation of psi_p): no normalisation, no
// option.
struct RawGaussianKernel {
  static double BandwidthM(const PairwiseOptions& options);
  static double Scale(double degree);
};

// Policy: unary terms alone.
struct NoPairwise {};

template <typename Policy>
concept PairwisePolicy = std::same_as<Policy, NoPairwise> ||
    requires(const PairwiseOptions& options, double degree) {
  { Policy::BandwidthM(options) } -> std::same_as<double>;
  { Policy::Scale(degree) } -> std::same_as<double>;
};

// Mean field of E(q) = sum_i U_i(q_i) + alpha sum_{i<j} k_ij [q_i != q_j] (section 3.2 of the
// paper): Q_i(l) ~ exp(-U_i(l) + alpha sum_j k_ij Q_j(l)), all nodes at once, from softmax(-U).
// energies: N x M nats; points: 3 x N, m; all finite and N alike, or throws Error. k_ij = 0 beyond
// 6 bandwidths, below float's rounding. At the default options Q is within 1e-5 of what double
// precision without the cut gives (raw kernel: 1e-3). Memory: 2 N^2 + 40 N M bytes at most.
template <PairwisePolicy Kernel>
CrfResult InferDenseCrf(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                        const PairwiseOptions& options, CrfMemory& memory);
template <PairwisePolicy Kernel>
CrfResult InferDenseCrf(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                        const PairwiseOptions& options) {
  CrfMemory memory;
  return InferDenseCrf<Kernel>(energies, points, options, memory);
}

// The same without AVX2: what the fast path is tested against.
template <PairwisePolicy Kernel>
CrfResult InferDenseCrfPlain(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                             const PairwiseOptions& options);

// Most likely label of each node; of equal ones the first.
std::vector<int> MostLikelyLabels(const CrfMatrix& q);

}  // namespace cvo
