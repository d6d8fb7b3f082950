// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/identity.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <Eigen/Core>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <opencv2/core/utility.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "build_sources.h"
#include "build_tools.h"
#include "core/base/error.h"
#include "core/base/task_pool.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"

namespace cvo {

namespace {

// Our own code computes the same with and without AVX2, but the C library and OpenCV may not.
std::string CpuLevel() {
  const bool is_fast =
      cv::checkHardwareSupport(CV_CPU_AVX2) && cv::checkHardwareSupport(CV_CPU_FMA3);
  return is_fast ? "avx2" : StrCat("plain ", kProcessor);
}

reports::BuildInfo IdentifyBuild() {
  reports::BuildInfo build;
  build.version = kVersion;
  build.estimator_sources = kEstimatorSources;
  build.evaluation_sources = kEvaluationSources;
  build.compiler = kCompiler;
  build.build_type = kBuildType;
  build.flags = kFlags;
  build.libraries = {cv::getVersionString(), StrCat(EIGEN_WORLD_VERSION, ".", EIGEN_MAJOR_VERSION,
                                                    ".", EIGEN_MINOR_VERSION)};
  build.cpu_level = CpuLevel();
  build.commit = kCommit;
  build.identity = reports::IdentityOf(build);
  return build;
}

}  // namespace

const reports::BuildInfo& ThisBuild() {
  static const reports::BuildInfo build = IdentifyBuild();
  return build;
}

std::string DetectionsHash(const Sequence& sequence) {
  Json boxes = Json::array();
  for (const ObjectBox& box : sequence.detections) {
    boxes.push_back({box.frame, box.type, box.left_px, box.top_px, box.right_px, box.bottom_px,
                     box.score ? Json(*box.score) : Json(nullptr)});
  }
  return Sha256Hex(DumpJson({{"offset_m", sequence.detections_offset_m}, {"boxes", boxes}}));
}

Json GivenToJson(const std::vector<std::string>& classes, const std::vector<std::string>& oracle) {
  return {{"classes", classes}, {"oracle", oracle}};
}

Json CameraNumbers(const StereoCamera& camera) {
  return {camera.fx,         camera.fy,       camera.cx,        camera.cy,
          camera.baseline_m, camera.width_px, camera.height_px, camera.right_shift_px};
}

std::string ContentHash(const Sequence& sequence, const std::vector<ImageHashes>& images) {
  Require(images.size() == sequence.images.size(), "ContentHash: one entry per frame");
  Json other_files = Json::array();
  for (const std::filesystem::path& file : sequence.other_files) {
    other_files.push_back(Sha256Hex(ReadFileBytes(file)));
  }
  Json rows = Json::array();
  for (const ImageHashes& image : images) rows.push_back(Json::array({image.left, image.right}));
  Json json = {{"name", sequence.name},
               {"type", sequence.type},
               {"pair", sequence.pair},
               {"groundtruth", sequence.groundtruth},
               {"first_frame", sequence.first_frame},
               {"total_frames", sequence.total_frames},
               {"camera", CameraNumbers(sequence.camera)},
               {"timestamps_ns", sequence.timestamps_ns},
               {"other_files", other_files},
               {"images", rows}};
  if (!sequence.layout.empty()) json["layout"] = sequence.layout;
  const Json perturbation = PerturbationToJson(sequence.perturbation);
  if (!perturbation.empty()) json["perturbation"] = perturbation;
  return Sha256Hex(DumpJson(json));
}

std::string ImagesHash(const std::vector<ImageHashes>& images) {
  Sha256 hash;
  for (const ImageHashes& image : images) hash.Add(StrCat(image.left, " ", image.right, "\n"));
  return images.empty() ? "" : hash.Hex();
}

namespace fs = std::filesystem;

std::uint64_t CacheLimit() {
  constexpr std::string_view kUnits = "KMGT";
  constexpr double kLargest_bytes = 1e18;
  const char* variable = std::getenv("CLUSTERVO_CACHE_SIZE");
  const std::string text = variable == nullptr || *variable == '\0' ? "20G" : variable;
  const std::size_t letter = kUnits.find(text.back());
  const double unit =
      letter == kUnits.npos ? 1.0 : std::pow(1000.0, static_cast<double>(letter) + 1.0);
  const std::optional<double> value =
      ParseDouble(letter == kUnits.npos ? text : text.substr(0, text.size() - 1));
  if (!value || *value < 0.0 || *value * unit > kLargest_bytes) {
    ThrowError("CLUSTERVO_CACHE_SIZE", Quoted(text), "a size in bytes, such as 500M or 20G");
  }
  return static_cast<std::uint64_t>(*value * unit);
}

void MarkUsed(const fs::path& file) { (void)::utimensat(AT_FDCWD, file.c_str(), nullptr, 0); }

void TrimFolder(const fs::path& folder, std::uint64_t limit_bytes) {
  struct Entry {
    fs::file_time_type used;
    fs::path path;
    std::uint64_t size_bytes;
  };
  std::vector<Entry> entries;
  std::uint64_t total_bytes = 0;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    std::error_code gone;
    if (IsTemporary(file.path()) || !file.is_regular_file(gone)) continue;
    const Entry entry = {file.last_write_time(gone), file.path(), file.file_size(gone)};
    if (gone) continue;
    total_bytes += entry.size_bytes;
    entries.push_back(entry);
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.used, a.path) < std::tie(b.used, b.path);
  });
  for (const Entry& entry : entries) {
    if (total_bytes <= limit_bytes) return;
    if (::unlink(entry.path.c_str()) == 0 || errno == ENOENT) total_bytes -= entry.size_bytes;
  }
}

namespace {

std::string HashFile(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) ? Sha256Hex(ReadFileBytes(file)) : "";
}

}  // namespace

std::vector<ImageHashes> HashImages(const Sequence& sequence) {
  std::vector<ImageHashes> images(sequence.images.size());
  TaskPool(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())))
      .ParallelFor(static_cast<int>(images.size()), [&](int i) {
        const auto frame = static_cast<std::size_t>(i);
        images[frame] = {HashFile(sequence.images[frame].left),
                         HashFile(sequence.images[frame].right)};
      });
  return images;
}

}  // namespace cvo
