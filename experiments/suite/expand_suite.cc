// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "experiments/suite/cell.h"
#include "experiments/suite/suite_grid.h"

namespace cvo {
namespace {

void AddVariants(const Suite& suite, const SuiteSequence& sequence, std::vector<Cell>& cells) {
  std::vector<std::vector<GridPoint>> points;  // by variant, equal in number
  for (const std::string& variant : suite.variants) {
    points.push_back(GridPoints(suite, sequence, variant));
  }
  for (const std::uint64_t seed : suite.seeds) {
    const bool landmarks = suite.landmarks && seed == suite.seeds.front();
    for (std::size_t point = 0; !points.empty() && point < points.front().size(); ++point) {
      for (const std::vector<std::string>& oracle : suite.oracles) {
        for (std::size_t v = 0; v < suite.variants.size(); ++v) {
          cells.push_back(
              {sequence, suite.variants[v], "", seed, points[v][point], oracle, landmarks});
        }
      }
    }
  }
}

// Adds one cell per file, with the first seed only: the truth is the same for every seed.
void AddSystems(const Suite& suite, const SuiteSequence& sequence, std::vector<Cell>& cells) {
  for (const SuiteSystem& system : suite.systems) {
    for (const SuiteSystem::Files& files : system.files) {
      if (files.sequence != sequence.name) continue;
      cells.push_back({sequence, "", system.name, suite.seeds.front(), {}, {}});
    }
  }
}

}  // namespace

Json ParametersOf(const Cell& cell) {
  Json parameters = Json::object();
  for (const auto& [path, value] : cell.parameters) parameters[path] = value;
  return parameters;
}

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
