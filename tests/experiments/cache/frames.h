// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/runner/front_end_cache.h"

namespace cvo::test {

// Returns frames with a few features each. Frame 1 has a problem instead of features.
inline std::vector<FrontEndFrame> SomeFrames(int count) {
  std::vector<FrontEndFrame> frames;
  for (int i = 0; i < count; ++i) {
    FrontEndFrame frame;
    if (i == 1) frame.problems = {{1, "found nothing, expected a whole PNG image"}};
    for (int k = 0; k < 3 && i != 1; ++k) {
      StereoFeature feature;
      feature.z_px = {i + 1.0 / 3.0, k - 0.0, -1e-300 * i};
      feature.octave = k;
      feature.angle_rad = 0.1F * static_cast<float>(i);
      feature.response = 1e-40F;  // denormal
      feature.disagreement_px = 0.25F;
      feature.row_offset_px = -0.75F;
      feature.is_reserve = i % 2 == 1;
      feature.descriptor = {~0ULL, 0x0123456789abcdefULL, static_cast<std::uint64_t>(i), 0};
      feature.patch.corner_u = -0.25F;
      feature.patch.corner_v = 0.125F;
      feature.patch.pixels.fill(static_cast<std::uint8_t>(200 + k));
      frame.features.push_back(feature);
    }
    frames.push_back(frame);
  }
  return frames;
}

inline std::string BytesOf(const std::vector<FrontEndFrame>& frames) {
  std::string bytes;
  for (const FrontEndFrame& frame : frames) bytes += EncodeFrame(frame);
  return bytes;
}

inline std::string SomeKey(char digit) { return std::string(64, digit); }

inline void Store(const FrontEndCache& cache, const std::string& key,
                  const std::vector<FrontEndFrame>& frames) {
  FeatureRecording recording = cache.Record(key);
  for (const FrontEndFrame& frame : frames) recording.Add(frame);
  recording.Finish();
}

// Returns all frames of an entry as bytes, or "" if there is no such entry. Throws Error if one is
// damaged.
inline std::string Load(const FrontEndCache& cache, const std::string& key, std::size_t frames) {
  std::optional<FeatureFile> file = cache.Find(key);
  if (!file) return "";
  std::vector<FrontEndFrame> loaded;
  for (std::size_t i = 0; i < frames; ++i) loaded.push_back(file->Next());
  return BytesOf(loaded);
}

inline std::vector<std::string> NamesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace cvo::test
