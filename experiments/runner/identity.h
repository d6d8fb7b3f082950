// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "core/record/run_summary.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

// What determines the bytes of a result besides its input. Two builds with the same identity give
// the same results. The commit is informative and not part of the identity.
using BuildIdentity = reports::BuildInfo;

// Hash of all fields except the commit.
std::string IdentityOf(const BuildIdentity& build);

// The running program on this CPU.
const BuildIdentity& ThisBuild();

// Everything that determines the bytes of a result.
struct Job {
  std::string build;  // BuildInfo::identity
  std::string variant;
  Json options;            // resolved
  std::string content;     // hash of the sequence
  std::string detections;  // DetectionsHash
  Json given;              // GivenToJson
  std::uint64_t seed = 0;
};

// Jobs with the same identity have the same result.
std::string JobIdentity(const Job& job);

// The same in two steps, for many jobs that share the first: all jobs of a build with the same
// variant and options.
struct JobInput {
  std::string content;
  std::string detections;
  Json given;
  std::uint64_t seed = 0;
};
std::string IdentityHead(const std::string& build, const std::string& variant, const Json& options);
std::string JobIdentity(const std::string& head, const JobInput& input);

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
