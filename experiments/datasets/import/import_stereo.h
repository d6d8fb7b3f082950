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

// A user's own stereo images, with a calibration (rig_file.h).
struct StereoImport {
  std::filesystem::path left;  // a folder of images
  std::filesystem::path right;
  std::vector<std::filesystem::path> calibration;  // a file, or two
  std::filesystem::path times = {};    // empty: from the images' names, else from `rate_hz`
  std::optional<double> rate_hz = {};  // empty: 10
};

struct ImportOutcome {
  std::size_t frames = 0;
  bool rectified = false;                 // by the import; false: images were used as they are
  const char* times = "";                 // their source: "file", "names", "rate" or "nominal"
  StereoCamera camera;                    // of the written images
  std::vector<std::string> damaged = {};  // "frame 3: <file>: found ..., expected ..."
};

using ImportProgress = std::function<void(std::size_t done, std::size_t total)>;

// File that records the inputs of the import.
inline constexpr const char* kImportRecord = "import.json";

// Writes a sequence in the layout of KITTI odometry: image_0, image_1 (8-bit grey PNG), calib.txt,
// times.txt and kImportRecord. Images are rectified if they are not yet. An image with a readable
// header but damaged pixels is written as an image that cannot be decoded either, so that readers
// lose its frame. The folder appears complete or not at all. Throws Error if it exists, if the
// cameras have different numbers or sizes of images or one has an image that the other lacks, for
// files that cannot be read, and for a rate if the times are known.
ImportOutcome ImportStereo(const StereoImport& request, const std::filesystem::path& folder,
                           const ImportProgress& progress);

// Returns the folder of the sequence that ImportStereo makes. The sequence is made only once, below
// `cache`, under the hash of all its inputs. Throws Error as ImportStereo.
std::filesystem::path ImportIntoCache(const StereoImport& request,
                                      const std::filesystem::path& cache,
                                      const ImportProgress& progress);

}  // namespace cvo
