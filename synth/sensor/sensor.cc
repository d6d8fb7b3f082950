// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/sensor/sensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/error.h"
#include "core/base/rng.h"

namespace cvo::synth {
namespace {

// Computes the quantiles outwards from the median by Newton's method, each starting from its
// neighbour.
std::vector<float> MakeQuantiles() {
  constexpr int kHalf = 1 << 15;
  std::vector<double> upper(kHalf);
  double x = 0.0;
  double square_sum = 0.0;
  for (int i = 0; i < kHalf; ++i) {
    const double tail = 0.5 - (i + 0.5) / (2.0 * kHalf);  // probability above the quantile
    for (int step = 0; step < 6; ++step) {
      const double density = std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
      x += (0.5 * std::erfc(x / std::numbers::sqrt2) - tail) / density;
    }
    upper[static_cast<std::size_t>(i)] = x;
    square_sum += x * x;
  }
  const double scale = 1.0 / std::sqrt(square_sum / kHalf);
  std::vector<float> quantiles(2 * kHalf);
  for (std::size_t i = 0; i < kHalf; ++i) {
    quantiles[kHalf + i] = static_cast<float>(scale * upper[i]);
    quantiles[kHalf - 1 - i] = -quantiles[kHalf + i];
  }
  return quantiles;
}

// Vignetting: cos^4 of the angle to the optical axis, where cos^2 = 1 / (1 + (slope r)^2) and r = 1
// in the corners.
class Falloff {
 public:
  Falloff(double vignetting, cv::Size size)
      : slope2_(1.0 / std::sqrt(1.0 - vignetting) - 1.0),
        centre_u_((size.width - 1) / 2.0),
        centre_v_((size.height - 1) / 2.0),
        inverse_r2_(1.0 / std::max(centre_u_ * centre_u_ + centre_v_ * centre_v_, 1.0)) {}

  void Row(int v, std::vector<float>& factors) const {
    const double dv2 = (v - centre_v_) * (v - centre_v_);
    for (std::size_t u = 0; u < factors.size(); ++u) {
      const double du = static_cast<double>(u) - centre_u_;
      const double root = 1.0 + slope2_ * (du * du + dv2) * inverse_r2_;
      factors[u] = static_cast<float>(1.0 / (root * root));
    }
  }

 private:
  double slope2_;
  double centre_u_;
  double centre_v_;
  double inverse_r2_;
};

// Fills `numbers` with standard normal numbers, four from each 64-bit draw.
void FillNormal(Rng& rng, std::vector<float>& numbers) {
  const float* quantiles = NormalQuantiles().data();
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    std::uint64_t bits = rng.NextU64();
    for (std::size_t k = i; k < std::min(i + 4, numbers.size()); ++k, bits >>= 16) {
      numbers[k] = quantiles[bits & 0xFFFFU];
    }
  }
}

// Noise model of a row: a grey level has mean black + signal and variance shot * signal + read2,
// where signal = brightness * falloff * clean.
struct RowModel {
  float brightness;
  float shot;
  float read2;
  float black;
};

void ApplyRow(const RowModel& model, const std::vector<float>& falloff,
              const std::vector<float>& normal, const unsigned char* in, unsigned char* out) {
  for (std::size_t u = 0; u < falloff.size(); ++u) {
    const float signal = model.brightness * falloff[u] * in[u];
    const float sigma = std::sqrt(model.shot * signal + model.read2);
    const float grey = model.black + signal + sigma * normal[u];
    out[u] = static_cast<unsigned char>(std::clamp(grey, 0.0F, 255.0F) + 0.5F);
  }
}

}  // namespace

const std::vector<float>& NormalQuantiles() {
  static const std::vector<float> quantiles = MakeQuantiles();
  return quantiles;
}

double NormalCdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

SensorOptions NoiselessSensor(SensorOptions options) {
  SensorOptions off;
  off.full_well = off.read_noise = off.vignetting = off.exposure_difference = 0.0;
  off.motion_blur = options.motion_blur;
  return off;
}

bool HasNoEffect(const SensorOptions& options) {
  return options.full_well == 0.0 && options.read_noise == 0.0 && options.gain == 1.0 &&
         options.vignetting == 0.0 && options.exposure_difference == 0.0 &&
         options.black_level == 0.0;
}

cv::Mat ApplySensor(const cv::Mat& clean, const SensorOptions& options, std::uint64_t seed,
                    int camera, int frame) {
  Require(clean.type() == CV_8UC1, "ApplySensor: the image must be CV_8UC1");
  if (HasNoEffect(options)) return clean.clone();
  Rng rng(seed, StrCat("sensor ", camera, " ", frame));
  const double exposure = camera == 1 ? 1.0 + options.exposure_difference : 1.0;
  RowModel model;
  model.brightness = static_cast<float>(options.gain * exposure);
  model.shot =
      options.full_well > 0.0 ? static_cast<float>(options.gain * 255.0 / options.full_well) : 0.0F;
  model.read2 = static_cast<float>(std::pow(options.gain * options.read_noise, 2));
  model.black = static_cast<float>(options.black_level);
  const Falloff falloff(options.vignetting, clean.size());
  cv::Mat image(clean.size(), CV_8UC1);
  std::vector<float> factors(static_cast<std::size_t>(clean.cols));
  std::vector<float> normal(factors.size());
  for (int v = 0; v < clean.rows; ++v) {
    falloff.Row(v, factors);
    FillNormal(rng, normal);
    ApplyRow(model, factors, normal, clean.ptr(v), image.ptr(v));
  }
  return image;
}

}  // namespace cvo::synth
