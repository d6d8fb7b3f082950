// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

// SHA-256 of the two files of a stereo pair; empty for a file that cannot be read.
struct ImageHashes {
  std::string left;
  std::string right;
};

// Returns the identity of what a run reads: the bytes of the images and text files and the
// parameters of the sequence, but not their location. `images` has one element per frame of the
// sequence.
std::string ContentHash(const Sequence& sequence, const std::vector<ImageHashes>& images);

// Returns the parameters of the camera in the order of their declaration, without right_field_px,
// which is an estimate and not an input.
Json CameraNumbers(const StereoCamera& camera);

// Returns the SHA-256 of a file's bytes; empty if there is no such regular file. Throws Error if it
// cannot be read, as a plan made with another hash would be for another job.
std::string HashFile(const std::filesystem::path& file);
ImageHashes HashPair(const StereoPaths& pair);
// Hashes the images of every frame; reads all of them.
std::vector<ImageHashes> HashImages(const Sequence& sequence);

}  // namespace cvo
