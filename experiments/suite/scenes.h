// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/suite/suite.h"
#include "experiments/suite/suite_grid.h"
#include "synth/write/dataset.h"

namespace cvo {

// A scene as one seed and one point of a grid see it.
struct SceneFolder {
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
  SceneFolder Find(const SuiteSequence& sequence, const GridPoint& parameters, std::uint64_t seed);

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

// Whether every file that its manifest lists is there and has its size.
bool IsRendered(const std::filesystem::path& folder);

}  // namespace cvo
