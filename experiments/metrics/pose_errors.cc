// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/pose_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/error.h"

namespace cvo {

namespace {

double Square(double x) { return x * x; }

// Flips the signs of the quaternions to that of a unit quaternion in their middle, which is
// returned.
Eigen::Vector4d AlignSigns(Eigen::Matrix4Xd& q) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (Eigen::Index i = 0; i < q.cols(); ++i) {
    if (q.col(i).dot(sum) < 0.0) q.col(i) = -q.col(i);
    sum += q.col(i);
  }
  const Eigen::Vector4d middle = sum.normalized();
  for (Eigen::Index i = 0; i < q.cols(); ++i) {
    if (q.col(i).dot(middle) < 0.0) q.col(i) = -q.col(i);
  }
  return middle;
}

Eigen::Matrix4Xd Coefficients(const std::vector<Eigen::Quaterniond>& Q) {
  Eigen::Matrix4Xd q(4, static_cast<Eigen::Index>(Q.size()));
  for (std::size_t i = 0; i < Q.size(); ++i) q.col(static_cast<Eigen::Index>(i)) = Q[i].coeffs();
  return q;
}

constexpr Eigen::Index kBlock = 512;  // numbers that fit in the L1 cache of the processor
using Block = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, kBlock, 1>;

// Coefficients of 16 asin^2(c / 2) as a series in c^2: 8 / (k^2 binomial(2k, k)) for k from 1.
constexpr auto kSquaredAngle = [] {
  std::array<double, 64> coefficients{};
  double binomial = 1.0;
  for (int k = 1; k <= 64; ++k) {
    binomial *= 2.0 * (2.0 * k - 1.0) / k;
    coefficients[static_cast<std::size_t>(k) - 1] = 8.0 / (k * k * binomial);
  }
  return coefficients;
}();

// Sum of the squared angles between unit quaternions at these squared distances, which are at most
// 2. The series has as many terms as the largest distance requires.
double SquaredAnglesOf(const Block& distances2) {
  constexpr double kPrecision = 1e-17;
  const double ratio = 0.25 * distances2.maxCoeff();
  std::size_t terms = 1;
  for (double last = ratio; last > kPrecision && terms < kSquaredAngle.size(); last *= ratio) {
    ++terms;
  }
  Block sum(distances2.size());
  // Processes as many at a time as fit in registers over all terms.
  const auto add = [&]<Eigen::Index kSize>(Eigen::Index at) {
    const Eigen::Array<double, kSize, 1> x = distances2.template segment<kSize>(at);
    Eigen::Array<double, kSize, 1> angles2 = Eigen::Array<double, kSize, 1>::Zero();
    for (std::size_t k = terms; k > 0; --k) angles2 = x * (angles2 + kSquaredAngle[k - 1]);
    sum.template segment<kSize>(at) = angles2;
  };
  constexpr Eigen::Index kLanes = 8;
  Eigen::Index at = 0;
  for (; at + kLanes <= sum.size(); at += kLanes) add.template operator()<kLanes>(at);
  for (; at < sum.size(); ++at) add.template operator()<1>(at);
  return sum.sum();
}

// Sum of the squared angles over all ordered pairs.
double SquaredAngles(const std::vector<Eigen::Quaterniond>& Q) {
  Eigen::Matrix4Xd q = Coefficients(Q);
  AlignSigns(q);
  const Eigen::Matrix<double, Eigen::Dynamic, 4> rows = q.transpose();
  double sum = 0.0;
  for (Eigen::Index i = 1; i < q.cols(); ++i) {
    for (Eigen::Index first = 0; first < i; first += kBlock) {
      const Eigen::Index size = std::min(kBlock, i - first);
      const auto row = [&](Eigen::Index k) { return rows.col(k).segment(first, size).array(); };
      Block distances2 = (row(0) - q(0, i)).square() + (row(1) - q(1, i)).square() +
                         (row(2) - q(2, i)).square() + (row(3) - q(3, i)).square();
      // q and -q are the same rotation; the squares of the two distances add up to 4.
      if (distances2.maxCoeff() > 1.99) {
        distances2 = distances2.min((row(0) + q(0, i)).square() + (row(1) + q(1, i)).square() +
                                    (row(2) + q(2, i)).square() + (row(3) + q(3, i)).square());
      }
      sum += 2.0 * SquaredAnglesOf(distances2);
    }
  }
  return sum;
}

// R - I without cancellation: 2 (w [v] + [v]^2).
Eigen::Matrix3d TurnedBy(const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d v = Skew(rotation.vec());
  return 2.0 * (rotation.w() * v + v * v);
}

std::optional<RelativeErrors> RootMeanSquares(double rotation_sum, double translation_sum,
                                              std::int64_t pairs) {
  if (pairs == 0) return std::nullopt;
  const auto n = static_cast<double>(pairs);
  return RelativeErrors{std::sqrt(rotation_sum / n), std::sqrt(translation_sum / n), pairs};
}

// Root mean squares of error(i), the error of the motion from frame i to i + 1, over consecutive
// frames.
template <typename Error>
std::optional<RelativeErrors> ConsecutiveErrors(const CommonPoses& poses, const Error& error) {
  double rotation_sum = 0.0;
  double translation_sum = 0.0;
  std::int64_t pairs = 0;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    if (poses.frames[i + 1] != poses.frames[i] + 1) continue;
    const RigidTransform E = error(i);
    rotation_sum += Square(RotationAngle(E.rotation()));
    translation_sum += E.translation().squaredNorm();
    ++pairs;
  }
  return RootMeanSquares(rotation_sum, translation_sum, pairs);
}

// Sum over all ordered pairs of |(p_j - p_i) - Q_i (g_j - g_i)|^2. Let A be a rotation in the
// middle of the Q_i. With the true positions rotated by A, d = p - A g and M_i = Q_i A^-1 - I, each
// term is |(d_j - d_i) - M_i A (g_j - g_i)|^2, in which d and M_i are small, so that nothing
// cancels. The sum over j follows from first and second moments.
double SquaredTranslations(const CommonPoses& poses, const std::vector<Eigen::Quaterniond>& Q) {
  Eigen::Matrix4Xd q = Coefficients(Q);
  const Eigen::Quaterniond A(AlignSigns(q));
  Eigen::Matrix3Xd g = A.toRotationMatrix() * Positions(poses.truth);
  Eigen::Matrix3Xd d = Positions(poses.estimate) - g;
  g.colwise() -= g.rowwise().mean().eval();
  d.colwise() -= d.rowwise().mean().eval();
  const auto n = static_cast<double>(poses.size());
  const Eigen::Matrix3d gg = g * g.transpose();
  const Eigen::Matrix3d gd = g * d.transpose();
  const double dd = d.squaredNorm();
  double sum = 0.0;
  for (Eigen::Index i = 0; i < g.cols(); ++i) {
    const Eigen::Matrix3d M = TurnedBy(Eigen::Quaterniond(q.col(i)) * A.conjugate());
    const Eigen::Vector3d Mg = M * g.col(i);
    const double moments = dd - 2.0 * (M * gd).trace() + (M * gg * M.transpose()).trace();
    sum += moments + n * (d.col(i) - Mg).squaredNorm();
  }
  return std::max(sum, 0.0);
}

void CheckFinite(const char* name, std::size_t frame, const RigidTransform& pose) {
  if (pose.Matrix().allFinite()) return;
  ThrowError(StrCat(name, " of frame ", frame), "a pose that is not finite", "finite numbers");
}

}  // namespace

Eigen::Matrix3Xd Positions(const std::vector<RigidTransform>& poses) {
  Eigen::Matrix3Xd positions(3, static_cast<Eigen::Index>(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    positions.col(static_cast<Eigen::Index>(i)) = poses[i].translation();
  }
  return positions;
}

CommonPoses FindCommonPoses(const OptionalPoses& truth, const OptionalPoses& estimate) {
  if (truth.size() != estimate.size()) {
    ThrowError("trajectory comparison", StrCat(estimate.size(), " estimated frames"),
               StrCat(truth.size(), ", as many as true ones"));
  }
  CommonPoses common;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i]) CheckFinite("truth", i, *truth[i]);
    if (estimate[i]) CheckFinite("estimate", i, *estimate[i]);
    if (!truth[i] || !estimate[i]) continue;
    common.frames.push_back(static_cast<int>(i));
    common.truth.push_back(*truth[i]);
    common.estimate.push_back(*estimate[i]);
  }
  return common;
}

Eigen::Matrix3Xd AlignedPositionErrors(const CommonPoses& poses) {
  Eigen::Matrix3Xd errors(3, static_cast<Eigen::Index>(poses.size()));
  if (poses.size() == 0) return errors;
  const Eigen::Matrix3Xd truth = Positions(poses.truth);
  const Eigen::Matrix3Xd estimate = Positions(poses.estimate);
  const RigidTransform truth_from_estimate = AlignPoints(estimate, truth);
  for (Eigen::Index i = 0; i < truth.cols(); ++i) {
    errors.col(i) = truth_from_estimate * estimate.col(i) - truth.col(i);
  }
  return errors;
}

// With Q_i = R(P_i) R(G_i)^-1, |trans E_ij| = |(p_j - p_i) - Q_i (g_j - g_i)|, and the angle of
// E_ij is that of Q_j^-1 Q_i, which is the same for E_ji.
std::optional<RelativeErrors> AllPairsErrors(const CommonPoses& poses) {
  if (poses.size() < 2) return std::nullopt;
  std::vector<Eigen::Quaterniond> Q;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Q.emplace_back(poses.estimate[i].rotation() * poses.truth[i].rotation().conjugate());
  }
  RelativeErrors errors;
  errors.pairs = static_cast<std::int64_t>(Q.size() * (Q.size() - 1));
  const auto n = static_cast<double>(errors.pairs);
  errors.translation_m = std::sqrt(SquaredTranslations(poses, Q) / n);
  if (Q.size() <= kMaxPairedRotations) errors.rotation_rad = std::sqrt(SquaredAngles(Q) / n);
  return errors;
}

std::optional<RelativeErrors> OneFrameErrors(const CommonPoses& poses) {
  return ConsecutiveErrors(poses, [&](std::size_t i) {
    const RigidTransform G = poses.truth[i].Inverse() * poses.truth[i + 1];
    const RigidTransform P = poses.estimate[i].Inverse() * poses.estimate[i + 1];
    return G.Inverse() * P;
  });
}

std::optional<RelativeErrors> MotionErrors(const CommonPoses& poses) {
  return ConsecutiveErrors(poses, [&](std::size_t i) {
    const RigidTransform& G = poses.truth[i];
    const RigidTransform H_gt = poses.truth[i + 1] * G.Inverse();
    const RigidTransform H_est = poses.estimate[i + 1] * poses.estimate[i].Inverse();
    return G.Inverse() * H_gt.Inverse() * H_est * G;
  });
}

std::optional<ComparedPaths> ConsecutiveLengths(const CommonPoses& poses) {
  ComparedPaths lengths;
  const auto step = [](const std::vector<RigidTransform>& path, std::size_t i) {
    return (path[i + 1].translation() - path[i].translation()).norm();
  };
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    if (poses.frames[i + 1] != poses.frames[i] + 1) continue;
    lengths.truth_m += step(poses.truth, i);
    lengths.estimate_m += step(poses.estimate, i);
    ++lengths.pairs;
  }
  return lengths.pairs > 0 ? std::optional(lengths) : std::nullopt;
}

namespace {

constexpr std::array<double, 8> kLengths_m = {100, 200, 300, 400, 500, 600, 700, 800};
constexpr std::size_t kStep = 10;

// Length of the true path up to each frame; a frame without truth has that of the preceding frame.
std::vector<double> PathLengths(const OptionalPoses& truth) {
  std::vector<double> lengths(truth.size());
  std::optional<Eigen::Vector3d> last;
  double length = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i]) {
      if (last) length += (truth[i]->translation() - *last).norm();
      last = truth[i]->translation();
    }
    lengths[i] = length;
  }
  return lengths;
}

// Finds the first frame whose distance from frame `first` along the path exceeds `length_m`.
std::optional<std::size_t> FindEnd(const std::vector<double>& path, std::size_t first,
                                   double length_m) {
  for (std::size_t i = first; i < path.size(); ++i) {
    if (path[i] > path[first] + length_m) return i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<KittiDrift> ComputeKittiDrift(const OptionalPoses& truth,
                                            const OptionalPoses& estimate) {
  Require(truth.size() == estimate.size(), "ComputeKittiDrift: needs frames in pairs");
  const std::vector<double> path = PathLengths(truth);
  KittiDrift drift;
  double translation_sum = 0.0;  // m per m
  double rotation_sum = 0.0;     // rad per m
  for (std::size_t first = 0; first < truth.size(); first += kStep) {
    if (!truth[first]) continue;
    for (const double length_m : kLengths_m) {
      const std::optional<std::size_t> last = FindEnd(path, first, length_m);
      if (!last) break;
      if (!estimate[first] || !estimate[*last]) {
        ++drift.segments_without_estimate;
        continue;
      }
      const RigidTransform G = truth[first]->Inverse() * *truth[*last];
      const RigidTransform P = estimate[first]->Inverse() * *estimate[*last];
      const RigidTransform E = P.Inverse() * G;
      translation_sum += E.translation().norm() / length_m;
      rotation_sum += RotationAngle(E.rotation()) / length_m;
      ++drift.segments;
    }
  }
  if (drift.segments == 0) return std::nullopt;
  const auto n = static_cast<double>(drift.segments);
  drift.translation_percent = 100.0 * translation_sum / n;
  drift.rotation_deg_per_100m = 100.0 * 180.0 / std::numbers::pi * rotation_sum / n;
  return drift;
}

}  // namespace cvo
