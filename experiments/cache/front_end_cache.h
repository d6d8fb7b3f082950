// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/features/options.h"
#include "core/geometry/stereo_camera.h"
#include "experiments/cache/cache_size.h"
#include "experiments/cache/content_hash.h"
#include "experiments/cache/feature_file.h"

namespace cvo {

// What determines the output of the front end, besides the images.
struct FrontEndSettings {
  std::string build;  // BuildInfo::identity
  StereoCamera camera;
  OrbOptions orb;
  StereoMatchOptions stereo;
  std::vector<std::vector<cv::Rect2d>> boxes = {};  // [frame], where bodies may be
  Perturbation perturbation = {};
  std::shared_ptr<const Rectification> rectification = {};
  int first_frame = 0;  // determines the random choices of the perturbation
};

// Returns the cache key of a sequence's front-end output. Empty if an image could not be read, as
// file contents do not determine the output then.
std::string FrontEndKey(const FrontEndSettings& settings, const std::vector<ImageHashes>& images);

// Records the frames of a sequence for the cache. An error ends the recording with a notice, and
// has no other effect.
class FrontEndRecording {
 public:
  FrontEndRecording(std::filesystem::path folder, std::uint64_t limit_bytes, Notice notice);

  void Add(const FrontEndFrame& frame);
  // Adds the first frames of a file that was found damaged after them.
  void AddFrames(const FeatureFile& file, std::size_t count);
  // Publishes the entry. Without this call, or with an empty key, there is no entry.
  void Finish(const std::string& key);

 private:
  void StopRecording(const std::string& reason);

  std::filesystem::path folder_;
  std::uint64_t limit_bytes_;
  Notice notice_;
  std::unique_ptr<FeatureFileWriter> writer_;  // null: not recording
};

// Front-end output of whole sequences, in a folder that any number of processes may use at once.
// Errors of the cache never fail a run: an entry that cannot be read counts as absent and is
// removed, and `notice` is told.
class FrontEndCache {
 public:
  // Removes the least recently used files beyond `limit_bytes`. 0: nothing is kept.
  FrontEndCache(std::filesystem::path folder, std::uint64_t limit_bytes, Notice notice);

  std::optional<FeatureFile> Find(const std::string& key, std::size_t frames) const;
  // Removes an entry that was found damaged on reading.
  void Remove(const std::string& key, const std::string& reason) const;
  FrontEndRecording Record() const { return {folder_, limit_bytes_, notice_}; }

 private:
  std::filesystem::path folder_;
  std::uint64_t limit_bytes_;
  Notice notice_;
};

}  // namespace cvo
