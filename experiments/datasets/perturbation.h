// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

#include "core/base/options.h"
#include "core/files/json/json.h"

namespace cvo {

struct Sequence;

// Degradations of the images and the calibration of a sequence, applied before a run to measure how
// its error depends on them. Random choices are determined by `seed` and the frame's number in its
// folder, so a larger rate drops the same frames and additional ones. The first frame read is
// neither dropped nor replaced.
struct Perturbation {
  double blur_px = 0.0;
  double gain = 1.0;
  double gamma = 1.0;
  double noise = 0.0;
  int jpeg_quality = 100;
  double drop_rate = 0.0;
  double repeat_rate = 0.0;
  int right_late_rows = 0;
  int right_late_frames = 0;
  double focal_error = 0.0;
  double baseline_error = 0.0;
  double disparity_error_px = 0.0;
  std::uint64_t seed = 0;  // not an option: the seed of the job

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    constexpr const char* kNone = "the default changes nothing";
    visit.Field("blur_px", self.blur_px,
                FieldInfo{"px", 0, 20, "std of a Gaussian blur of both images", kNone});
    visit.Field("gain", self.gain, FieldInfo{"1", 0.01, 10, "factor on grey levels", kNone});
    visit.Field("gamma", self.gamma,
                FieldInfo{"1", 0.1, 10, "exponent on grey levels, after the gain", kNone});
    visit.Field("noise", self.noise,
                FieldInfo{"grey level", 0, 100, "std of Gaussian noise per pixel", kNone});
    visit.Field("jpeg_quality", self.jpeg_quality,
                FieldInfo{"1", 1, 100, "compression as JPEG; 100: none", kNone});
    visit.Field("drop_rate", self.drop_rate,
                FieldInfo{"1", 0, 1, "part of the frames whose images are missing", kNone});
    visit.Field("repeat_rate", self.repeat_rate,
                FieldInfo{"1", 0, 1, "part of the frames that show the images before", kNone});
    visit.Field("right_late_rows", self.right_late_rows,
                FieldInfo{"px", -20, 20, "rows by which the right image is lower", kNone});
    visit.Field("right_late_frames", self.right_late_frames,
                FieldInfo{"1", 0, 10, "frames by which the right image is late", kNone});
    visit.Field("focal_error", self.focal_error,
                FieldInfo{"1", -0.5, 0.5, "error of the focal length, part of it", kNone});
    visit.Field("baseline_error", self.baseline_error,
                FieldInfo{"1", -0.5, 0.5, "error of the baseline, part of it", kNone});
    visit.Field("disparity_error_px", self.disparity_error_px,
                FieldInfo{"px", -5, 5, "error of every disparity", kNone});
  }
};

// Returns the options that differ from their defaults, and the seed if there are any. Returns {}
// for no perturbation.
Json PerturbationToJson(const Perturbation& perturbation);
// Parses an object such as {"blur_px": 1.5}. Throws Error naming a key that is unknown or out of
// range.
Perturbation ParsePerturbation(const Json& json, const std::string& where);

// Perturbs the camera and the choice of the image files that frames are read from.
void PerturbSequence(const Perturbation& perturbation, Sequence& sequence);
// Whether the images of this frame are withheld.
bool IsDropped(const Sequence& sequence, std::size_t index);
// Perturbs the pixels of the frame's left (0) or right (1) image.
void PerturbImage(const Sequence& sequence, std::size_t index, int side, cv::Mat& grey);

}  // namespace cvo
