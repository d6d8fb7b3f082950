// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/stereo_camera.h"

namespace cvo {

// Stereo images of anybody, with a calibration (rig_file.h).
struct StereoImport {
  std::filesystem::path left;  // a folder of images, or a video
  std::filesystem::path right;
  std::filesystem::path calibration;
  std::filesystem::path times = {};    // empty: from the images' names, else from `rate_hz`
  std::optional<double> rate_hz = {};  // empty: the video's, else 10
};

struct ImportOutcome {
  std::size_t frames = 0;
  bool rectified = false;  // by us; else the images were used as they are
  const char* times = "";  // where they come from: "file", "names", "rate", "video" or "nominal"
  StereoCamera camera;     // of the images written
  std::vector<std::string> damaged = {};  // "frame 3: <file>: found ..., expected ..."
};

// What was made of what, and the SHA-256 of every other file.
inline constexpr const char* kImportRecord = "import.json";

// Writes a sequence in the layout of KITTI odometry: image_0, image_1 (8-bit grey PNG), calib.txt,
// times.txt and kImportRecord. Images that are not rectified are. An image with a header but
// damaged pixels becomes one that cannot be decoded either: readers lose its frame. The folder
// appears whole or not at all. Throws Error where it exists, where the cameras have different
// numbers or sizes of images or one has an image that the other lacks, for files that cannot be
// read, and for a rate where the times are known.
ImportOutcome ImportStereo(
    const StereoImport& request, const std::filesystem::path& folder,
    const std::function<void(std::size_t done, std::size_t total)>& progress);

}  // namespace cvo
