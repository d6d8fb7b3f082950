// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/images.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/base/rng.h"
#include "core/files/images/image_file.h"
#include "core/files/json/options_json.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/image_format.h"
#include "experiments/datasets/sequence.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

// The files of a folder in the order of their numbers, which must have no gap.
std::vector<fs::path> WithoutGap(const fs::path& folder,
                                 const std::map<std::int64_t, fs::path>& files) {
  std::vector<fs::path> paths;
  std::int64_t expected = files.begin()->first;
  for (const auto& [number, path] : files) {
    if (number != expected) {
      ThrowError(folder.string(), StrCat(files.size(), " files without number ", expected),
                 StrCat("all from ", files.begin()->first, " to ", files.rbegin()->first));
    }
    ++expected;
    paths.push_back(path);
  }
  return paths;
}

void CheckSize(const fs::path& path, const StereoImages& images, const fs::path& first) {
  const cv::Size size = ReadImageSize(path);
  if (size == cv::Size(images.width_px, images.height_px)) return;
  ThrowError(path.string(), StrCat(size.width, "x", size.height, " pixels"),
             StrCat(images.width_px, "x", images.height_px, " as in ", first.string()));
}

}  // namespace

cv::Mat DecodeGrey(std::string_view bytes) {
  cv::Mat grey = DecodeGreyPng(bytes);
  if (!grey.empty()) return grey;
  cv::Mat decoded = DecodeImage(bytes, cv::IMREAD_UNCHANGED);
  if (decoded.depth() == CV_16U) {
    constexpr double kScale = 255.0 / 65535.0;
    decoded.convertTo(decoded, CV_8U, kScale);
  }
  if (decoded.empty() || decoded.depth() != CV_8U || decoded.channels() == 1) return decoded;
  cv::cvtColor(decoded, grey, decoded.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  return grey;
}

std::map<std::int64_t, fs::path> NumberedFiles(const fs::path& folder,
                                               const std::string& extension) {
  const std::string pattern = "<number>" + extension;
  if (!fs::is_directory(folder)) {
    ThrowError(folder.string(), "no such folder", "a folder of " + pattern);
  }
  std::map<std::int64_t, fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path& path = entry.path();
    if (extension == ".png" && IsJpeg(path)) {
      ThrowError(path.string(), "a JPEG image", "PNG images (JPEG changes pixels)");
    }
    const std::string stem = path.stem().string();
    if (LowerExtension(path) != extension ||
        stem.find_first_not_of("0123456789") != std::string::npos) {
      continue;
    }
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

std::vector<std::pair<std::size_t, std::size_t>> PairByTime(const Times& left_ns,
                                                            const Times& right_ns,
                                                            const fs::path& right,
                                                            std::vector<std::string>& notes) {
  constexpr double kNear = 0.25;  // of a frame
  double step_ns = 4.0 * kDefaultAssociation_ns;
  for (const Times* times : {&left_ns, &right_ns}) {
    std::vector<double> steps_ns;
    for (std::size_t i = 1; i < times->size(); ++i) {
      steps_ns.push_back(static_cast<double>((*times)[i] - (*times)[i - 1]));
    }
    if (!steps_ns.empty()) step_ns = std::min(step_ns, Median(std::move(steps_ns)));
  }
  const TimeAssociation near =
      AssociateByTime(left_ns, right_ns, static_cast<std::int64_t>(kNear * step_ns));
  const std::size_t fewer = std::min(left_ns.size(), right_ns.size());
  if (near.pairs.empty() || 2 * near.pairs.size() < fewer) {
    ThrowError(right.string(),
               StrCat(near.pairs.size(), " of ", right_ns.size(), " images within ",
                      1e-6 * kNear * step_ns, " ms, a quarter of a frame, of a left image"),
               "pairs of images that were taken together");
  }
  if (near.unmatched_a + near.unmatched_b > 0) {
    notes.push_back(StrCat("images without one of the other camera at that time, left out: ",
                           near.unmatched_a, " left, ", near.unmatched_b, " right"));
  }
  return near.pairs;
}

StereoImages ListStereoImages(const fs::path& left_folder, const fs::path& right_folder) {
  const auto of_left = NumberedFiles(left_folder, ".png");
  const auto of_right = NumberedFiles(right_folder, ".png");
  const std::vector<fs::path> left = WithoutGap(left_folder, of_left);
  const std::vector<fs::path> right = WithoutGap(right_folder, of_right);
  const std::int64_t first = of_left.begin()->first;
  if (of_right.begin()->first != first || left.size() != right.size()) {
    ThrowError(right_folder.string(),
               StrCat(right.size(), " images from number ", of_right.begin()->first),
               StrCat(left.size(), ", as many as in ", left_folder.string(), ", from ", first));
  }
  std::vector<StereoPaths> paths;
  for (std::size_t i = 0; i < left.size(); ++i) paths.push_back({left[i], right[i]});
  StereoImages images = CheckedImages(std::move(paths));
  images.first = static_cast<int>(first);
  return images;
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
    image.grey = DecodeGrey(bytes);
  } catch (const cv::Exception& error) {
    return fail(StrCat("one that OpenCV refuses (", error.err, ")"));
  }
  if (image.grey.empty()) return fail("one that cannot be decoded");
  if (image.grey.type() != CV_8UC1) return fail("one that has not 8 or 16 bits per channel");
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
