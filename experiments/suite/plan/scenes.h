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

#include "experiments/datasets/frame_range.h"
#include "experiments/datasets/sequence.h"
#include "experiments/suite/suite.h"
#include "experiments/suite/suite_grid.h"
#include "synth/write/dataset.h"

namespace cvo {

// A scene as one seed and one point of a grid see it.
struct RenderedScene {
  std::filesystem::path folder;  // <cache>/scenes/<name>-<key>/<name>, rendered or not
  std::string drawing;           // key of what is drawn: the same for all seeds
  bool drawn = false;            // and that is in the cache: only the noise is missing
  int frames = 0;
  std::vector<std::string> arguments;  // of the program, that render it there
};

// Finds scenes below <cache>/scenes by what would be in them: scene, values assigned to it, seed,
// frames and the program that draws.
class SceneFolders {
 public:
  explicit SceneFolders(std::filesystem::path cache) : cache_(std::move(cache)) {}

  // Throws Error for a scene that cannot be, and where nothing can draw.
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

// SHA-256 of files, empty where one cannot be read: FindFileHashes.
using HashFiles =
    std::function<std::vector<std::string>(const std::vector<std::filesystem::path>&)>;

std::vector<std::string> HashesByReading(const std::vector<std::filesystem::path>& files);

// What is wrong with a rendered folder: a manifest that cannot be read, or the first file that is
// gone or has other content than the manifest says. Frame by frame only `frames` are looked at.
std::optional<std::string> FindSceneDamage(const std::filesystem::path& folder,
                                           const HashFiles& hash, const FrameRange& frames = {});

// Throws Error where the sequence is a rendered folder and a file that a run on it may read is not
// the one that was rendered.
void RequireAsRendered(const Sequence& sequence, const HashFiles& hash);

}  // namespace cvo
