// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/cache/content_hash.h"
#include "experiments/datasets/sequence.h"
#include "experiments/suite/plan/scenes.h"
#include "experiments/suite/suite.h"

namespace cvo {

// A sequence whose boxes a network finds.
struct DetectorInput {
  const SuiteSequence& written;
  const Sequence& sequence;  // opened without boxes
  std::filesystem::path data;
};

// The first file of boxes, of labels or of a detector that is not below `data`, as the suite writes
// it; else empty.
std::string FindMissingFile(const SuiteSequence& sequence, const std::filesystem::path& data);

// Where its boxes are: <cache>/detections/<hash>.txt, of the bytes of the network's files and of
// the left images, of its flags and of the program.
std::filesystem::path BoxesFile(const DetectorInput& input, const std::vector<ImageHashes>& images,
                                const std::filesystem::path& cache, const HashFiles& hash);

// Whether the file and the checksum beside it (`detect --checksum`) are there and agree.
bool AreBoxesWhole(const std::filesystem::path& boxes, const HashFiles& hash);

// Arguments of the program that write them there.
std::vector<std::string> DetectArguments(const DetectorInput& input,
                                         const std::filesystem::path& boxes);

}  // namespace cvo
