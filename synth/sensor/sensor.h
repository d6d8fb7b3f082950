// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/options.h"

namespace cvo::synth {

// Returns the quantiles of the standard normal distribution at the midpoints of 2^16 equal
// intervals of probability, scaled to unit variance. Used as an index, 16 random bits give one
// normal number, so a 64-bit draw gives four. The tails end at 4.3, which makes no difference after
// rounding to 8 bits.
const std::vector<float>& NormalQuantiles();

// Cumulative distribution function of the standard normal distribution.
double NormalCdf(double x);

// Part of the clean render: changing a value requires a new render.
struct MotionBlurOptions {
  int sub_frames = 1;
  double shutter_s = 0.005;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field("sub_frames", self.sub_frames,
                FieldInfo{"1", 1, 64, "images averaged over the shutter's time; 1: no motion blur",
                          "about the pixels that things move meanwhile"});
    visit.Field("shutter_s", self.shutter_s,
                FieldInfo{"s", 0, 1, "time for which the shutter is open, around the frame's time",
                          "5 ms: indoors with a fast lens"});
  }
};

// The defaults describe an 8-bit machine-vision camera. Rendered grey levels are proportional to
// light, and 255 is a full well.
struct SensorOptions {
  double full_well = 10500;
  double read_noise = 0.5;
  double gain = 1.0;
  double vignetting = 0.15;
  double exposure_difference = 0.01;
  double black_level = 0.0;
  MotionBlurOptions motion_blur;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Field(
        "full_well", self.full_well,
        FieldInfo{"e-", 0, 1e9,
                  "electrons of a white pixel: fewer mean more shot noise; 0: no shot noise",
                  "10500: 3.45 um CMOS (Sony IMX264)"});
    visit.Field("read_noise", self.read_noise,
                FieldInfo{"grey level", 0, 100, "std of noise without light, at gain 1; 0: none",
                          "about 10 to 20 e-: older CCD; current CMOS has less"});
    visit.Field("gain", self.gain,
                FieldInfo{"1", 0.01, 100, "brightens image and noise alike; 1: off",
                          "exposure of the render is right already"});
    visit.Field("vignetting", self.vignetting,
                FieldInfo{"1", 0, 0.95, "part of the light that the corners lose; 0: none",
                          "C-mount lens at f/4"});
    visit.Field("exposure_difference", self.exposure_difference,
                FieldInfo{"1", -0.5, 0.5, "the right image is brighter by this part; 0: none",
                          "1 %: two cameras of one batch"});
    visit.Field("black_level", self.black_level,
                FieldInfo{"grey level", 0, 100, "value without light; 0: off",
                          "most cameras come with 0 to 4"});
    visit.Group("motion_blur", self.motion_blur);
  }
};

// Returns options with every effect off except motion blur, which is kept from `options`.
SensorOptions NoiselessSensor(SensorOptions options);
// Whether ApplySensor returns its input unchanged.
bool HasNoEffect(const SensorOptions& options);

// Simulates an 8-bit camera on a clean CV_8UC1 image. Every combination of seed, camera (0 left, 1
// right) and frame has its own random stream; the noise depends on nothing else.
cv::Mat ApplySensor(const cv::Mat& clean, const SensorOptions& options, std::uint64_t seed,
                    int camera, int frame);

}  // namespace cvo::synth
