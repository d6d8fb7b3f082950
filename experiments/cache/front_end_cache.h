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

// What decides the front end's output beside the images.
struct FrontEndSettings {
  std::string build;  // BuildInfo::identity
  StereoCamera camera;
  OrbOptions orb;
  StereoMatchOptions stereo;
  std::vector<std::vector<cv::Rect2d>> boxes = {};  // where bodies may be, by frame
  Perturbation perturbation = {};
  std::shared_ptr<const Rectification> rectification = {};
  int first_frame = 0;  // decides what is drawn for it
};

// The name of a sequence's front-end output; empty where an image could not be read, since what
// that gives is not decided by bytes.
std::string FrontEndKey(const FrontEndSettings& settings, const std::vector<ImageHashes>& images);

// A sequence's frames on their way to the cache. What goes wrong ends the recording with a notice
// and nothing else.
class FrontEndRecording {
 public:
  FrontEndRecording(std::filesystem::path folder, std::uint64_t limit_bytes, Notice notice);

  void Add(const FrontEndFrame& frame);
  // The entry appears. Without this call, or with an empty key, there is none.
  void Finish(const std::string& key);

 private:
  void StopRecording(const std::string& reason);

  std::filesystem::path folder_;
  std::uint64_t limit_bytes_;
  Notice notice_;
  std::unique_ptr<FeatureFileWriter> writer_;  // null: given up
};

// Front-end output of whole sequences in a folder that any number of processes use at once. Its
// troubles never fail a run: an entry that cannot be read counts as absent, is removed, and
// `notice` is told.
class FrontEndCache {
 public:
  // Files beyond `limit_bytes` go, those used longest ago first. 0: nothing is kept.
  FrontEndCache(std::filesystem::path folder, std::uint64_t limit_bytes, Notice notice);

  std::optional<FeatureFile> Find(const std::string& key, std::size_t frames) const;
  // Found damaged when it was read.
  void Remove(const std::string& key, const std::string& reason) const;
  FrontEndRecording Record() const { return {folder_, limit_bytes_, notice_}; }

 private:
  std::filesystem::path folder_;
  std::uint64_t limit_bytes_;
  Notice notice_;
};

}  // namespace cvo
