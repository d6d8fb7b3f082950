// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/files/images/image_file.h"
#include "core/files/json/options_json.h"
#include "experiments/datasets/sequence.h"

namespace cvo {
namespace {

int NumberOf(const Sequence& sequence, std::size_t index) {
  return sequence.first_frame + static_cast<int>(index);
}

// Whether `what`, which happens to a fraction `rate` of the frames, happens to this one.
bool Happens(const char* what, double rate, std::uint64_t seed, int frame) {
  return rate > 0.0 && Rng(seed, StrCat("perturb ", what, " ", frame)).Uniform() < rate;
}

void ApplyCurve(double gain, double gamma, cv::Mat& grey) {
  cv::Mat levels(1, 256, CV_8UC1);
  for (int level = 0; level < 256; ++level) {
    const double bright = std::min(gain * level / 255.0, 1.0);
    levels.at<unsigned char>(level) =
        cv::saturate_cast<unsigned char>(255.0 * std::pow(bright, gamma));
  }
  cv::LUT(grey, levels, grey);
}

void AddNoise(double deviation, Rng rng, cv::Mat& grey) {
  for (int v = 0; v < grey.rows; ++v) {
    auto* row = grey.ptr<unsigned char>(v);
    for (int u = 0; u < grey.cols; ++u) {
      row[u] = cv::saturate_cast<unsigned char>(row[u] + deviation * rng.Normal());
    }
  }
}

// Rows that come into view repeat the border row.
void ShiftDown(int rows, cv::Mat& grey) {
  cv::Mat shifted(grey.size(), grey.type());
  for (int v = 0; v < grey.rows; ++v) {
    grey.row(std::clamp(v - rows, 0, grey.rows - 1)).copyTo(shifted.row(v));
  }
  grey = shifted;
}

void Compress(int quality, cv::Mat& grey) {
  grey = DecodeImage(EncodeImage(".jpg", grey, {cv::IMWRITE_JPEG_QUALITY, quality}),
                     cv::IMREAD_GRAYSCALE);
}

}  // namespace

Json PerturbationToJson(const Perturbation& perturbation) {
  Perturbation changed = perturbation;
  Perturbation defaults;
  const Json plain = OptionsToJson(OptionLeaves(defaults));
  const Json all = OptionsToJson(OptionLeaves(changed));  // must outlive the loop over items()
  Json json = Json::object();
  for (const auto& [key, value] : all.items()) {
    if (value != plain[key]) json[key] = value;
  }
  if (!json.empty()) json["seed"] = perturbation.seed;
  return json;
}

Perturbation ParsePerturbation(const Json& json, const std::string& where) {
  Perturbation perturbation;
  MergeOptions(json, where, OptionLeaves(perturbation));
  CheckRanges(perturbation);
  return perturbation;
}

void PerturbSequence(const Perturbation& perturbation, Sequence& sequence) {
  sequence.perturbation = perturbation;
  StereoCamera& camera = sequence.camera;
  camera.fx *= 1.0 + perturbation.focal_error;
  camera.fy *= 1.0 + perturbation.focal_error;
  camera.baseline_m *= 1.0 + perturbation.baseline_error;
  camera.right_shift_px += perturbation.disparity_error_px;
  std::vector<StereoPaths>& images = sequence.images;
  for (std::size_t i = 1; i < images.size(); ++i) {
    const int frame = NumberOf(sequence, i);
    if (Happens("repeat", perturbation.repeat_rate, perturbation.seed, frame)) {
      images[i] = images[i - 1];
    }
  }
  const auto late = static_cast<std::size_t>(perturbation.right_late_frames);
  for (std::size_t i = images.size(); late > 0 && i-- > 0;) {
    images[i].right = images[i - std::min(i, late)].right;
  }
}

bool IsDropped(const Sequence& sequence, std::size_t index) {
  const Perturbation& perturbation = sequence.perturbation;
  return index > 0 &&
         Happens("drop", perturbation.drop_rate, perturbation.seed, NumberOf(sequence, index));
}

void PerturbImage(const Sequence& sequence, std::size_t index, int side, cv::Mat& grey) {
  const Perturbation& perturbation = sequence.perturbation;
  if (side == 1 && perturbation.right_late_rows != 0) {
    ShiftDown(perturbation.right_late_rows, grey);
  }
  if (perturbation.blur_px > 0.0) {
    cv::GaussianBlur(grey, grey, cv::Size(), perturbation.blur_px);
  }
  if (perturbation.gain != 1.0 || perturbation.gamma != 1.0) {
    ApplyCurve(perturbation.gain, perturbation.gamma, grey);
  }
  if (perturbation.noise > 0.0) {
    AddNoise(perturbation.noise,
             Rng(perturbation.seed, StrCat("perturb noise ", side, " ", NumberOf(sequence, index))),
             grey);
  }
  if (perturbation.jpeg_quality < 100) Compress(perturbation.jpeg_quality, grey);
}

}  // namespace cvo
