// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/load_image.h"

#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/files/images/image_codec.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/grey_png.h"
#include "experiments/datasets/formats/image_header.h"
#include "experiments/datasets/formats/png.h"

namespace cvo {
namespace {

// Colour is converted to grey here and not by the PNG library, whose arithmetic depends on its
// version.
cv::Mat DecodeGrey(const std::string& bytes, bool is_png) {
  if (is_png) {
    cv::Mat grey = DecodeGreyPng(bytes);
    if (!grey.empty()) return grey;
  }
  const cv::Mat decoded = DecodeImage(bytes, cv::IMREAD_UNCHANGED);
  if (decoded.empty() || decoded.depth() != CV_8U || decoded.channels() == 1) return decoded;
  cv::Mat grey;
  cv::cvtColor(decoded, grey, decoded.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  return grey;
}

}  // namespace

LoadedImage LoadGrey(const std::filesystem::path& path) {
  LoadedImage image;
  const auto fail = [&](const std::string& found) {
    image.grey.release();
    image.problem = StrCat(path.string(), ": found ", found, ", expected a whole ",
                           IsJpeg(path) ? "JPEG" : "PNG", " image");
    return image;
  };
  std::string bytes;
  try {
    bytes = ReadFileBytes(path);
  } catch (const Error& error) {
    image.problem = error.what();
    return image;
  }
  image.sha256 = Sha256Hex(bytes);
  const auto damage = IsJpeg(path) ? FindJpegDamage(bytes) : FindPngDamage(bytes);
  if (damage) return fail(*damage);
  try {
    image.grey = DecodeGrey(bytes, !IsJpeg(path));
  } catch (const cv::Exception& error) {
    return fail(StrCat("one that OpenCV refuses (", error.err, ")"));
  }
  if (image.grey.empty()) return fail("one that cannot be decoded");
  if (image.grey.type() != CV_8UC1) return fail("one that has not 8 bits per channel");
  return image;
}

LoadedImage LoadFrameImage(const Sequence& sequence, std::size_t index, int side) {
  const StereoPaths& paths = sequence.images.at(index);
  const std::filesystem::path& path = side == 0 ? paths.left : paths.right;
  LoadedImage image = LoadGrey(path);
  const StereoCamera& camera = sequence.camera;
  if (!image.ok()) return image;
  if (image.grey.cols != camera.width_px || image.grey.rows != camera.height_px) {
    image.problem = StrCat(path.string(), ": found ", image.grey.cols, "x", image.grey.rows,
                           " px, expected ", camera.width_px, "x", camera.height_px, " px");
    image.grey.release();
  } else if (const Rectification* rectify = sequence.rectification.get()) {
    image.grey = side == 0 ? rectify->Left(image.grey) : rectify->Right(image.grey);
  }
  return image;
}

}  // namespace cvo
