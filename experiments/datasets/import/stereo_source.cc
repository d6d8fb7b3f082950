// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/import/stereo_source.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/formats/image_format.h"
#include "experiments/datasets/images.h"

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
    if (number.empty()) return {};
    const auto [same, added] = by_number.emplace(number, file);
    if (added) continue;
    if (!IsNumber(file) || !IsNumber(same->second)) return {};
    ThrowError(file.string(), "the number of " + same->second.filename().string(), "another one");
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

// The times in the names of files. None unless all names are numbers, with a decimal point or as
// large as those of clocks, which those of frames are not.
ImageTimes TimesOfNames(const Files& files, const fs::path& folder) {
  constexpr double kLeastClock = 1e8;
  const std::map<double, fs::path> by_value = ByValue(files);
  const auto has_point = [](const fs::path& file) {
    return file.stem().string().find('.') != std::string::npos;
  };
  if (by_value.empty() || !std::ranges::all_of(files, IsNumber) ||
      (by_value.begin()->first < kLeastClock && std::ranges::none_of(files, has_point))) {
    return {};
  }
  std::vector<std::string> stems;
  for (const fs::path& file : files) stems.push_back(file.stem().string());
  const std::string where = folder.string() + ", names of images";
  const TimeUnit unit = ImageTimeUnit({stems.begin(), stems.end()}, where);
  ImageTimes times{{}, UnitNote(unit, where)};
  for (const std::string& stem : stems) times.ns.push_back(ParseTimeNs(stem, unit.ns).value_or(-1));
  return times;
}

bool IsImage(const fs::path& file) {
  constexpr std::array<const char*, 7> kEndings = {".png",  ".jpg", ".jpeg", ".pgm",
                                                   ".tiff", ".tif", ".bmp"};
  return std::find(kEndings.begin(), kEndings.end(), LowerExtension(file)) != kEndings.end();
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
  if (std::ranges::none_of(of_left, is_shared) && std::ranges::all_of(left, IsNumber) &&
      std::ranges::all_of(right, IsNumber)) {
    return;
  }
  CheckAllIn(of_right, left);
  CheckAllIn(of_left, right);
}

Files ListImages(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    ThrowError(folder.string(), fs::exists(folder) ? "a file" : "no such folder",
               "a folder of images");
  }
  Files files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with('.')) continue;
    if (entry.is_regular_file() && IsImage(entry.path())) files.push_back(entry.path());
  }
  if (files.empty()) ThrowError(folder.string(), "no image", "a folder of images");
  SortByNumber(files);
  return files;
}

SourceImage ReadSourceImage(const fs::path& file) {
  const std::string bytes = ReadFileBytes(file);
  if (const std::optional<std::string> damage = FindDamage(bytes)) {
    return DamagedImage(file, *damage);
  }
  const cv::Mat grey = DecodeGrey(bytes);
  if (grey.type() == CV_8UC1 && !grey.empty()) return {grey, grey.size(), ""};
  if (IsPng(bytes) || IsJpegFile(bytes)) return DamagedImage(file, "damaged pixels");
  ThrowError(file.string(), "no image that can be decoded", "one");
}

StereoSource FindStereo(const fs::path& left, const fs::path& right) {
  StereoSource source{{ListImages(left), ListImages(right)}};
  auto& files = source.files;
  source.listed = files[0].size();
  const bool numbered = !ByNumber(files[0]).empty();
  for (std::size_t i = 0; i < source.listed; ++i) {
    source.numbers.push_back(numbered ? *ParseDouble(NumberOf(files[0][i]))
                                      : static_cast<double>(i));
  }
  const ImageTimes of_left = TimesOfNames(files[0], left);
  const ImageTimes of_right = TimesOfNames(files[1], right);
  if (of_left.ns.empty() || of_right.ns.empty()) {
    CheckPartners(files[0], files[1]);
    if (files[0].size() != files[1].size()) {
      ThrowError(right.string(), StrCat(files[1].size(), " images"),
                 StrCat(files[0].size(), ", as many as in ", left.string()));
    }
    source.kept.resize(source.listed);
    std::iota(source.kept.begin(), source.kept.end(), std::size_t{0});
    return source;
  }
  if (!of_left.note.empty()) source.notes.push_back(of_left.note);
  const auto all = std::move(files);
  files = {};
  for (const auto& [i, j] : PairByTime(of_left.ns, of_right.ns, right, source.notes)) {
    files[0].push_back(all[0][i]);
    files[1].push_back(all[1][j]);
    source.kept.push_back(i);
    source.times_ns.push_back(of_left.ns[i]);
  }
  return source;
}

}  // namespace cvo
