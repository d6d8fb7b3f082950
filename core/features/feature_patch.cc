// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/feature_patch.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/features/processor.h"

namespace cvo {
namespace {

constexpr int kReach_px = 5;  // radius of the part of the reference that is compared
constexpr int kSide = 2 * kReach_px + 1;
constexpr int kLanes = 12;  // floats; rows are processed in multiples of a register
constexpr double kWindowSigma_px = 3.5;
constexpr int kMaxSteps = 8;
constexpr double kSmallStep_px = 0.02;  // converged: the next step would be far smaller
constexpr double kMaxShift_px = 2.0;
constexpr double kMaxResidual = 0.5;  // fraction of the variance of the reference
// Prior information on each entry of the deformation: about (5 / 0.16)^2, the noise in grey levels
// over the standard deviation of the entry.
constexpr double kDeformationInformation = 1000.0;

// The unknowns: shift, deformation (row-major), brightness.
constexpr int kUnknowns = 7;
using Vector = Eigen::Matrix<double, kUnknowns, 1>;
using Matrix = Eigen::Matrix<double, kUnknowns, kUnknowns>;
using Lanes = float[kLanes];

// The compared part of the reference patch. Lanes beyond it hold finite values and have no weight.
struct Reference {
  float x[kLanes];  // of the columns, relative to the corner
  float y[kSide];   // of the rows, relative to the corner
  Lanes weight[kSide];
  Lanes value[kSide];
  Lanes slope_u[kSide];  // d value / dx
  Lanes slope_v[kSide];
};

Reference ReferenceOf(const FeaturePatch& patch) {
  constexpr int kStride = FeaturePatch::kSide_px;
  const std::uint8_t* middle = patch.pixels.data() + FeaturePatch::kRadius_px * (kStride + 1);
  float window[kLanes] = {};
  for (int i = 0; i < kSide; ++i) {
    const double z = (i - kReach_px) / kWindowSigma_px;
    window[i] = static_cast<float>(std::exp(-0.5 * z * z));
  }
  Reference r;
  for (int x = 0; x < kLanes; ++x) r.x[x] = static_cast<float>(x - kReach_px) - patch.corner_u;
  for (int i = 0; i < kSide; ++i) {
    r.y[i] = static_cast<float>(i - kReach_px) - patch.corner_v;
    const std::uint8_t* row = middle + (i - kReach_px) * kStride - kReach_px;
    for (int x = 0; x < kLanes; ++x) {
      r.weight[i][x] = window[i] * window[x];
      r.value[i][x] = row[x];
      r.slope_u[i][x] = 0.5F * (static_cast<float>(row[x + 1]) - static_cast<float>(row[x - 1]));
      r.slope_v[i][x] =
          0.5F * (static_cast<float>(row[x + kStride]) - static_cast<float>(row[x - kStride]));
    }
  }
  return r;
}

double Sum(const Lanes& lanes) {
  double sum = 0.0;
  for (const float value : lanes) sum += value;
  return sum;
}

// Sum over the lanes of lanes[i] * x[i]^power.
double Sum(const Lanes& lanes, const Lanes& x, int power) {
  double sum = 0.0;
  for (int i = 0; i < kLanes; ++i) {
    double value = lanes[i];
    for (int k = 0; k < power; ++k) value *= x[i];
    sum += value;
  }
  return sum;
}

// Weighted sums over the rows, by lane: products of gradients times y^k, where k is the index, and
// the moments of the values.
struct SlopeSums {
  Lanes uu[3] = {}, uv[3] = {}, vv[3] = {};
  Lanes u[2] = {}, v[2] = {};
  Lanes one = {}, first = {}, second = {};
};

CVO_FOR_EACH_PROCESSOR
SlopeSums SumSlopes(const Reference& r) {
  SlopeSums s;
  for (int i = 0; i < kSide; ++i) {
    const float y = r.y[i];
    for (int x = 0; x < kLanes; ++x) {
      const float w = r.weight[i][x];
      const float gu = r.slope_u[i][x];
      const float gv = r.slope_v[i][x];
      const float uu = w * gu * gu;
      const float uv = w * gu * gv;
      const float vv = w * gv * gv;
      s.uu[0][x] += uu, s.uu[1][x] += uu * y, s.uu[2][x] += uu * y * y;
      s.uv[0][x] += uv, s.uv[1][x] += uv * y, s.uv[2][x] += uv * y * y;
      s.vv[0][x] += vv, s.vv[1][x] += vv * y, s.vv[2][x] += vv * y * y;
      s.u[0][x] += w * gu, s.u[1][x] += w * gu * y;
      s.v[0][x] += w * gv, s.v[1][x] += w * gv * y;
      s.one[x] += w;
      s.first[x] += w * r.value[i][x];
      s.second[x] += w * r.value[i][x] * r.value[i][x];
    }
  }
  return s;
}

// Returns J^T J summed over the patch, plus the prior. J = (gu, gv, gu x, gu y, gv x, gv y, 1).
Matrix Information(const Reference& r, const SlopeSums& s) {
  // By unknown: whether its gradient is gv (else gu), and the powers of x and y multiplying it.
  constexpr int kOfV[] = {0, 1, 0, 0, 1, 1};
  constexpr int kOfX[] = {0, 0, 1, 0, 1, 0};
  constexpr int kOfY[] = {0, 0, 0, 1, 0, 1};
  Matrix H = Matrix::Zero();
  for (int a = 0; a < kUnknowns - 1; ++a) {
    for (int b = a; b < kUnknowns - 1; ++b) {
      const Lanes* of = kOfV[a] + kOfV[b] == 0 ? s.uu : (kOfV[a] + kOfV[b] == 1 ? s.uv : s.vv);
      H(a, b) = Sum(of[kOfY[a] + kOfY[b]], r.x, kOfX[a] + kOfX[b]);
    }
    H(a, kUnknowns - 1) = Sum((kOfV[a] == 0 ? s.u : s.v)[kOfY[a]], r.x, kOfX[a]);
  }
  for (int k = 2; k < kUnknowns - 1; ++k) H(k, k) += kDeformationInformation;
  H(kUnknowns - 1, kUnknowns - 1) = Sum(s.one);
  return H.selfadjointView<Eigen::Upper>();
}

// Maps a point (x, y) of the reference, relative to its corner, into the seen patch: middle + A (x,
// y).
struct Warp {
  Eigen::Vector2f middle;  // px from the centre of the first pixel of the patch
  Eigen::Matrix2f A;

  // Whether all samples are inside the patch, which is so if those at the corners of the grid are.
  bool StaysInside(const Reference& r) const {
    for (const int column : {0, kSide - 1}) {
      for (const int row : {0, kSide - 1}) {
        const Eigen::Vector2f at = middle + A * Eigen::Vector2f(r.x[column], r.y[row]);
        if (!(at.minCoeff() >= 0.0F && at.maxCoeff() < FeaturePatch::kSide_px - 1)) return false;
      }
    }
    return true;
  }
};

float Sample(const FeaturePatch& patch, float u, float v) {
  const int x = static_cast<int>(u);
  const int y = static_cast<int>(v);
  const float fu = u - static_cast<float>(x);
  const float fv = v - static_cast<float>(y);
  const std::uint8_t* p = patch.pixels.data() + y * FeaturePatch::kSide_px + x;
  const float p00 = p[0];
  const float p01 = p[1];
  const float p10 = p[FeaturePatch::kSide_px];
  const float p11 = p[FeaturePatch::kSide_px + 1];
  const float top = p00 + fu * (p01 - p00);
  const float bottom = p10 + fu * (p11 - p10);
  return top + fv * (bottom - top);
}

// Samples of `seen` at the warped pixels of the reference; 0 in the lanes beyond them.
using Samples = Lanes[kSide];

CVO_FOR_EACH_PROCESSOR
void SampleAll(const Reference& r, const FeaturePatch& seen, const Warp& warp, Samples& samples) {
  for (int i = 0; i < kSide; ++i) {
    const Eigen::Vector2f row = warp.middle + warp.A.col(1) * r.y[i];
    std::fill_n(samples[i], kLanes, 0.0F);
    for (int x = 0; x < kSide; ++x) {
      samples[i][x] =
          Sample(seen, row.x() + warp.A(0, 0) * r.x[x], row.y() + warp.A(1, 0) * r.x[x]);
    }
  }
}

struct Residuals {
  Vector gradient;  // of half the weighted sum of squares, without the deformation prior
  double squares;
};

CVO_FOR_EACH_PROCESSOR
Residuals SumResiduals(const Reference& r, const Samples& samples, float brightness) {
  Lanes eu[2] = {}, ev[2] = {}, e1 = {}, ee = {};
  for (int i = 0; i < kSide; ++i) {
    for (int x = 0; x < kLanes; ++x) {
      const float error = samples[i][x] + brightness - r.value[i][x];
      const float weighted = r.weight[i][x] * error;
      const float u = weighted * r.slope_u[i][x];
      const float v = weighted * r.slope_v[i][x];
      eu[0][x] += u, eu[1][x] += u * r.y[i];
      ev[0][x] += v, ev[1][x] += v * r.y[i];
      e1[x] += weighted;
      ee[x] += weighted * error;
    }
  }
  Vector gradient;
  gradient << Sum(eu[0]), Sum(ev[0]), Sum(eu[0], r.x, 1), Sum(eu[1]), Sum(ev[0], r.x, 1),
      Sum(ev[1]), Sum(e1);
  return {gradient, Sum(ee)};
}

}  // namespace

std::optional<Eigen::Vector2d> AlignFeaturePatch(const FeaturePatch& reference,
                                                 const FeaturePatch& seen, double zoom) {
  const Reference r = ReferenceOf(reference);
  const SlopeSums sums = SumSlopes(r);
  const double weight = Sum(sums.one);
  const double mean = Sum(sums.first) / weight;
  const double max_squares = kMaxResidual * (Sum(sums.second) - weight * mean * mean);
  const Eigen::LLT<Matrix> information(Information(r, sums));
  if (information.info() != Eigen::Success) return std::nullopt;
  const Eigen::Vector2d corner(seen.corner_u + FeaturePatch::kRadius_px,
                               seen.corner_v + FeaturePatch::kRadius_px);
  // Gauss-Newton with the gradients of the reference, which do not change from step to step.
  Vector at = Vector::Zero();
  Samples samples;
  for (int step = 0; step < kMaxSteps; ++step) {
    Eigen::Matrix2d deformation;
    deformation << 1.0 + at[2], at[3], at[4], 1.0 + at[5];
    const Warp warp{(corner + at.head<2>()).cast<float>(), (zoom * deformation).cast<float>()};
    if (!warp.StaysInside(r)) return std::nullopt;
    SampleAll(r, seen, warp, samples);
    Residuals residuals = SumResiduals(r, samples, static_cast<float>(at[6]));
    residuals.gradient.segment<4>(2) += kDeformationInformation * at.segment<4>(2);
    const Vector change = information.solve(residuals.gradient);
    at.head<2>() -= zoom * change.head<2>();  // the gradients of `seen` are smaller by this factor
    at.tail<5>() -= change.tail<5>();
    if (at.head<2>().norm() > kMaxShift_px) return std::nullopt;
    if (change.head<2>().norm() < kSmallStep_px) {
      if (residuals.squares > max_squares) return std::nullopt;
      return Eigen::Vector2d(at.head<2>());
    }
  }
  return std::nullopt;
}

}  // namespace cvo
