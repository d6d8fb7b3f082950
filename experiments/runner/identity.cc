// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/identity.h"

#include <Eigen/Core>
#include <opencv2/core/utility.hpp>

#include "build_sources.h"
#include "build_tools.h"
#include "core/base/error.h"
#include "core/features/cpu_level.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"

namespace cvo {

namespace {

BuildIdentity IdentifyBuild() {
  BuildIdentity build;
  build.version = kVersion;
  build.estimator_sources = kEstimatorSources;
  build.evaluation_sources = kEvaluationSources;
  build.compiler = kCompiler;
  build.build_type = kBuildType;
  build.flags = kFlags;
  build.libraries = {cv::getVersionString(), StrCat(EIGEN_WORLD_VERSION, ".", EIGEN_MAJOR_VERSION,
                                                    ".", EIGEN_MINOR_VERSION)};
  build.cpu_level = CpuLevelName();
  build.commit = kCommit;
  build.identity = IdentityOf(build);
  return build;
}

}  // namespace

std::string IdentityOf(const BuildIdentity& build) {
  JsonWriter fields;
  BuildIdentity::VisitIdentity(build, fields);
  return Sha256Hex(DumpJson(fields.Take()));
}

const BuildIdentity& ThisBuild() {
  static const BuildIdentity build = IdentifyBuild();
  return build;
}

std::string IdentityHead(const std::string& build, const std::string& variant,
                         const Json& options) {
  const std::string text = DumpJson({{"build", build}, {"variant", variant}, {"options", options}});
  return text.substr(0, text.rfind("\n}")) + ",";
}

// The hash of a JSON object whose first members are those of the head.
std::string JobIdentity(const std::string& head, const JobInput& input) {
  const std::string text = DumpJson({{"content", input.content},
                                     {"detections", input.detections},
                                     {"given", input.given},
                                     {"seed", input.seed}});
  return Sha256Hex(head + text.substr(1));
}

std::string JobIdentity(const Job& job) {
  return JobIdentity(IdentityHead(job.build, job.variant, job.options),
                     {job.content, job.detections, job.given, job.seed});
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

std::string HashFile(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return "";
  return Sha256Hex(ReadFileBytes(file));
}

ImageHashes HashPair(const StereoPaths& pair) {
  return {HashFile(pair.left), HashFile(pair.right)};
}

std::vector<ImageHashes> HashImages(const Sequence& sequence) {
  std::vector<ImageHashes> images;
  for (const StereoPaths& pair : sequence.images) images.push_back(HashPair(pair));
  return images;
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
  const Json json = {{"name", sequence.name},
                     {"type", sequence.type},
                     {"pair", sequence.pair},
                     {"groundtruth", sequence.groundtruth},
                     {"first_frame", sequence.first_frame},
                     {"total_frames", sequence.total_frames},
                     {"camera", CameraNumbers(sequence.camera)},
                     {"timestamps_ns", sequence.timestamps_ns},
                     {"other_files", other_files}};
  Json behind = Json::object();
  if (!sequence.layout.empty()) behind["layout"] = sequence.layout;
  const Json perturbation = PerturbationToJson(sequence.perturbation);
  if (!perturbation.empty()) behind["perturbation"] = perturbation;

  Sha256 hash;
  std::size_t frame = 0;
  const auto next = [&](Json& row) {
    if (frame == images.size()) return false;
    row = Json::array({images[frame].left, images[frame].right});
    ++frame;
    return true;
  };
  DumpJsonWithRows(
      json, "images", next, [&hash](std::string_view part) { hash.Add(part); }, behind);
  return hash.Hex();
}

}  // namespace cvo
