// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/import/stereo_source.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/image_format.h"

namespace cvo {

namespace fs = std::filesystem;
namespace {

using Files = std::vector<fs::path>;

constexpr std::string_view kDecimalDigits = "0123456789";

std::string_view WithoutLeadingZeros(std::string_view digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

// Compares runs of digits as numbers of any length.
bool IsBefore(const fs::path& a, const fs::path& b) {
  return ::strverscmp(a.filename().c_str(), b.filename().c_str()) < 0;
}

// Files by the numeric value of their names. Empty unless all names are numbers and no two are
// equal: 0.1 and 0.10 are not times.
std::map<double, fs::path> ByValue(const Files& files) {
  std::map<double, fs::path> by_value;
  for (const fs::path& file : files) {
    const std::optional<double> value = ParseDouble(file.stem().string());
    if (!value || !by_value.emplace(*value, file).second) return {};
  }
  return by_value;
}

bool IsNumber(const fs::path& file) {
  return file.stem().string().find_first_not_of("0123456789.") == std::string::npos;
}

// Returns the name if it is a number as a whole, otherwise its last run of digits. Empty if it has
// none.
std::string NumberOf(const fs::path& file) {
  const std::string stem = file.stem().string();
  if (IsNumber(file)) return std::string(WithoutLeadingZeros(stem));
  const std::size_t last = stem.find_last_of(kDecimalDigits);
  if (last == std::string::npos) return "";
  const std::size_t before = stem.find_last_not_of(kDecimalDigits, last);
  return std::string(WithoutLeadingZeros(std::string_view(stem).substr(before + 1, last - before)));
}

// Files by their number (NumberOf). Empty unless every name has a number and all are distinct.
std::map<std::string, fs::path> ByNumber(const Files& files) {
  std::map<std::string, fs::path> by_number;
  for (const fs::path& file : files) {
    const std::string number = NumberOf(file);
    if (number.empty() || !by_number.emplace(number, file).second) return {};
  }
  return by_number;
}

void CheckAllIn(const std::map<std::string, fs::path>& others, const Files& files) {
  for (const fs::path& file : files) {
    const std::string number = NumberOf(file);
    if (others.contains(number)) continue;
    ThrowError(file.string(),
               StrCat("no image ", number, " in ", others.begin()->second.parent_path().string()),
               "images of both cameras with the same numbers");
  }
}

constexpr std::int64_t kLeastNs = 1'000'000'000'000;

bool IsImage(const fs::path& file) {
  constexpr std::array<const char*, 7> kEndings = {".png",  ".jpg", ".jpeg", ".pgm",
                                                   ".tiff", ".tif", ".bmp"};
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

bool IsPng(std::string_view bytes) { return bytes.starts_with("\x89PNG"); }
bool IsJpegFile(std::string_view bytes) { return bytes.starts_with("\xff\xd8"); }

// Checks files in the formats that mark their end, whatever the file's name, because decoders may
// return half an image. Some cameras pad JPEG files with zeros.
std::optional<std::string> FindDamage(std::string_view bytes) {
  if (IsPng(bytes)) return FindPngDamage(bytes);
  if (!IsJpegFile(bytes)) return std::nullopt;
  return FindJpegDamage(bytes.substr(0, bytes.find_last_not_of('\0') + 1));
}

SourceImage DamagedImage(const fs::path& file, const std::string& damage) {
  constexpr const char* kExpected = "an image that can be decoded";
  const std::string problem = StrCat(file.string(), ": found ", damage, ", expected ", kExpected);
  try {
    return {{}, ReadImageSize(file), problem};
  } catch (const Error&) {
    throw Error(problem);
  }
}

SourceImage ReadImage(const fs::path& file) {
  const std::string bytes = ReadFileBytes(file);
  if (const std::optional<std::string> damage = FindDamage(bytes)) {
    return DamagedImage(file, *damage);
  }
  const cv::Mat grey = DecodeImage(bytes, cv::IMREAD_GRAYSCALE);
  if (!grey.empty()) return {grey, grey.size(), ""};
  if (IsPng(bytes) || IsJpegFile(bytes)) return DamagedImage(file, "damaged pixels");
  ThrowError(file.string(), "no image that can be decoded", "one");
}

class ImageFolder final : public ImageSource {
 public:
  explicit ImageFolder(const fs::path& folder) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (entry.is_regular_file() && IsImage(entry.path())) files_.push_back(entry.path());
    }
    if (files_.empty()) ThrowError(folder.string(), "no image", "a folder of images");
    SortByNumber(files_);
  }

  std::size_t size() const override { return files_.size(); }
  std::vector<fs::path> files() const override { return files_; }
  SourceImage Next() override {
    return next_ == files_.size() ? SourceImage() : ReadImage(files_[next_++]);
  }

 private:
  std::vector<fs::path> files_;
  std::size_t next_ = 0;
};

class Video final : public ImageSource {
 public:
  explicit Video(const fs::path& file) : file_(file), video_(file.string()) {
    if (!video_.isOpened() || size() == 0) {
      ThrowError(file.string(), "no video that can be decoded",
                 "a video file or a folder of images");
    }
  }

  std::size_t size() const override {
    return static_cast<std::size_t>(std::max(0.0, video_.get(cv::CAP_PROP_FRAME_COUNT)));
  }
  double rate_hz() const override { return std::max(0.0, video_.get(cv::CAP_PROP_FPS)); }
  SourceImage Next() override {
    cv::Mat image;
    if (!video_.read(image)) return {};
    SourceImage next{{}, image.size(), ""};
    if (image.channels() == 1) {
      next.grey = image.clone();
    } else {
      cv::cvtColor(image, next.grey, cv::COLOR_BGR2GRAY);
    }
    return next;
  }

 private:
  fs::path file_;
  cv::VideoCapture video_;
};

}  // namespace

void SortByNumber(Files& files) {
  const std::map<double, fs::path> by_value = ByValue(files);
  if (by_value.empty()) {
    std::sort(files.begin(), files.end(), IsBefore);
    return;
  }
  files.clear();
  for (const auto& [value, file] : by_value) files.push_back(file);
}

void CheckPartners(const Files& left, const Files& right) {
  if (left.size() < 2 && right.size() < 2) return;  // left_0 and right_1: numbers of the cameras
  const std::map<std::string, fs::path> of_left = ByNumber(left);
  const std::map<std::string, fs::path> of_right = ByNumber(right);
  if (of_left.empty() || of_right.empty()) return;
  const auto is_shared = [&](const auto& numbered) { return of_right.contains(numbered.first); };
  if (std::none_of(of_left.begin(), of_left.end(), is_shared) &&
      std::all_of(left.begin(), left.end(), IsNumber) &&
      std::all_of(right.begin(), right.end(), IsNumber)) {
    return;
  }
  CheckAllIn(of_right, left);
  CheckAllIn(of_left, right);
}

std::unique_ptr<ImageSource> OpenImages(const fs::path& path) {
  if (fs::is_directory(path)) return std::make_unique<ImageFolder>(path);
  if (!fs::is_regular_file(path)) {
    ThrowError(path.string(), "no such file", "a folder of images or a video file");
  }
  return std::make_unique<Video>(path);
}

std::vector<std::int64_t> ReadTimes(const fs::path& path, std::size_t count) {
  const TextFile file(path);
  std::vector<std::int64_t> times_ns;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const std::optional<std::int64_t> whole = ParseInteger(file.line(i));
    const std::optional<std::int64_t> time_ns =
        whole && *whole > kLeastNs ? whole : ParseSecondsNs(file.line(i));
    if (!time_ns) ThrowError(file.Where(i), Quoted(file.line(i)), "a time in s, or in whole ns");
    if (!times_ns.empty() && *time_ns <= times_ns.back()) {
      ThrowError(file.Where(i), Quoted(file.line(i)), "a time after the one before");
    }
    times_ns.push_back(*time_ns);
  }
  if (times_ns.size() != count) {
    ThrowError(path.string(), StrCat(times_ns.size(), " times"),
               StrCat(count, ", one per image of the left camera"));
  }
  return times_ns;
}

std::vector<std::int64_t> TimesOfNames(const std::vector<fs::path>& files) {
  std::vector<std::int64_t> times_ns;
  for (const fs::path& file : files) {
    const std::optional<std::int64_t> number = ParseInteger(file.stem().string());
    if (!number || *number <= kLeastNs) return {};
    if (!times_ns.empty() && *number <= times_ns.back()) return {};
    times_ns.push_back(*number);
  }
  return times_ns;
}

}  // namespace cvo
