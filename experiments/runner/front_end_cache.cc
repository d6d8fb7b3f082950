// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/front_end_cache.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <exception>
#include <system_error>
#include <type_traits>
#include <utility>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/json/options_json.h"
#include "core/files/sha256.h"

namespace cvo {

namespace fs = std::filesystem;
namespace {

// Must be incremented with any change to the meaning of the bytes. It is part of the key.
constexpr int kFormat = 4;

static_assert(std::endian::native == std::endian::little,
              "numbers are written as they are in memory");

// Appends the bytes of a number as they are in memory, without padding.
template <typename T>
void AppendNumber(T value, std::string& bytes) {
  static_assert(std::is_arithmetic_v<T>);
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(T));
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

// Takes bytes from the front of the remaining ones. Throws Error if there are too few.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  std::string_view Take(std::size_t count) {
    if (count > bytes_.size()) ThrowError("bytes", StrCat(bytes_.size()), StrCat(count, " more"));
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  template <typename T>
  T Number() {
    T value;
    std::memcpy(&value, Take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

constexpr std::size_t kFeatureBytes = 3 * sizeof(double) + sizeof(std::int32_t) +
                                      6 * sizeof(float) + sizeof(std::uint8_t) +
                                      sizeof(Descriptor) + sizeof(FeaturePatch::pixels);

// Calls `number` for every number of a feature, in the order in which they are stored.
template <typename Feature, typename Number>
void ForEachNumber(Feature& feature, const Number& number) {
  for (auto& coordinate_px : feature.z_px) number(coordinate_px);
  number(feature.octave);
  number(feature.angle_rad);
  number(feature.response);
  number(feature.disagreement_px);
  number(feature.row_offset_px);
  number(feature.is_reserve);
  for (auto& word : feature.descriptor) number(word);
  number(feature.patch.corner_u);
  number(feature.patch.corner_v);
  for (auto& pixel : feature.patch.pixels) number(pixel);
}

}  // namespace

std::string EncodeFrame(const FrontEndFrame& frame) {
  std::string bytes;
  bytes.reserve(64 + frame.features.size() * kFeatureBytes);
  AppendNumber(static_cast<std::uint32_t>(frame.problems.size()), bytes);
  for (const SideProblem& problem : frame.problems) {
    AppendNumber(static_cast<std::int32_t>(problem.side), bytes);
    AppendNumber(static_cast<std::uint32_t>(problem.reason.size()), bytes);
    bytes += problem.reason;
  }
  AppendNumber(static_cast<std::uint32_t>(frame.features.size()), bytes);
  for (const StereoFeature& feature : frame.features) {
    ForEachNumber(feature, [&](const auto& number) { AppendNumber(number, bytes); });
  }
  return bytes;
}

FrontEndFrame DecodeFrame(std::string_view bytes) {
  ByteReader reader(bytes);
  FrontEndFrame frame;
  const auto problems = reader.Number<std::uint32_t>();
  for (std::uint32_t i = 0; i < problems; ++i) {
    SideProblem problem;
    problem.side = reader.Number<std::int32_t>();
    if (problem.side != 0 && problem.side != 1) {
      ThrowError("side of an image pair", StrCat(problem.side), "0 or 1");
    }
    problem.reason = reader.Take(reader.Number<std::uint32_t>());
    frame.problems.push_back(std::move(problem));
  }
  const auto features = reader.Number<std::uint32_t>();
  if (reader.left() != features * kFeatureBytes) {
    ThrowError("features", StrCat(reader.left(), " bytes"), StrCat(features * kFeatureBytes));
  }
  frame.features.reserve(features);
  for (std::uint32_t i = 0; i < features; ++i) {
    ForEachNumber(frame.features.emplace_back(), [&]<typename T>(T& number) {
      using Stored = std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T>;
      number = static_cast<T>(reader.Number<Stored>());
    });
  }
  return frame;
}

std::string FrontEndKey(const FrontEndSettings& settings, const std::vector<ImageHashes>& images) {
  Json image_files = Json::array();
  for (const ImageHashes& pair : images) {
    if (pair.left.empty() || pair.right.empty()) return "";
    image_files.push_back(Json::array({pair.left, pair.right}));
  }
  Json boxes = Json::array();
  for (const std::vector<cv::Rect2d>& of_frame : settings.boxes) {
    boxes.push_back(Json::array());
    for (const cv::Rect2d& box : of_frame) {
      boxes.back().push_back(Json::array({box.x, box.y, box.width, box.height}));
    }
  }
  OrbOptions orb = settings.orb;
  StereoMatchOptions stereo = settings.stereo;
  Json json = {{"format", kFormat},
               {"build", settings.build},
               {"camera", CameraNumbers(settings.camera)},
               {"orb", OptionsToJson(OptionLeaves(orb))},
               {"stereo", OptionsToJson(OptionLeaves(stereo))},
               {"boxes", boxes},
               {"images", image_files}};
  if (settings.rectification) json["rectified"] = settings.rectification->identity();
  const Json perturbation = PerturbationToJson(settings.perturbation);
  if (!perturbation.empty()) {
    json["perturbation"] = perturbation;
    json["first_frame"] = settings.first_frame;
  }
  return Sha256Hex(DumpJson(json));
}

FeatureFile::FeatureFile(fs::path path)
    : path_(std::move(path)), file_(path_, O_RDONLY | O_NONBLOCK) {
  if (file_.get() < 0) ThrowErrno(path_, "read", errno);
}

std::string FeatureFile::Read(std::uint64_t count) {
  struct stat status {};
  const bool known = ::fstat(file_.get(), &status) == 0 && S_ISREG(status.st_mode);
  const auto size_bytes = static_cast<std::uint64_t>(known ? status.st_size : 0);
  if (offset_ > size_bytes || count > size_bytes - offset_) {
    ThrowError(path_.string(), StrCat(size_bytes, " bytes"),
               StrCat(count, " from byte ", offset_, " on"));
  }
  std::string bytes(count, '\0');
  const std::ptrdiff_t read = ReadUpTo(file_, bytes.data(), count, offset_);
  if (read != static_cast<std::ptrdiff_t>(count)) ThrowErrno(path_, "read", read < 0 ? errno : EIO);
  offset_ += count;
  return bytes;
}

FrontEndFrame FeatureFile::Next() {
  const std::string head = Read(sizeof(std::uint64_t) + kHashBytes);
  ByteReader reader(head);
  const std::string bytes = Read(reader.Number<std::uint64_t>());
  if (Sha256Hex(bytes) != reader.Take(kHashBytes)) {
    ThrowError(path_.string(), StrCat("damage before byte ", offset_),
               "the bytes that were written");
  }
  return DecodeFrame(bytes);
}

FeatureRecording::FeatureRecording(const fs::path& file, std::uint64_t limit_bytes, Notice notice)
    : limit_bytes_(limit_bytes), notice_(std::move(notice)) {
  if (limit_bytes_ == 0) return;
  try {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    RemoveLeftovers(file.parent_path());
    file_.emplace(file);
  } catch (const std::exception& error) {
    Stop(error.what());
  }
}

void FeatureRecording::Add(const FrontEndFrame& frame) {
  if (!file_) return;
  const std::string bytes = EncodeFrame(frame);
  std::string head;
  AppendNumber(static_cast<std::uint64_t>(bytes.size()), head);
  try {
    file_->Append(head + Sha256Hex(bytes));
    file_->Append(bytes);
    if (file_->size_bytes() <= limit_bytes_) return;
    Stop(StrCat("more than the ", limit_bytes_, " bytes that the cache may have"));
  } catch (const std::exception& error) {
    Stop(error.what());
  }
}

void FeatureRecording::Finish() {
  if (!file_) return;
  try {
    file_->Complete();
    file_->Publish();
    TrimFolder(file_->target().parent_path(), limit_bytes_);
  } catch (const std::exception& error) {
    Stop(error.what());
  }
}

void FeatureRecording::Stop(const std::string& reason) {
  file_.reset();
  notice_(StrCat("features are not kept for other runs: ", reason));
}

FrontEndCache::FrontEndCache(fs::path folder, std::uint64_t limit_bytes, Notice notice)
    : folder_(std::move(folder)), limit_bytes_(limit_bytes), notice_(std::move(notice)) {}

std::optional<FeatureFile> FrontEndCache::Find(const std::string& key) const {
  std::error_code ignored;
  if (key.empty() || !fs::exists(FileOf(key), ignored)) return std::nullopt;
  try {
    FeatureFile found(FileOf(key));
    MarkUsed(FileOf(key));
    return found;
  } catch (const std::exception& error) {
    Remove(key, error.what());
    return std::nullopt;
  }
}

void FrontEndCache::Remove(const std::string& key, const std::string& reason) const {
  std::error_code error;
  fs::remove(FileOf(key), error);
  notice_(StrCat("cached features are extracted again: ", reason,
                 error ? StrCat(" (cannot remove it: ", error.message(), ")") : ""));
}

FeatureRecording FrontEndCache::Record(const std::string& key) const {
  return {FileOf(key), limit_bytes_, notice_};
}

}  // namespace cvo
