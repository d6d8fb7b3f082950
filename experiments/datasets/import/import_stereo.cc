// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/import/import_stereo.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cerrno>

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
  void Keep() {
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) ThrowErrno(target_, "write", errno);
  }

 private:
  fs::path target_;
  fs::path temporary_;
};

std::string FrameName(std::size_t frame) {
  constexpr std::size_t kDigits = 6;
  const std::string digits = std::to_string(frame);
  return StrCat(std::string(kDigits - std::min(kDigits, digits.size()), '0'), digits, ".png");
}

struct FrameTimes {
  const char* source = "";
  std::vector<std::int64_t> ns;
};

// Returns the times of the frames: of one per left image, or, of more, by the images' numbers.
std::vector<std::int64_t> TimesOfFile(const StereoImport& request, StereoSource& source) {
  const ImageTimes times = ReadTimes(request.times);
  const std::size_t count = times.ns.size();
  const bool longer = count > source.listed;
  const auto [first, last] = std::ranges::minmax(source.numbers);
  if (count < source.listed ||
      (longer && (first > 1.0 || last - first >= static_cast<double>(count)))) {
    ThrowError(request.times.string(), StrCat(count, " times"),
               StrCat(source.listed,
                      ", one per left image; more if these are numbered from 0 or 1, "
                      "none if their names are times"));
  }
  if (!times.note.empty()) source.notes.push_back(times.note);
  if (longer) {
    source.notes.push_back(StrCat(request.times.string(), ": ", count, " times for ", source.listed,
                                  " images: those of ", first, " to ", last));
  }
  std::vector<std::int64_t> of_frames;
  for (const std::size_t i : source.kept) {
    of_frames.push_back(times.ns[longer ? static_cast<std::size_t>(source.numbers[i] - first) : i]);
  }
  return of_frames;
}

FrameTimes TimesOf(const StereoImport& request, StereoSource& source) {
  FrameTimes times{"names", source.times_ns};
  if (!request.times.empty()) times = {"file", TimesOfFile(request, source)};
  if (!times.ns.empty()) {
    if (!request.rate_hz) return times;
    ThrowError("--rate", StrCat("times in a ", request.times.empty() ? "name" : "file", " as well"),
               "one of the two");
  }
  if (request.rate_hz) return {"rate", NominalTimes(source.kept.size(), *request.rate_hz)};
  return {"nominal", NominalTimes(source.kept.size())};
}

std::string TimesText(const FrameTimes& times) {
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

Json NamesOf(const std::vector<fs::path>& files) {
  Json names = Json::array();
  for (const fs::path& file : files) names.push_back(file.filename().string());
  return names;
}

// Empty if there is no such file: reading it then tells what is wrong.
std::string HashFile(const fs::path& file) {
  return fs::is_regular_file(file) ? Sha256Hex(ReadFileBytes(file)) : "";
}

// The hashes of the files, one after the other.
std::string CalibrationHash(const StereoImport& request) {
  std::string hash;
  for (const fs::path& file : request.calibration) hash += HashFile(file);
  return hash;
}

Json Record(const StereoImport& request, const ImportOutcome& outcome,
            const std::optional<Rectification>& rectification) {
  Json record = {{"schema_version", 1},
                 {"kind", "import"},
                 {"calibration", NamesOf(request.calibration)},
                 {"calibration_sha256", CalibrationHash(request)},
                 {"frames", outcome.frames},
                 {"times", outcome.times},
                 {"rectified", outcome.rectified}};
  if (rectification) {
    record["rectified_from_left"] = RowsOf(rectification->rectified_from_left());
    record["rectified_from_right"] = RowsOf(rectification->rectified_from_right());
  }
  return record;
}

void AddImages(const fs::path& folder, Sha256& hash) {
  for (const fs::path& file : ListImages(folder)) {
    hash.Add(file.filename().string() + "\n" + HashFile(file) + "\n");
  }
}

// Returns "kitchen" for kitchen/left.
std::string NameOf(const fs::path& left) {
  const std::string name = fs::absolute(left).lexically_normal().parent_path().filename().string();
  return name.empty() ? "stereo" : name;
}

}  // namespace

ImportOutcome ImportStereo(const StereoImport& request, const fs::path& folder,
                           const ImportProgress& progress) {
  const std::vector<fs::path>& calibration = request.calibration;
  const StereoRig rig =
      ReadStereoRig(calibration.at(0), calibration.size() > 1 ? calibration[1] : "");
  StereoSource source = FindStereo(request.left, request.right);
  const auto& files = source.files;
  const FrameTimes times = TimesOf(request, source);
  NewFolder target(folder);
  std::optional<Rectification> rectification;
  ImportOutcome outcome;
  outcome.times = times.source;
  outcome.rectified = !IsRectified(rig);
  cv::Size size;
  for (; outcome.frames < files[0].size(); ++outcome.frames) {
    for (std::size_t side = 0; side < 2; ++side) {
      const fs::path& file = files[side][outcome.frames];
      SourceImage image = ReadSourceImage(file);
      if (size.empty()) {
        size = image.size;
        CheckCameras(rig, size.width, size.height, calibration[0].string());
        if (outcome.rectified) rectification.emplace(rig, size);
        outcome.camera =
            rectification ? rectification->camera() : CameraOf(rig, size.width, size.height);
      }
      if (image.size != size) {
        ThrowError(file.string(), StrCat(image.size.width, "x", image.size.height, " px"),
                   StrCat(size.width, "x", size.height, " px, as the first image"));
      }
      if (!image.damage.empty()) {
        outcome.damaged.push_back(StrCat("frame ", outcome.frames, ": ", image.damage));
      } else if (rectification) {
        image.grey = side == 0 ? rectification->Left(image.grey) : rectification->Right(image.grey);
      }
      target.Write(StrCat("image_", side, "/", FrameName(outcome.frames)), image);
    }
    progress(outcome.frames + 1, files[0].size());
  }
  target.Write("times.txt", TimesText(times));
  target.Write("calib.txt", CalibrationText(outcome.camera));
  Json record = Record(request, outcome, rectification);
  record["left_images"] = NamesOf(files[0]);  // in the order of the frames
  record["right_images"] = NamesOf(files[1]);
  record["notes"] = source.notes;
  target.Write(kImportRecord, DumpJson(record));
  target.Keep();
  return outcome;
}

fs::path ImportIntoCache(const StereoImport& request, const fs::path& cache,
                         const ImportProgress& progress) {
  constexpr const char* kMadeBy =
      "import 5\n";  // to be changed if the same input yields other images or an error
  constexpr std::size_t kShortHash = 16;
  Sha256 hash;
  hash.Add(kMadeBy);
  hash.Add(CalibrationHash(request));
  if (!request.times.empty()) hash.Add(HashFile(request.times));
  hash.Add(request.rate_hz ? "rate " + FormatDouble(*request.rate_hz) : "10");
  AddImages(request.left, hash);
  AddImages(request.right, hash);
  const fs::path folder =
      cache / "imported" / hash.Hex().substr(0, kShortHash) / NameOf(request.left);
  if (fs::exists(folder)) return folder;  // which appeared complete
  ImportStereo(request, folder, progress);
  return folder;
}

}  // namespace cvo
