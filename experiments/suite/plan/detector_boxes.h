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

// A sequence whose boxes are detected by a network.
struct DetectorInput {
  const SuiteSequence& written;
  const Sequence& sequence;  // opened without boxes
  std::filesystem::path data;
};

// Returns the first file of boxes, labels or a detector that does not exist below `data`, as
// written in the suite; empty if all exist.
std::string FindMissingFile(const SuiteSequence& sequence, const std::filesystem::path& data);

// Returns the path of the sequence's boxes: <cache>/detections/<hash>.txt, where the hash covers
// the bytes of the network's files and of the left images, the detector's flags and the program.
std::filesystem::path BoxesFile(const DetectorInput& input, const std::vector<ImageHashes>& images,
                                const std::filesystem::path& cache, const HashFiles& hash);

// Whether the file and the checksum beside it (`detect --checksum`) both exist and agree.
bool AreBoxesWhole(const std::filesystem::path& boxes, const HashFiles& hash);

// Returns the arguments with which the program writes the boxes to `boxes`.
std::vector<std::string> DetectArguments(const DetectorInput& input,
                                         const std::filesystem::path& boxes);

}  // namespace cvo
