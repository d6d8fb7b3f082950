// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/import/stereo_source.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/files/images/image_codec.h"
#include "core/files/images/video.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/image_header.h"
#include "experiments/datasets/formats/png.h"
#include "experiments/import/image_names.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

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
    if (!video_.ok() || size() == 0) {
      ThrowError(file.string(), "no video that can be decoded",
                 "a video file or a folder of images");
    }
  }

  std::size_t size() const override {
    return static_cast<std::size_t>(std::max(0.0, video_.Get(cv::CAP_PROP_FRAME_COUNT)));
  }
  double rate_hz() const override { return std::max(0.0, video_.Get(cv::CAP_PROP_FPS)); }
  SourceImage Next() override {
    const cv::Mat image = video_.Next();
    if (image.empty()) return {};
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
  VideoReader video_;
};

}  // namespace

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
