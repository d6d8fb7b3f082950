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

// What is done to the images and the calibration of a sequence before a run, so that its error can
// be measured against it. What is drawn at random is decided by `seed` and the number of the frame
// in its folder: a larger rate drops the same frames and more. The first frame that is read is
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
  std::uint64_t seed = 0;  // no option: that of the job

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

// The keys that differ from the default, and the seed where there are any: {} of no perturbation.
Json PerturbationToJson(const Perturbation& perturbation);
// {"blur_px": 1.5}. Throws Error with the key for one that is unknown or out of range.
Perturbation ParsePerturbation(const Json& json, const std::string& where);

// The camera, and which image files frames are read from.
void PerturbSequence(const Perturbation& perturbation, Sequence& sequence);
// The images of this frame are taken away.
bool IsDropped(const Sequence& sequence, std::size_t index);
// The pixels of its left (0) or right (1) image.
void PerturbImage(const Sequence& sequence, std::size_t index, int side, cv::Mat& grey);

}  // namespace cvo
