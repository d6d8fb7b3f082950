// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/statistics/strata.h"

#include <map>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

// Ordered containers, since a floating-point sum depends on the order of its terms.
using Repetitions = std::map<std::string, const Sample*>;
using Bodies = std::map<std::string, Repetitions>;
using Families = std::map<std::string, std::map<std::string, Bodies>>;

void Add(const Part& part, Part& sum) {
  sum.sum += part.sum;
  sum.weight += part.weight;
}

Families Order(const std::vector<Sample>& samples) {
  Families ordered;
  for (const Sample& sample : samples) {
    const Sample*& slot = ordered[sample.family][sample.scene][sample.body][sample.repetition];
    if (slot != nullptr) {
      ThrowError("statistics",
                 StrCat(sample.scene, ", ", sample.body, ", ", sample.repetition, " twice"),
                 "each sample once");
    }
    slot = &sample;
  }
  return ordered;
}

std::vector<Unit> AverageRepetitions(const Bodies& bodies) {
  std::vector<Unit> units;
  for (const auto& [body, repetitions] : bodies) {
    Unit mean = {{Part{0.0, 0.0}, Part{0.0, 0.0}}};
    for (const auto& [repetition, sample] : repetitions) {
      Add(sample->value, mean.parts[0]);
      Add(sample->reference, mean.parts[1]);
    }
    for (Part& part : mean.parts) {
      part.sum /= static_cast<double>(repetitions.size());
      part.weight /= static_cast<double>(repetitions.size());
    }
    units.push_back(mean);
  }
  return units;
}

}  // namespace

std::optional<Strata> GroupSamples(const std::vector<Sample>& samples, Within within) {
  Strata strata;
  std::vector<Unit> bodies;  // of the last scene
  for (const auto& [family, scenes] : Order(samples)) {
    strata.units.emplace_back();
    for (const auto& [scene, of_scene] : scenes) {
      bodies = AverageRepetitions(of_scene);
      const auto figure = MeanOverStrata({bodies}, within);
      if (!figure) return std::nullopt;
      strata.units.back().push_back({{Part{(*figure)[0]}, Part{(*figure)[1]}}});
      ++strata.scenes;
      strata.bodies += bodies.size();
    }
  }
  if (strata.scenes == 0) return std::nullopt;
  if (!strata.of_scenes()) {
    strata.units = {bodies};
    strata.within = within;
  }
  return strata;
}

std::optional<std::array<double, 2>> MeanOverStrata(const std::vector<std::vector<Unit>>& strata,
                                                    Within within) {
  if (strata.empty()) return std::nullopt;
  std::array<double, 2> means = {0.0, 0.0};
  for (const std::vector<Unit>& units : strata) {
    for (std::size_t which = 0; which < means.size(); ++which) {
      Part total = {0.0, 0.0};
      for (const Unit& unit : units) Add(unit.parts[which], total);
      if (total.weight <= 0.0) return std::nullopt;
      means[which] += within == Within::kSum ? total.sum : total.sum / total.weight;
    }
  }
  for (double& mean : means) mean /= static_cast<double>(strata.size());
  return means;
}

}  // namespace cvo::reports
