// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/runner/identity.h"
#include "experiments/suite/job_input.h"
#include "experiments/suite/suite.h"
#include "synth/write/dataset.h"

namespace cvo {

// The user's data folder. Sequences are found by their path below it, or by the end of their path.
class DataFolder {
 public:
  // An empty `root` means that there is no data folder. The folder is searched on first need.
  explicit DataFolder(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }

  struct Found {
    std::filesystem::path folder;  // absolute; empty: missing
    std::string missing;           // why it is missing, for the user
  };
  Found Find(const std::string& folder);

 private:
  const std::vector<FoundSequence>& All();

  std::filesystem::path root_;
  std::optional<std::vector<FoundSequence>> all_;
};

// A scene as rendered for one seed and one grid point.
struct RenderedScene {
  std::filesystem::path folder;  // <cache>/scenes/<name>-<key>/<name>, rendered or not
  std::string drawing;           // key of the drawing, which all seeds share
  bool drawn = false;            // the drawing is in the cache: only the noise is missing
  int frames = 0;
  std::vector<std::string> arguments;  // of the program, to render it into `folder`
};

// Finds scenes below <cache>/scenes by a key of what determines their content: the scene, the
// values assigned to it, the seed, the frames and the program that draws.
class SceneFolders {
 public:
  explicit SceneFolders(std::filesystem::path cache) : cache_(std::move(cache)) {}

  // Throws Error for an invalid scene, and if no renderer is available.
  RenderedScene Find(const SuiteSequence& sequence, const GridPoint& parameters,
                     std::uint64_t seed);

 private:
  struct Source {
    synth::DatasetSource dataset;
    int frames = 0;
  };
  const Source& SourceFor(const SuiteSequence& sequence,
                          const std::vector<std::string>& assignments);

  std::filesystem::path cache_;
  std::map<std::string, Source> sources_;  // by scene and assignments
};

// Returns the SHA-256 of each file, or an empty string for a file that cannot be read, as
// FindFileHashes does.
using HashFiles =
    std::function<std::vector<std::string>(const std::vector<std::filesystem::path>&)>;

std::vector<std::string> HashesByReading(const std::vector<std::filesystem::path>& files);

// Returns what is wrong with a rendered folder: an unreadable manifest, or the first file that is
// missing or differs from the manifest. Of per-frame files, only those of `frames` are checked.
std::optional<std::string> FindSceneDamage(const std::filesystem::path& folder,
                                           const HashFiles& hash, const FrameRange& frames = {});

// Throws Error if the sequence is a rendered folder and a file that a run on it may read is not the
// one that was rendered.
void RequireAsRendered(const Sequence& sequence, const HashFiles& hash);

// Returns the first file of boxes, labels or a detector that does not exist below `data`, as
// written in the suite; empty if all exist.
std::string FindMissingFile(const SuiteSequence& sequence, const std::filesystem::path& data);

// A sequence whose boxes are detected by a network.
struct DetectorInput {
  const SuiteSequence& written;
  const Sequence& sequence;  // opened without boxes
  std::vector<ImageHashes> images;
  std::filesystem::path data;
  std::filesystem::path cache;
};

struct DetectedBoxes {
  // <cache>/detections/<hash>.txt, where the hash covers the bytes of the network's files and of
  // the left images, the detector's flags and the program.
  std::filesystem::path file;
  bool whole = false;  // the file and the checksum beside it (`detect --checksum`) exist and agree
  std::vector<std::string> arguments;  // of the program, to write the file
};
DetectedBoxes FindDetectedBoxes(const DetectorInput& input, const HashFiles& hash);

}  // namespace cvo
