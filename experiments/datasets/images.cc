// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/images.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/image_format.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

void CheckNoGap(const fs::path& folder, const std::map<std::int64_t, fs::path>& files) {
  std::int64_t expected = 0;
  for (const auto& [number, path] : files) {
    if (number != expected) {
      ThrowError(folder.string(), StrCat(files.size(), " files without number ", expected),
                 StrCat("all from 0 to ", files.rbegin()->first));
    }
    ++expected;
  }
}

void CheckSize(const fs::path& path, const StereoImages& images, const fs::path& first) {
  const cv::Size size = ReadImageSize(path);
  if (size == cv::Size(images.width_px, images.height_px)) return;
  ThrowError(path.string(), StrCat(size.width, "x", size.height, " pixels"),
             StrCat(images.width_px, "x", images.height_px, " as in ", first.string()));
}

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

std::map<std::int64_t, fs::path> NumberedFiles(const fs::path& folder, const NumberedName& name) {
  const std::string pattern = StrCat(name.prefix, "<number>", name.extension);
  if (!fs::is_directory(folder)) {
    ThrowError(folder.string(), "no such folder", "a folder of " + pattern);
  }
  std::map<std::int64_t, fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path& path = entry.path();
    if (name.extension == ".png" && IsJpeg(path)) {
      ThrowError(path.string(), "a JPEG image", "PNG images (JPEG changes pixels)");
    }
    std::string stem = path.stem().string();
    if (path.extension() != name.extension || !stem.starts_with(name.prefix)) continue;
    stem.erase(0, name.prefix.size());
    if (stem.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::optional<std::int64_t> number = ParseInteger(stem);
    if (!number) continue;
    const auto [same, added] = files.emplace(*number, path);
    if (!added) {
      const auto [first, second] = std::minmax(same->second, path);
      ThrowError(second.string(), StrCat("number ", *number, " a second time"),
                 StrCat("only ", first.filename().string()));
    }
  }
  if (files.empty()) ThrowError(folder.string(), "no " + pattern, "at least one such file");
  return files;
}

std::vector<fs::path> ListNumberedFiles(const fs::path& folder, const NumberedName& name) {
  const std::map<std::int64_t, fs::path> files = NumberedFiles(folder, name);
  CheckNoGap(folder, files);
  std::vector<fs::path> paths;
  for (const auto& [number, path] : files) paths.push_back(path);
  return paths;
}

StereoImages CheckedImages(std::vector<StereoPaths> paths) {
  StereoImages images;
  images.paths = std::move(paths);
  const fs::path& first = images.paths.at(0).left;
  const cv::Size size = ReadImageSize(first);
  images.width_px = size.width;
  images.height_px = size.height;
  for (const StereoPaths& pair : images.paths) {
    CheckSize(pair.left, images, first);
    CheckSize(pair.right, images, first);
  }
  return images;
}

StereoImages ListStereoImages(const fs::path& left_folder, const fs::path& right_folder,
                              const NumberedName& name) {
  const std::vector<fs::path> left = ListNumberedFiles(left_folder, name);
  const std::vector<fs::path> right = ListNumberedFiles(right_folder, name);
  if (left.size() != right.size()) {
    ThrowError(right_folder.string(), StrCat(right.size(), " images"),
               StrCat(left.size(), ", as many as in ", left_folder.string()));
  }
  std::vector<StereoPaths> paths;
  for (std::size_t i = 0; i < left.size(); ++i) paths.push_back({left[i], right[i]});
  return CheckedImages(std::move(paths));
}

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
