// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "experiments/suite/plan.h"
#include "experiments/suite/suite_grid.h"

namespace cvo {
namespace {

void AddVariants(const Suite& suite, const SuiteSequence& sequence, std::vector<Cell>& cells) {
  const std::vector<GridPoint> points = GridPoints(suite, sequence);
  for (const std::uint64_t seed : suite.seeds) {
    for (const GridPoint& point : points) {
      for (const std::vector<std::string>& oracle : suite.oracles) {
        for (const std::string& variant : suite.variants) {
          const bool landmarks = suite.landmarks && seed == suite.seeds.front();
          cells.push_back({sequence, variant, "", seed, point, oracle, landmarks});
        }
      }
    }
  }
}

// Their files are of one run: the truth is the same for every seed.
void AddSystems(const Suite& suite, const SuiteSequence& sequence, std::vector<Cell>& cells) {
  for (const SuiteSystem& system : suite.systems) {
    for (const SuiteSystem::Files& files : system.files) {
      if (files.sequence != sequence.name) continue;
      cells.push_back({sequence, "", system.name, suite.seeds.front(), {}, {}});
    }
  }
}

}  // namespace

std::vector<Cell> ExpandSuite(const Suite& suite) {
  std::vector<Cell> cells;
  std::set<std::string> named;
  for (const SuiteSequence& sequence : suite.sequences) {
    AddVariants(suite, sequence, cells);
    if (named.insert(sequence.name).second) AddSystems(suite, sequence, cells);
  }
  return cells;
}

}  // namespace cvo
