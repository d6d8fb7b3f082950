// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cache/content_hash.h"

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"

namespace cvo {

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
