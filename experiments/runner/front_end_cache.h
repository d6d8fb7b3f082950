// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/features/options.h"
#include "core/features/stereo_feature.h"
#include "core/files/atomic_file.h"
#include "core/geometry/stereo_camera.h"
#include "experiments/runner/file_hashes.h"
#include "experiments/runner/identity.h"

namespace cvo {

// An image of a pair that cannot be decoded.
struct SideProblem {
  int side = 0;        // 0 left, 1 right
  std::string reason;  // what was found and what was expected, without the path
};

// The output of the front end for the pixels of one stereo pair.
struct FrontEndFrame {
  std::vector<StereoFeature> features;
  std::vector<SideProblem> problems;  // if not empty, there are no features
};

// Encodes the frame with every number exact. DecodeFrame throws Error for any other bytes.
std::string EncodeFrame(const FrontEndFrame& frame);
FrontEndFrame DecodeFrame(std::string_view bytes);

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

// An entry of the cache that is read: for each frame its size, its SHA-256 and its bytes.
class FeatureFile {
 public:
  // Throws Error if the file cannot be opened.
  explicit FeatureFile(std::filesystem::path path);

  // Reads the next frame. Throws Error if its bytes are not those that were written.
  FrontEndFrame Next();

 private:
  std::string Read(std::uint64_t count);

  std::filesystem::path path_;
  FileDescriptor file_;
  std::uint64_t offset_ = 0;
};

// Records the frames of a sequence for the cache. An error ends the recording with a notice, and
// has no other effect. Without Finish there is no entry.
class FeatureRecording {
 public:
  FeatureRecording(const std::filesystem::path& file, std::uint64_t limit_bytes, Notice notice);

  void Add(const FrontEndFrame& frame);
  void Finish();

 private:
  void Stop(const std::string& reason);

  std::uint64_t limit_bytes_;
  Notice notice_;
  std::optional<StagedFile> file_;  // empty: not recording
};

// Front-end output of whole sequences, in a folder that any number of processes may use at once.
// Errors of the cache never fail a run: an entry that cannot be read counts as absent and is
// removed, and `notice` is told.
class FrontEndCache {
 public:
  // Removes the least recently used files beyond `limit_bytes`. 0: nothing is kept.
  FrontEndCache(std::filesystem::path folder, std::uint64_t limit_bytes, Notice notice);

  // Empty if there is no entry, and always for an empty key.
  std::optional<FeatureFile> Find(const std::string& key) const;
  // Removes an entry that was found damaged on reading.
  void Remove(const std::string& key, const std::string& reason) const;
  FeatureRecording Record(const std::string& key) const;

 private:
  std::filesystem::path FileOf(const std::string& key) const {
    return folder_ / (key + ".features");
  }

  std::filesystem::path folder_;
  std::uint64_t limit_bytes_;
  Notice notice_;
};

}  // namespace cvo
