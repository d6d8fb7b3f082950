// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <vector>

#include "core/clustering/crf_lanes.h"
#include "core/clustering/pairwise_options.h"

namespace cvo {

// Nodes (rows) by labels (columns).
using CrfMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct CrfResult {
  CrfMatrix q;     // probabilities; rows sum to 1
  int sweeps = 0;  // performed
};

// A kernel policy defines bandwidth and normalisation: k_ij = s_i s_j g_ij for i != j, where
// g_ij = exp(-d_ij^2 / (2 BandwidthM^2)) and s_i = Scale(sum_{j != i} g_ij).

// Policy: D^-1/2 K D^-1/2. D includes the node itself, so that the only neighbour of a remote node
// does not get full weight however weak it is; a node receives no message from itself. Rows sum to
// less than about 1.
struct NormalizedGaussianKernel {
  static double BandwidthM(const PairwiseOptions& options) { return options.bandwidth_m; }
  static double Scale(double degree);
};

// Policy: exp(-d^2) with d in m, as printed in the paper (equation of psi_p): not normalised, and
// independent of the options.
struct RawGaussianKernel {
  static double BandwidthM(const PairwiseOptions& options);
  static double Scale(double degree);
};

// Policy: no pairwise term.
struct NoPairwise {};

template <typename Policy>
concept PairwisePolicy = std::same_as<Policy, NoPairwise> ||
    requires(const PairwiseOptions& options, double degree) {
  { Policy::BandwidthM(options) } -> std::same_as<double>;
  { Policy::Scale(degree) } -> std::same_as<double>;
};

// Mean-field inference for E(q) = sum_i U_i(q_i) + alpha sum_{i<j} k_ij [q_i != q_j] (section 3.2
// of the paper): Q_i(l) ~ exp(-U_i(l) + alpha sum_j k_ij Q_j(l)), for all nodes at once, starting
// from softmax(-U). `energies` is N x M in nats, `points` is 3 x N in m; throws Error if the two N
// differ, a value is not finite, or there are nodes but no labels. k_ij = 0 beyond 6 bandwidths,
// where it is below the rounding of float. With the default options, Q is within 1e-5 of the result
// in double precision without this cutoff (raw kernel: 1e-3). Needs at most 2 N^2 + 40 N M bytes;
// `memory` is reused from call to call.
template <PairwisePolicy Kernel>
CrfResult InferDenseCrf(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                        const PairwiseOptions& options, CrfMemory& memory);
template <PairwisePolicy Kernel>
CrfResult InferDenseCrf(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                        const PairwiseOptions& options) {
  CrfMemory memory;
  return InferDenseCrf<Kernel>(energies, points, options, memory);
}

// The same without AVX2, as the reference in tests of the fast path.
template <PairwisePolicy Kernel>
CrfResult InferDenseCrfPlain(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                             const PairwiseOptions& options);

// Returns the most likely label of each node, the first one in case of a tie.
std::vector<int> MostLikelyLabels(const CrfMatrix& q);

}  // namespace cvo
