// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/rng.h"
#include "core/clustering/dense_crf.h"
#include "tests/support/error_message.h"

namespace cvo::crf_test {
namespace {

struct Problem {
  CrfMatrix energies;
  Eigen::Matrix3Xd points;
};

Problem RandomProblem(int nodes, int labels, double size_m, double energy, Rng& rng) {
  Problem problem{CrfMatrix(nodes, labels), Eigen::Matrix3Xd(3, nodes)};
  for (double& value : problem.points.reshaped()) value = rng.Uniform(0.0, size_m);
  for (double& value : problem.energies.reshaped()) value = rng.Uniform(0.0, energy);
  return problem;
}

PairwiseOptions AllSweeps(double alpha, int sweeps) {
  PairwiseOptions options;
  options.alpha = alpha;
  options.sweeps = sweeps;
  options.tolerance = 0.0;
  return options;
}

template <typename Kernel>
CrfResult Infer(const Problem& problem, const PairwiseOptions& options) {
  CrfMemory memory;
  return InferDenseCrf<Kernel>(problem.energies, problem.points, options, memory);
}

CrfMatrix Normalized(const Problem& problem, const PairwiseOptions& options) {
  return Infer<NormalizedGaussianKernel>(problem, options).q;
}

CrfMatrix Raw(const Problem& problem, const PairwiseOptions& options) {
  return Infer<RawGaussianKernel>(problem, options).q;
}

double Difference(const CrfMatrix& a, const CrfMatrix& b) { return (a - b).cwiseAbs().maxCoeff(); }

// The kernels by definition, in double precision and without a cut-off.
Eigen::MatrixXd RawKernel(const Eigen::Matrix3Xd& points, double bandwidth_m) {
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(points.cols(), points.cols());
  for (int i = 0; i < k.rows(); ++i) {
    for (int j = 0; j < k.cols(); ++j) {
      const double d = (points.col(i) - points.col(j)).norm();
      if (i != j) k(i, j) = std::exp(-d * d / (2.0 * bandwidth_m * bandwidth_m));
    }
  }
  return k;
}

Eigen::MatrixXd NormalizedKernel(const Eigen::Matrix3Xd& points, double bandwidth_m) {
  const Eigen::MatrixXd k = RawKernel(points, bandwidth_m);
  const Eigen::VectorXd d = (k.rowwise().sum().array() + 1.0).rsqrt();
  return d.asDiagonal() * k * d.asDiagonal();
}

void SoftmaxRows(CrfMatrix& logits) {
  for (auto row : logits.rowwise()) {
    row = (row.array() - row.maxCoeff()).exp();
    row /= row.sum();
  }
}

CrfMatrix Reference(const CrfMatrix& energies, const Eigen::MatrixXd& kernel, double alpha,
                    int sweeps) {
  CrfMatrix q = -energies;
  SoftmaxRows(q);
  CrfMatrix previous = q;
  double step = 1.0;
  double last = std::numeric_limits<double>::infinity();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    CrfMatrix next = alpha * (kernel * q) - energies;
    SoftmaxRows(next);
    const double change = Difference(next, q);
    const bool turns_back = (next - q).cwiseProduct(q - previous).sum() < 0.0;
    if (change > 0.99 * last && turns_back) step = std::max(0.5 * step, 1.0 / 16.0);
    previous = q;
    q += step * (next - q);
    last = change;
  }
  return q;
}

// The three sizes fit into one tile, span several tiles, and have tiles beyond the cut-off. The
// numbers of labels fill no lane, one, and more than two.
TEST(DenseCrf, AgreesWithDoublePrecisionReference) {
  Rng rng(2, "crf");
  for (const auto& [nodes, labels, size_m] :
       {std::tuple(40, 3, 1.0), std::tuple(300, 8, 3.0), std::tuple(500, 19, 20.0)}) {
    Problem problem = RandomProblem(nodes, labels, size_m, 6.0, rng);
    problem.points.colwise() += Eigen::Vector3d(2000.0, -30.0, 7000.0);
    const CrfMatrix reference =
        Reference(problem.energies, NormalizedKernel(problem.points, 0.7071), 5.0, 10);
    const PairwiseOptions options = AllSweeps(5.0, 10);
    EXPECT_LT(Difference(Normalized(problem, options), reference), 1e-5);
    // The pairwise term must have an effect, otherwise the comparison proves nothing.
    EXPECT_GT(Difference(Normalized(problem, AllSweeps(0.0, 1)), reference), 0.1);
  }
}

TEST(DenseCrf, RawKernelIsThePapersForAnyBandwidth) {
  Rng rng(3, "crf");
  const Problem problem = RandomProblem(200, 5, 4.0, 6.0, rng);
  PairwiseOptions options = AllSweeps(0.2, 10);
  options.bandwidth_m = 3.0;
  const CrfMatrix reference =
      Reference(problem.energies, RawKernel(problem.points, std::sqrt(0.5)), 0.2, 10);
  EXPECT_LT(Difference(Raw(problem, options), reference), 1e-5);
}

TEST(DenseCrf, ZeroWeightDisablesThePairwiseTerm) {
  Rng rng(6, "crf");
  const Problem problem = RandomProblem(100, 5, 1.0, 8.0, rng);
  const CrfResult none = Infer<NoPairwise>(problem, {});
  EXPECT_EQ(none.sweeps, 0);
  EXPECT_LT(Difference(Normalized(problem, AllSweeps(0.0, 3)), none.q), 1e-6);
  EXPECT_LT(Difference(Raw(problem, AllSweeps(0.0, 3)), none.q), 1e-6);
  CrfMatrix expected = -problem.energies;
  SoftmaxRows(expected);
  EXPECT_LT(Difference(none.q, expected), 1e-14);
}

// A body of 0.6 m in a room, as in METHOD.md 5.6: its box contains background points and misses
// 3 % of the body.
TEST(DenseCrf, OnlyTheRawKernelLetsARoomAbsorbASmallBody) {
  Rng rng(8, "crf");
  Problem problem{CrfMatrix(485, 3), Eigen::Matrix3Xd(3, 485)};
  for (int i = 0; i < 485; ++i) {
    const bool is_body = i < 60;
    const bool is_in_box = is_body ? i >= 2 : i < 85;
    const bool is_behind = !is_body && is_in_box;
    const double half_m = is_body ? 0.3 : (is_behind ? 0.6 : 1.8);
    const double near_m = is_body ? 2.7 : (is_behind ? 3.6 : 1.5);
    const double far_m = is_body ? 3.3 : (is_behind ? 5.5 : 4.5);
    problem.points.col(i) << rng.Uniform(-half_m, half_m), rng.Uniform(-half_m, half_m),
        rng.Uniform(near_m, far_m);
    const double other = -std::log(0.025);
    problem.energies.row(i).setConstant(other);
    problem.energies(i, is_in_box ? 1 : 0) = -std::log(0.95);
  }
  const auto count = [](const CrfMatrix& q, int first, int last) {
    const std::vector<int> labels = MostLikelyLabels(q);
    return std::count(labels.begin() + first, labels.begin() + last, 1);
  };
  const CrfMatrix normalized = Normalized(problem, {});
  EXPECT_GE(count(normalized, 0, 60), 57);
  EXPECT_EQ(count(normalized, 85, 485), 0);
  EXPECT_LE(count(Raw(problem, {}), 0, 60), 10);
}

TEST(DenseCrf, FewNodesAndFewLabels) {
  EXPECT_EQ(Normalized({CrfMatrix(0, 3), Eigen::Matrix3Xd(3, 0)}, {}).cols(), 3);
  EXPECT_EQ(Normalized({CrfMatrix(0, 0), Eigen::Matrix3Xd(3, 0)}, {}).rows(), 0);
  Problem one{CrfMatrix(1, 2), Eigen::Matrix3Xd::Zero(3, 1)};
  one.energies << std::log(3.0), 0.0;
  EXPECT_NEAR(Normalized(one, {})(0, 0), 0.25, 1e-6);
  const Problem certain{CrfMatrix::Constant(50, 1, 7.0), Eigen::Matrix3Xd::Random(3, 50)};
  EXPECT_EQ(Normalized(certain, {}), CrfMatrix::Ones(50, 1));
}

TEST(DenseCrf, HandlesCoincidentPointsAndExtremeEnergies) {
  Problem problem{CrfMatrix::Zero(100, 3), Eigen::Matrix3Xd::Ones(3, 100)};
  problem.energies.col(1).setConstant(1e300);
  problem.energies.col(2).setConstant(-1e300);
  const CrfMatrix q = Normalized(problem, {});
  EXPECT_TRUE(q.allFinite());
  EXPECT_EQ(MostLikelyLabels(q), std::vector<int>(100, 2));
  problem.energies.setConstant(4.0);
  EXPECT_LT(Difference(Normalized(problem, {}), CrfMatrix::Constant(100, 3, 1.0 / 3.0)), 1e-6);
}

TEST(DenseCrf, RefusesBadInput) {
  const double bad[] = {std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN()};
  const Problem good{CrfMatrix::Zero(4, 2), Eigen::Matrix3Xd::Zero(3, 4)};
  for (const double value : bad) {
    Problem problem = good;
    problem.energies(2, 1) = value;
    EXPECT_NE(ErrorMessage([&] { Normalized(problem, {}); }), "");
    EXPECT_NE(ErrorMessage([&] { Infer<NoPairwise>(problem, {}); }), "");
    problem = good;
    problem.points(1, 3) = value;
    EXPECT_NE(ErrorMessage([&] { Normalized(problem, {}); }), "");
  }
  EXPECT_NE(ErrorMessage([&] { Normalized({good.energies, Eigen::Matrix3Xd(3, 3)}, {}); }), "");
  EXPECT_NE(ErrorMessage([&] { Normalized({CrfMatrix(4, 0), good.points}, {}); }), "");
}

TEST(MostLikelyLabels, ReturnsTheFirstOfEqualLabels) {
  CrfMatrix q(2, 3);
  q << 0.2, 0.4, 0.4, 0.1, 0.2, 0.7;
  EXPECT_EQ(MostLikelyLabels(q), (std::vector<int>{1, 2}));
}

}  // namespace
}  // namespace cvo::crf_test
