// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/patch_alignment.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/error.h"
#include "core/features/processor.h"

namespace cvo {
namespace {

constexpr int kMaxSteps = 3;
constexpr double kSmallStep_px = 0.02;  // converged: the next step would be far smaller
constexpr double kMaxMove_px = 1.0;     // from the result of the column search
constexpr double kMaxShear = 0.6;  // px per row; the ground has baseline / height, 0.33 on KITTI
// Prior information on the shear: (5 / 0.5)^2, the noise in grey levels over the standard deviation
// of the shear in px per row.
constexpr double kShearInformation = 100.0;
// Prior information on the shift of a quarter of the patch, for quarters without texture.
constexpr double kQuarterInformation = 100.0;
constexpr double kWindowSigma = 0.7;  // fraction of the patch radius

constexpr int kRegister = 8;  // floats; rows are processed in multiples of a register
constexpr int kMaxSide = 2 * kMaxPatchRadius_px + 1;
constexpr int kMaxLanes = 32;
constexpr int kMargin = 3;  // extra columns at each end of the strip, for shear and interpolation
constexpr int kMaxStrip = kMaxSide + 2 * (kMaxSearchRadius_px + kMargin) + kMaxLanes;

using Lanes = float[kMaxLanes];
using Register = float[kRegister];

void Store(const Register& from, float* to) {
  for (int x = 0; x < kRegister; ++x) to[x] = from[x];
}

// Samples of both images around the corner, taken at the same fraction of a column so that
// interpolation smooths them alike. Lanes beyond the patch hold finite values and have no weight.
struct Patches {
  int radius;
  int side;
  int lanes;
  int shifts;
  const float* weight;  // of a column or row; the weight of a pixel is their product
  float left[kMaxSide][kMaxLanes];
  float slope[kMaxSide][kMaxLanes];  // d left / du
  float right[kMaxSide][kMaxStrip];  // shift s compares left[y][x] with right[y][x + s + kMargin]
};

// Returns the window weights for a radius, 0 beyond the patch.
const float* WindowOf(int radius) {
  static const auto windows = [] {
    std::array<std::array<float, kMaxLanes>, kMaxPatchRadius_px + 1> all{};
    for (int r = 1; r <= kMaxPatchRadius_px; ++r) {
      for (int x = 0; x <= 2 * r; ++x) {
        const double z = (x - r) / (kWindowSigma * r);
        all[r][x] = static_cast<float>(std::exp(-0.5 * z * z));
      }
    }
    return all;
  }();
  return windows[radius].data();
}

// Samples an image bilinearly on a grid with a spacing of 1 px that starts at (u, v).
class Sampler {
 public:
  Sampler(const cv::Mat& image, double u, double v)
      : image_(image),
        x_(static_cast<int>(std::floor(u))),
        y_(static_cast<int>(std::floor(v))),
        fu_(static_cast<float>(u - x_)),
        fv_(static_cast<float>(v - y_)) {}

  bool Covers(int width, int height) const {
    return x_ >= 0 && y_ >= 0 && x_ + width < image_.cols && y_ + height < image_.rows;
  }

  void Row(int row, int width, float* out) const {
    const std::uint8_t* top = image_.ptr<std::uint8_t>(y_ + row) + x_;
    const std::uint8_t* bottom = image_.ptr<std::uint8_t>(y_ + row + 1) + x_;
    const float a = (1.0F - fu_) * (1.0F - fv_);
    const float b = fu_ * (1.0F - fv_);
    const float c = (1.0F - fu_) * fv_;
    const float d = fu_ * fv_;
    for (int x = 0; x < width; ++x) {
      out[x] = a * static_cast<float>(top[x]) + b * static_cast<float>(top[x + 1]) +
               c * static_cast<float>(bottom[x]) + d * static_cast<float>(bottom[x + 1]);
    }
  }

 private:
  const cv::Mat& image_;
  int x_;
  int y_;
  float fu_;
  float fv_;
};

bool SamplePatches(const cv::Mat& left, const cv::Mat& right, const PatchQuery& query,
                   double whole_disparity, Patches& p) {
  p.radius = query.patch_radius;
  p.side = 2 * query.patch_radius + 1;
  p.lanes = (p.side + kRegister - 1) / kRegister * kRegister;
  p.shifts = 2 * query.search_radius + 1;
  const int strip = p.side + p.shifts - 1 + 2 * kMargin;
  const double u = query.u_left - p.radius;
  const Sampler in_left(left, u - 1.0, query.v_left - p.radius);
  const Sampler in_right(right, u - whole_disparity - query.search_radius - kMargin,
                         query.v_right - p.radius);
  if (!in_left.Covers(p.side + 2, p.side) || !in_right.Covers(strip, p.side)) return false;
  p.weight = WindowOf(p.radius);
  float wide[kMaxLanes + 2] = {};
  for (int y = 0; y < p.side; ++y) {
    in_left.Row(y, p.side + 2, wide);
    for (int x = 0; x < p.lanes; ++x) {
      p.left[y][x] = wide[x + 1];
      p.slope[y][x] = 0.5F * (wide[x + 2] - wide[x]);
    }
    in_right.Row(y, strip, p.right[y]);
    std::fill_n(p.right[y] + strip, p.lanes, 0.0F);
  }
  return true;
}

double WeightedSum(const Patches& p, const Lanes& values) {
  double sum = 0.0;
  for (int x = 0; x < p.side; ++x) sum += p.weight[x] * values[x];
  return sum;
}

// Weighted sums of 1, e and e^2 over a patch.
struct Moments {
  double weight;
  double first;
  double second;

  double Variance() const { return std::max(0.0, second - first * first / weight) / weight; }
};

double SumOfWeights(const Patches& p) {
  double sum = 0.0;
  for (int x = 0; x < p.side; ++x) sum += p.weight[x];
  return sum * sum;
}

CVO_FOR_EACH_PROCESSOR
Moments Difference(const Patches& p, int shift) {
  Lanes first;
  Lanes second;
  for (int begin = 0; begin < p.lanes; begin += kRegister) {
    Register of_first = {};
    Register of_second = {};
    for (int y = 0; y < p.side; ++y) {
      const float* right = p.right[y] + shift + kMargin + begin;
      const float* left = p.left[y] + begin;
      const float weight = p.weight[y];
      for (int x = 0; x < kRegister; ++x) {
        const float e = right[x] - left[x];
        of_first[x] += weight * e;
        of_second[x] += weight * e * e;
      }
    }
    Store(of_first, first + begin);
    Store(of_second, second + begin);
  }
  return {SumOfWeights(p), WeightedSum(p, first), WeightedSum(p, second)};
}

// The unknowns: shift of the middle row, shear, brightness.
using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

// Weighted sums over the quarters of the patch, computed from column sums over its upper and lower
// halves.
using Halves = Lanes[2];
using Quarters = Eigen::Array4d;

int HalfOf(const Patches& p, int row) { return row > p.radius ? 1 : 0; }

Quarters QuarterSums(const Patches& p, const Halves& halves) {
  Quarters sums = Quarters::Zero();
  for (int half = 0; half < 2; ++half) {
    for (int x = 0; x < p.side; ++x) {
      sums[2 * half + HalfOf(p, x)] += p.weight[x] * static_cast<double>(halves[half][x]);
    }
  }
  return sums;
}

struct Slopes {
  Matrix information;
  Quarters by_quarter;  // information on the shift
};

CVO_FOR_EACH_PROCESSOR
Slopes SumSlopes(const Patches& p) {
  Lanes g = {}, gy = {}, ggy = {}, ggyy = {};
  Halves gg = {};
  for (int i = 0; i < p.side; ++i) {
    const float y = static_cast<float>(i - p.radius);
    for (int x = 0; x < p.lanes; ++x) {
      const float weighted = p.weight[i] * p.slope[i][x];
      const float square = weighted * p.slope[i][x];
      g[x] += weighted;
      gy[x] += weighted * y;
      gg[HalfOf(p, i)][x] += square;
      ggy[x] += square * y;
      ggyy[x] += square * y * y;
    }
  }
  const Quarters by_quarter = QuarterSums(p, gg);
  Matrix H;
  H << by_quarter.sum(), WeightedSum(p, ggy), WeightedSum(p, g),          //
      0.0, WeightedSum(p, ggyy) + kShearInformation, WeightedSum(p, gy),  //
      0.0, 0.0, SumOfWeights(p);
  return {H.selfadjointView<Eigen::Upper>(), by_quarter};
}

struct Residuals {
  Vector gradient;      // of half the weighted sum of squares
  Quarters by_quarter;  // its first component, by quarter of the patch
  Moments moments;
};

// Residuals: the right patch, warped with cubic convolution, minus the left patch. Empty if the
// warp leaves the strip.
CVO_FOR_EACH_PROCESSOR
std::optional<Residuals> Evaluate(const Patches& p, const Vector& warp) {
  Lanes e1 = {}, ee = {}, gey = {};
  Halves ge = {};
  const int last = p.side + p.shifts - 1 + 2 * kMargin - 1;
  const float brightness = static_cast<float>(warp[2]);
  for (int i = 0; i < p.side; ++i) {
    const double column = warp[0] + warp[1] * (i - p.radius) + kMargin;
    const int whole = static_cast<int>(std::floor(column));
    if (whole < 1 || whole + p.side + 1 > last) return std::nullopt;
    const float t = static_cast<float>(column - whole);
    const float c0 = t * (-0.5F + t * (1.0F - 0.5F * t));
    const float c1 = 1.0F + t * t * (-2.5F + 1.5F * t);
    const float c2 = t * (0.5F + t * (2.0F - 1.5F * t));
    const float c3 = t * t * (-0.5F + 0.5F * t);
    const float* right = p.right[i] + whole;
    const float y = static_cast<float>(i - p.radius);
    for (int x = 0; x < p.lanes; ++x) {
      const float warped =
          c0 * right[x - 1] + c1 * right[x] + c2 * right[x + 1] + c3 * right[x + 2];
      const float e = warped + brightness - p.left[i][x];
      const float weighted = p.weight[i] * e;
      const float slope = weighted * p.slope[i][x];
      e1[x] += weighted;
      ee[x] += weighted * e;
      ge[HalfOf(p, i)][x] += slope;
      gey[x] += slope * y;
    }
  }
  const double first = WeightedSum(p, e1);
  const Quarters by_quarter = QuarterSums(p, ge);
  return Residuals{{by_quarter.sum(), WeightedSum(p, gey) + kShearInformation * warp[1], first},
                   by_quarter,
                   {SumOfWeights(p), first, WeightedSum(p, ee)}};
}

// Returns the shift with the smallest difference, refined to the vertex of the parabola through it
// and its neighbours. Empty at the ends of the search range.
std::optional<double> SearchShift(const Patches& p) {
  double costs[2 * kMaxSearchRadius_px + 1];
  int best = 0;
  for (int shift = 0; shift < p.shifts; ++shift) {
    costs[shift] = Difference(p, shift).Variance();
    if (costs[shift] < costs[best]) best = shift;
  }
  if (best == 0 || best == p.shifts - 1) return std::nullopt;
  const double curvature = costs[best - 1] + costs[best + 1] - 2.0 * costs[best];
  if (!(curvature > 0.0)) return std::nullopt;
  return best + 0.5 * (costs[best - 1] - costs[best + 1]) / curvature;
}

double Disagreement(const Quarters& information, const Quarters& gradient) {
  const Quarters shift = gradient / (information + kQuarterInformation);
  return std::sqrt((information * shift.square()).sum() / information.sum());
}

}  // namespace

std::optional<PatchMatch> AlignPatch(const cv::Mat& left, const cv::Mat& right,
                                     const PatchQuery& query) {
  Require(query.patch_radius >= 1 && query.patch_radius <= kMaxPatchRadius_px &&
              query.search_radius >= 1 && query.search_radius <= kMaxSearchRadius_px,
          "AlignPatch: radius out of range");
  Patches p;
  const double whole_disparity = std::round(query.u_left - query.u_right);
  if (!SamplePatches(left, right, query, whole_disparity, p)) return std::nullopt;
  const std::optional<double> start = SearchShift(p);
  if (!start) return std::nullopt;
  const Slopes slopes = SumSlopes(p);
  if (!(slopes.information.determinant() > 0.0)) return std::nullopt;
  const Matrix covariance = slopes.information.inverse();
  // Gauss-Newton with the gradients of the left patch, which do not change from step to step.
  Vector warp(*start, 0.0, 0.0);
  std::optional<Residuals> residuals = Evaluate(p, warp);
  for (int step = 0; step < kMaxSteps && residuals; ++step) {
    const Vector change = covariance * residuals->gradient;
    warp -= change;
    residuals = Evaluate(p, warp);
    if (std::abs(change[0]) < kSmallStep_px) break;
  }
  if (!residuals || std::abs(warp[0] - *start) > kMaxMove_px || std::abs(warp[1]) > kMaxShear) {
    return std::nullopt;
  }
  PatchMatch match;
  match.u_right = query.u_left - whole_disparity - query.search_radius + warp[0];
  match.sigma = std::sqrt(residuals->moments.Variance() * covariance(0, 0));
  match.disagreement = Disagreement(slopes.by_quarter, residuals->by_quarter);
  return match;
}

}  // namespace cvo
