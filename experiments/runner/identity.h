// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "core/record/run_summary.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

// The running program on this CPU.
const reports::BuildInfo& ThisBuild();

// Hash of the boxes that the estimator is given, whichever file they came from.
std::string DetectionsHash(const Sequence& sequence);

// What else determines the input of the estimator: classes of detections, and oracle switches by
// name.
Json GivenToJson(const std::vector<std::string>& classes, const std::vector<std::string>& oracle);

// SHA-256 of the two files of a stereo pair; empty for a file that cannot be read.
struct ImageHashes {
  std::string left;
  std::string right;
};

// Returns the identity of what a run reads: the bytes of the images and text files and the
// parameters of the sequence, but not their location. `images` has one element per frame of the
// sequence.
std::string ContentHash(const Sequence& sequence, const std::vector<ImageHashes>& images);

// Returns the hash of these images alone; empty if there are none.
std::string ImagesHash(const std::vector<ImageHashes>& images);

// Returns the parameters of the camera in the order of their declaration, without right_field_px,
// which is an estimate and not an input.
Json CameraNumbers(const StereoCamera& camera);

// Takes a line for the user about a problem that does not end the run.
using Notice = std::function<void(const std::string& line)>;

// Returns the maximum size of the front-end cache in bytes: CLUSTERVO_CACHE_SIZE ("20G"; K, M, G, T
// are powers of 1000), else 20 GB. Throws Error for text that is not a size.
std::uint64_t CacheLimit();

// Makes the file the most recently used, which TrimFolder removes last. Fails silently, for example
// in a folder of another user.
void MarkUsed(const std::filesystem::path& file);

// Removes files, least recently used first, until the rest is within the limit. Temporaries do not
// count. Files that cannot be removed stay.
void TrimFolder(const std::filesystem::path& folder, std::uint64_t limit_bytes);

// Returns the hashes of a sequence's images, for ContentHash. Throws Error for a file that cannot
// be read, as a plan made with another hash would be for another job.
std::vector<ImageHashes> HashImages(const Sequence& sequence);

}  // namespace cvo
