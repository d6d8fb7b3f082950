// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/base/error.h"
#include "core/files/images/image_codec.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/png.h"
#include "experiments/datasets/formats/scene_truth.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

std::string Describe(int type, cv::Size size) {
  return StrCat(size.width, "x", size.height, " pixels of ", CV_MAT_CN(type), " x ",
                8 * CV_ELEM_SIZE1(type), " bits");
}

cv::Mat Decode(const fs::path& path, int type, cv::Size size) {
  const std::string bytes = ReadFileBytes(path);
  const std::string expected = Describe(type, size);
  if (path.extension() == ".png") {
    if (const auto damage = FindPngDamage(bytes)) ThrowError(path.string(), *damage, expected);
  }
  cv::Mat image;
  try {
    image = DecodeImage(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    ThrowError(path.string(), StrCat("one that OpenCV refuses (", error.err, ")"), expected);
  }
  if (image.empty()) ThrowError(path.string(), "an image that cannot be decoded", expected);
  if (image.type() != type || image.size() != size) {
    ThrowError(path.string(), Describe(image.type(), image.size()), expected);
  }
  return image;
}

}  // namespace

cv::Mat ReadDepth(const fs::path& path, cv::Size size) {
  cv::Mat depth = Decode(path, CV_32FC1, size);
  for (int v = 0; v < depth.rows; ++v) {
    const float* row = depth.ptr<float>(v);
    for (int u = 0; u < depth.cols; ++u) {
      if (std::isfinite(row[u]) && row[u] >= 0.0F) continue;
      ThrowError(StrCat(path.string(), ": pixel ", u, ", ", v), StrCat(row[u]),
                 "a finite depth that is not negative");
    }
  }
  return depth;
}

cv::Mat ReadInstances(const fs::path& path, cv::Size size) { return Decode(path, CV_16UC1, size); }

TruthFlow ReadFlow(const fs::path& path, cv::Size size) {
  constexpr float kUnits_per_px = 64.0F;
  constexpr float kZero = 32768.0F;
  const cv::Mat coded = Decode(path, CV_16UC3, size);  // in OpenCV's order: valid, v, u
  TruthFlow flow{cv::Mat(size, CV_32FC2, cv::Scalar::all(0.0)), cv::Mat::zeros(size, CV_8UC1)};
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const auto& code = coded.at<cv::Vec3w>(v, u);
      if (code[0] == 0) continue;
      flow.valid.at<unsigned char>(v, u) = 255;
      flow.flow_px.at<cv::Vec2f>(v, u) = {(static_cast<float>(code[2]) - kZero) / kUnits_per_px,
                                          (static_cast<float>(code[1]) - kZero) / kUnits_per_px};
    }
  }
  return flow;
}

}  // namespace cvo
