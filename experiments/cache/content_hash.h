// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

// SHA-256 of the two files of a stereo pair; empty where a file cannot be read.
struct ImageHashes {
  std::string left;
  std::string right;
};

// Identity of what a run reads: the bytes of the images and text files and the parameters of the
// sequence, but not where they lie. One entry per frame of the sequence.
std::string ContentHash(const Sequence& sequence, const std::vector<ImageHashes>& images);
// The same from the hashes of each frame: one at a time is in memory.
std::string ContentHash(const Sequence& sequence,
                        const std::function<ImageHashes(std::size_t frame)>& images);

// Every number of the camera, in the order of its declaration.
Json CameraNumbers(const StereoCamera& camera);

// SHA-256 of a file's bytes; empty where there is none, or a folder or a pipe. Throws Error where
// it cannot be read: what is planned with another hash would be another job.
std::string HashFile(const std::filesystem::path& file);
ImageHashes HashPair(const StereoPaths& pair);
// Of every frame; reads all images.
std::vector<ImageHashes> HashImages(const Sequence& sequence);

}  // namespace cvo
