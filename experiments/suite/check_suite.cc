// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/options_json.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "core/record/metric_catalogue.h"
#include "core/record/suite_runs.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/given.h"
#include "experiments/suite/suite.h"
#include "experiments/suite/system_command.h"
#include "synth/family/family.h"
#include "synth/write/dataset.h"
#include "variants/registry.h"

namespace cvo {
namespace {

using Names = std::vector<std::string>;

bool Among(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Each of `names` must be known and occur only once.
void CheckNames(const Names& names, const Names& known, const std::string& where,
                const std::string& expected) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string at = StrCat(where, ".", i);
    if (!Among(known, names[i])) {
      ThrowError(at, Quoted(names[i]), expected + DidYouMean(names[i], known));
    }
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
        names.begin() + static_cast<std::ptrdiff_t>(i)) {
      ThrowError(at, Quoted(names[i]) + " twice", "each name once");
    }
  }
}

// Runs a check of something that was written elsewhere, and prefixes its errors with the key
// `where` that led there.
void At(const std::string& where, const std::function<void()>& check) {
  try {
    check();
  } catch (const Error& error) {
    throw Error(StrCat(where, ": ", error.what()));
  }
}

Names VariantNames() {
  Names names;
  for (const VariantInfo& variant : Variants()) names.emplace_back(variant.name);
  return names;
}

void CheckName(const std::string& name, const std::string& where) {
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == '+';
  });
  if (name.empty() || !plain || name.front() == '.') {
    ThrowError(where, Quoted(name), "a name of letters, digits, '_', '-', '+' and '.'");
  }
}

void CheckScene(const SuiteSequence& sequence, const GridPoint& point) {
  const auto scene = synth::LoadScene(sequence.scene, SceneAssignments(sequence, point));
  synth::ReadSensor(scene.sensor(), scene.where());
  const std::string level = DetectorLevel(sequence);
  synth::ReadDetectors(scene.detector(), scene.where(), level.empty() ? Names() : Names{level});
  if (!sequence.frames.empty()) {
    ResolveFrameRange(ParseFrameRange(sequence.frames), scene.parts().frames);
  }
}

// Whether the scene is not among those already checked. Of the scenes drawn from one distribution
// only one, with seed 0, is checked: each takes time to make, and one that cannot be made is listed
// with the jobs that lack it.
using CheckedScenes = std::set<std::array<std::string, 3>>;
bool IsNew(const SuiteSequence& sequence, CheckedScenes& checked) {
  std::string scene = sequence.scene;
  if (synth::IsFamilyScene(scene)) {
    synth::FamilyScene family = synth::ParseFamilyScene(scene);
    family.seed = 0;
    scene = family.Name();
  }
  return checked.insert({scene, sequence.frames, sequence.detections}).second;
}

void CheckSequences(const Suite& suite, const std::string& where) {
  if (suite.sequences.empty()) ThrowError(where + ", sequences", "none", "at least one");
  std::set<std::pair<std::string, std::string>> seen;
  CheckedScenes checked;
  for (std::size_t i = 0; i < suite.sequences.size(); ++i) {
    const SuiteSequence& sequence = suite.sequences[i];
    const std::string at = StrCat(where, ", sequences.", i);
    CheckName(sequence.name, at + ".name");
    if (!seen.emplace(sequence.name, sequence.detections).second) {
      ThrowError(at, Quoted(sequence.name) + " with these detections twice",
                 "a unique \"name\" for each sequence");
    }
    CheckNames(sequence.classes, KnownClasses(), at + ".classes",
               "classes of detections, of " + Joined(KnownClasses(), ", "));
    At(at, [&] {
      PerturbationOf(sequence, {}, 0);
      if (!sequence.scene.empty()) {
        if (IsNew(sequence, checked)) CheckScene(sequence, {});
        return;
      }
      if (!sequence.frames.empty()) ParseFrameRange(sequence.frames);
    });
  }
}

// Must run before anything is created for each run, which would exhaust the memory.
void CheckCount(const Suite& suite, const std::string& where) {
  double points = 1.0;
  for (const GridAxis& axis : suite.grid) {
    const auto values = static_cast<double>(axis.values.size());
    points = suite.grid_one_at_a_time ? points + values : points * values;
  }
  std::size_t seeds = suite.seeds.size();
  for (const SuiteSystem& system : suite.systems) seeds = std::max(seeds, system.seeds.size());
  double runs = points;
  for (const std::size_t count : {suite.sequences.size(), seeds, suite.oracles.size(),
                                  suite.variants.size() + suite.systems.size()}) {
    runs *= static_cast<double>(std::max<std::size_t>(count, 1));
  }
  if (runs > static_cast<double>(kMaxRuns)) {
    ThrowError(where, StrCat(runs, " runs"), StrCat("at most ", kMaxRuns, " in one suite"));
  }
}

// Returns the suite's variants, or one empty name if the suite has only other systems.
Names AnyVariants(const Suite& suite) {
  return suite.variants.empty() ? Names{""} : suite.variants;
}

void CheckGrid(const Suite& suite, const std::string& where) {
  const bool scenes = std::any_of(suite.grid.begin(), suite.grid.end(),
                                  [](const GridAxis& axis) { return IsScenePath(axis.path); });
  CheckedScenes checked;
  for (const SuiteSequence& sequence : suite.sequences) {
    if (scenes && sequence.scene.empty()) {
      ThrowError(where + ", grid", "a value of scenes, and a sequence that is a folder of images",
                 "scenes alone");
    }
    if (!IsNew(sequence, checked)) continue;
    At(where + ", grid", [&] {
      for (const std::string& variant : AnyVariants(suite)) {
        for (const GridPoint& point : GridPoints(suite, sequence, variant)) {
          OptionsOf(suite, variant, point);
          PerturbationOf(sequence, point, 0);
          if (scenes) CheckScene(sequence, point);
        }
      }
    });
    if (!scenes) break;  // the points are the same for all sequences
  }
}

void CheckSystems(const Suite& suite, const std::string& where) {
  Names names = suite.variants;
  for (std::size_t i = 0; i < suite.systems.size(); ++i) {
    const SuiteSystem& system = suite.systems[i];
    const std::string at = StrCat(where, ", systems.", i);
    CheckName(system.name, at + ".name");
    if (Among(names, system.name)) {
      ThrowError(at + ".name", Quoted(system.name) + " twice", "a unique name");
    }
    names.push_back(system.name);
    CheckPlaceholders(system, at);
    const auto any = [&](const auto& is) {
      return std::any_of(suite.sequences.begin(), suite.sequences.end(), is);
    };
    if (system.Uses("{detections}") && any([](const auto& s) { return s.detections.empty(); })) {
      ThrowError(at + ".command", "{detections}, and a sequence without \"detections\"",
                 "boxes for each sequence");
    }
    if (system.shipped() && !any([&](const auto& s) { return FindShipped(system.name, s); })) {
      ThrowError(at, "no \"command\" or \"writes\"",
                 "these, or a trajectory that comes with the program");
    }
  }
}

// Scenes on which options were chosen and scenes on which results are reported must not share a
// row.
void CheckSplits(const Suite& suite, const std::string& where) {
  if (Among(suite.table.rows, "sequence")) return;
  const bool by_family = Among(suite.table.rows, "family");
  std::map<std::string, std::string> splits;  // by family, or one for all
  for (std::size_t i = 0; i < suite.sequences.size(); ++i) {
    const SuiteSequence& sequence = suite.sequences[i];
    const std::string split = SplitOf(sequence);
    if (sequence.scene.empty()) continue;
    const auto [first, is_new] = splits.emplace(by_family ? FamilyOf(sequence) : "", split);
    if (is_new || first->second == split) continue;
    ThrowError(
        StrCat(where, ", sequences.", i),
        StrCat("the ", split, " split (", sequence.name, ") beside the ", first->second, " split"),
        "one split in a row, or \"sequence\" among table.rows");
  }
}

// Rows must distinguish everything that differs between cells, except the sequence and the seed.
void CheckRows(const Suite& suite, const std::string& where) {
  Names keys = {"sequence", "family", "detections", "variant", "oracle"};
  Names needed;
  for (const GridAxis& axis : suite.grid) {
    keys.push_back(axis.path);
    if (axis.values.size() > 1) needed.push_back(axis.path);
  }
  if (suite.variants.size() + suite.systems.size() > 1) needed.emplace_back("variant");
  if (suite.oracles.size() > 1) needed.emplace_back("oracle");
  std::set<std::string> names;
  for (const SuiteSequence& sequence : suite.sequences) {
    const bool again = !names.insert(sequence.name).second;  // with other detections
    if (again && !Among(needed, "detections")) needed.emplace_back("detections");
  }
  CheckNames(suite.table.rows, keys, where + ", table.rows", "one of " + Joined(keys, ", "));
  for (const std::string& key : needed) {
    if (!Among(suite.table.rows, key)) {
      ThrowError(where + ", table.rows",
                 "no \"" + key + "\", although the suite has several values of it",
                 "rows that distinguish them");
    }
  }
}

// The reference must be a variant of the suite, KEY=VALUE with one of the row keys, or kRowAbove.
void CheckReference(const Suite& suite, const std::string& where) {
  const std::string& reference = suite.table.reference;
  if (reference.empty() || reference == reports::kRowAbove) return;
  const std::size_t equals = reference.find('=');
  if (equals == std::string::npos) {
    CheckNames({reference}, suite.variants, where, "a variant of the suite");
  } else {
    CheckNames({reference.substr(0, equals)}, suite.table.rows, where,
               "KEY=VALUE with one of the rows' keys: " + Joined(suite.table.rows, ", "));
  }
}

void CheckOracles(const Suite& suite, const std::string& where) {
  if (suite.oracles.empty()) ThrowError(where + ", oracles", "none", "at least [[]]");
  std::set<Names> seen;
  for (std::size_t i = 0; i < suite.oracles.size(); ++i) {
    const std::string at = StrCat(where, ", oracles.", i);
    CheckNames(suite.oracles[i], {"boxes", "labels", "camera"}, at, "boxes, labels or camera");
    if (!seen.insert(OracleOf(suite.oracles[i]).Names()).second) {
      ThrowError(at, "these switches twice", "each set once");
    }
  }
}

}  // namespace

std::string SplitOf(const SuiteSequence& sequence) {
  if (sequence.scene.empty()) return "given";
  if (!synth::IsFamilyScene(sequence.scene)) return synth::SplitName(synth::Split::kDevelopment);
  return synth::SplitName(synth::SplitOf(synth::ParseFamilyScene(sequence.scene).seed));
}

std::string FamilyOf(const SuiteSequence& sequence) {
  if (!synth::IsFamilyScene(sequence.scene)) return "";
  return std::filesystem::path(synth::ParseFamilyScene(sequence.scene).family).stem().string();
}

std::string SplitOf(const Suite& suite) {
  std::set<std::string> splits;
  for (const SuiteSequence& sequence : suite.sequences) splits.insert(SplitOf(sequence));
  return splits.size() == 1 ? *splits.begin() : "mixed";
}

void CheckSuite(const Suite& suite, const std::string& where) {
  CheckCount(suite, where);
  CheckName(suite.name, where + ", name");
  CheckSequences(suite, where);
  CheckNames(suite.variants, VariantNames(), where + ", variants",
             "a variant (clustervo list variants)");
  if (suite.variants.empty() && suite.systems.empty()) {
    ThrowError(where + ", variants", "none", "at least one variant or system");
  }
  if (suite.seeds.empty()) ThrowError(where + ", seeds", "none", "at least one");
  if (std::set(suite.seeds.begin(), suite.seeds.end()).size() < suite.seeds.size()) {
    ThrowError(where + ", seeds", "a seed twice", "each once");
  }
  At(where + ", options", [&] {
    for (const std::string& variant : AnyVariants(suite)) OptionsOf(suite, variant, {});
  });
  CheckGrid(suite, where);
  CheckOracles(suite, where);
  CheckSystems(suite, where);
  CheckRows(suite, where);
  CheckSplits(suite, where);
  if (suite.table.metrics.empty()) ThrowError(where + ", table.metrics", "none", "at least one");
  CheckNames(suite.table.metrics, reports::AllMetricNames(), where + ", table.metrics",
             "a metric of results, as camera_ate or object_success_10cm");
  CheckReference(suite, where + ", table.reference");
}

}  // namespace cvo
