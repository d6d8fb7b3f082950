// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/import/import_stereo.h"

#include <Eigen/Core>
#include <algorithm>
#include <cerrno>
#include <exception>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/images/image_file.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/calibration/rig_file.h"
#include "experiments/datasets/calibration/stereo_rig.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/import/stereo_source.h"

namespace cvo {

namespace fs = std::filesystem;
namespace {

// A folder under a temporary name, which is removed unless it is kept.
class NewFolder {
 public:
  explicit NewFolder(const fs::path& target) : target_(target), temporary_(TemporaryName(target)) {
    if (fs::exists(target)) ThrowError(target.string(), "a folder or file", "a new folder");
    if (target.has_parent_path()) fs::create_directories(target.parent_path());
    fs::create_directories(temporary_ / "image_0");
    fs::create_directories(temporary_ / "image_1");
  }
  ~NewFolder() {
    std::error_code ignored;
    fs::remove_all(temporary_, ignored);
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  void Write(const std::string& name, std::string_view bytes) {
    WriteFileBytes(temporary_ / name, bytes);
    files_[name] = Sha256Hex(bytes);
  }
  // Writes an image. A damaged one becomes a file that cannot be decoded: the header alone.
  void Write(const std::string& name, const SourceImage& image) {
    constexpr std::size_t kHeader = 33;  // signature and first chunk of a PNG file
    const cv::Mat grey =
        image.damage.empty() ? image.grey : cv::Mat(image.size, CV_8UC1, cv::Scalar(0));
    std::string png = EncodeImage(".png", grey);
    if (!image.damage.empty()) png.resize(kHeader);
    Write(name, png);
  }
  // The SHA-256 of each written file, by name.
  const Json& files() const { return files_; }
  void Keep() {
    if (RenameFile(temporary_, target_) != 0) ThrowErrno(target_, "write", errno);
  }

 private:
  fs::path target_;
  fs::path temporary_;
  Json files_ = Json::object();
};

std::string FrameName(std::size_t frame) {
  constexpr std::size_t kDigits = 6;
  const std::string digits = std::to_string(frame);
  return StrCat(std::string(kDigits - std::min(kDigits, digits.size()), '0'), digits, ".png");
}

// Reads pairs of images, all of the same size.
class PairReader {
 public:
  explicit PairReader(const StereoImport& request)
      : request_(request), left_(OpenImages(request.left)), right_(OpenImages(request.right)) {
    CheckPartners(left_->files(), right_->files());
    if (left_->size() != right_->size()) {
      ThrowError(request.right.string(), StrCat(right_->size(), " images"),
                 StrCat(left_->size(), ", as many as in ", request.left.string()));
    }
  }

  std::size_t size() const { return left_->size(); }
  const ImageSource& left() const { return *left_; }
  const ImageSource& right() const { return *right_; }

  // Returns false at the end.
  bool Next(SourceImage& left, SourceImage& right) {
    left = left_->Next();
    right = right_->Next();
    if (left.size.empty() != right.size.empty()) {
      ThrowError((left.size.empty() ? request_.left : request_.right).string(),
                 StrCat("an end after ", read_, " images"),
                 "as many images as of the other camera");
    }
    if (left.size.empty()) return false;
    if (size_.empty()) size_ = left.size;
    if (left.size != size_ || right.size != size_) {
      const cv::Size found = left.size != size_ ? left.size : right.size;
      ThrowError(
          StrCat((left.size != size_ ? request_.left : request_.right).string(), ", image ", read_),
          StrCat(found.width, "x", found.height, " px"),
          StrCat(size_.width, "x", size_.height, " px, as the first image"));
    }
    ++read_;
    return true;
  }

 private:
  const StereoImport& request_;
  std::unique_ptr<ImageSource> left_;
  std::unique_ptr<ImageSource> right_;
  std::size_t read_ = 0;
  cv::Size size_;
};

struct Times {
  const char* source = "";
  std::vector<std::int64_t> ns;
};

Times TimesOf(const StereoImport& request, const ImageSource& left, std::size_t count) {
  constexpr double kUsual_hz = 10.0;
  Times times{"names", TimesOfNames(left.files())};
  if (!request.times.empty()) times = {"file", ReadTimes(request.times, count)};
  if (!times.ns.empty()) {
    if (!request.rate_hz) return times;
    ThrowError("--rate", StrCat("times in a ", request.times.empty() ? "name" : "file", " as well"),
               "one of the two");
  }
  if (request.rate_hz) return {"rate", NominalTimes(count, *request.rate_hz)};
  if (left.rate_hz() > 0.0) return {"video", NominalTimes(count, left.rate_hz())};
  return {"nominal", NominalTimes(count, kUsual_hz)};
}

std::string TimesText(const Times& times) {
  std::string lines;
  for (const std::int64_t time_ns : times.ns) lines += FormatSecondsNs(time_ns) + "\n";
  return lines;
}

std::string CalibrationText(const StereoCamera& camera) {
  const auto row = [&](const char* key, double offset_px) {
    std::string text = key;
    for (const double value : {camera.fx, 0.0, camera.cx, offset_px, 0.0, camera.fy, camera.cy, 0.0,
                               0.0, 0.0, 1.0, 0.0}) {
      text += ' ';
      text += FormatDouble(value);
    }
    return text + "\n";
  };
  return row("P0:", 0.0) + row("P1:", -camera.fx * camera.baseline_m);
}

Json RowsOf(const Eigen::Matrix3d& matrix) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back({matrix(i, 0), matrix(i, 1), matrix(i, 2)});
  return rows;
}

// Records damage to an image of the current frame.
void NoteDamage(const SourceImage& image, ImportOutcome& outcome) {
  if (image.damage.empty()) return;
  outcome.damaged.push_back(StrCat("frame ", outcome.frames, ": ", image.damage));
}

Json NamesOf(const ImageSource& source) {
  Json names = Json::array();
  for (const fs::path& file : source.files()) names.push_back(file.filename().string());
  return names;
}

Json Record(const StereoImport& request, const ImportOutcome& outcome,
            const std::optional<Rectification>& rectification) {
  Json record = {{"schema_version", 1},
                 {"kind", "import"},
                 {"calibration", request.calibration.filename().string()},
                 {"calibration_sha256", Sha256Hex(ReadFileBytes(request.calibration))},
                 {"frames", outcome.frames},
                 {"times", outcome.times},
                 {"rectified", outcome.rectified}};
  if (rectification) {
    record["rectified_from_left"] = RowsOf(rectification->rectified_from_left());
    record["rectified_from_right"] = RowsOf(rectification->rectified_from_right());
  }
  return record;
}

// Empty if there is no such file: reading it then tells what is wrong.
std::string HashFile(const fs::path& file) {
  return fs::is_regular_file(file) ? Sha256Hex(ReadFileBytes(file)) : "";
}

void AddImages(const fs::path& path, Sha256& hash) {
  if (!fs::is_directory(path)) {
    hash.Add(HashFile(path));
    return;
  }
  for (const fs::path& file : OpenImages(path)->files()) {
    hash.Add(file.filename().string() + "\n" + HashFile(file) + "\n");
  }
}

// Returns "kitchen" for kitchen/left.
std::string NameOf(const fs::path& left) {
  const std::string name = fs::absolute(left).lexically_normal().parent_path().filename().string();
  return name.empty() ? "stereo" : name;
}

bool IsWhole(const fs::path& folder) try {
  const Json record = ReadJson(folder / kImportRecord);
  for (const auto& [name, sha256] : record.at("files").items()) {
    if (HashFile(folder / name) != sha256) return false;
  }
  return true;
} catch (const std::exception&) {  // also those of the JSON library
  return false;
}

}  // namespace

ImportOutcome ImportStereo(const StereoImport& request, const fs::path& folder,
                           const ImportProgress& progress) {
  const StereoRig rig = ReadStereoRig(request.calibration);
  PairReader pairs(request);
  // Detects errors in the times early. For a video this is not possible, as it may not have as many
  // frames as it states.
  if (!pairs.left().files().empty()) (void)TimesOf(request, pairs.left(), pairs.size());
  NewFolder target(folder);
  std::optional<Rectification> rectification;
  ImportOutcome outcome;
  outcome.rectified = !IsRectified(rig);
  SourceImage left;
  SourceImage right;
  while (pairs.Next(left, right)) {
    if (outcome.frames == 0) {
      CheckCameras(rig, left.size.width, left.size.height, request.calibration.string());
      if (outcome.rectified) rectification.emplace(rig, left.size);
      outcome.camera = rectification ? rectification->camera()
                                     : CameraOf(rig, left.size.width, left.size.height);
    }
    if (rectification && left.damage.empty()) left.grey = rectification->Left(left.grey);
    if (rectification && right.damage.empty()) right.grey = rectification->Right(right.grey);
    NoteDamage(left, outcome);
    NoteDamage(right, outcome);
    target.Write("image_0/" + FrameName(outcome.frames), left);
    target.Write("image_1/" + FrameName(outcome.frames), right);
    progress(++outcome.frames, pairs.size());
  }
  const Times times = TimesOf(request, pairs.left(), outcome.frames);
  outcome.times = times.source;
  target.Write("times.txt", TimesText(times));
  target.Write("calib.txt", CalibrationText(outcome.camera));
  Json record = Record(request, outcome, rectification);
  // Both are in the order of the frames, and empty for a video.
  record["left_images"] = NamesOf(pairs.left());
  record["right_images"] = NamesOf(pairs.right());
  record["files"] = target.files();
  target.Write(kImportRecord, DumpJson(record));
  target.Keep();
  return outcome;
}

fs::path ImportIntoCache(const StereoImport& request, const fs::path& cache,
                         const ImportProgress& progress) {
  constexpr const char* kMadeBy =
      "import 2\n";  // to be changed if the same input yields other images or an error
  constexpr std::size_t kShortHash = 16;
  Sha256 hash;
  hash.Add(kMadeBy);
  hash.Add(HashFile(request.calibration));
  if (!request.times.empty()) hash.Add(HashFile(request.times));
  hash.Add(request.rate_hz ? "rate " + FormatDouble(*request.rate_hz) : "10");
  AddImages(request.left, hash);
  AddImages(request.right, hash);
  const fs::path folder =
      cache / "imported" / hash.Hex().substr(0, kShortHash) / NameOf(request.left);
  if (IsWhole(folder)) return folder;
  fs::remove_all(folder);
  ImportStereo(request, folder, progress);
  return folder;
}

}  // namespace cvo
