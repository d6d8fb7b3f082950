// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

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

}  // namespace cvo
