// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/options_json.h"
#include "core/files/text/number.h"
#include "experiments/runner/given.h"
#include "experiments/suite/suite.h"
#include "experiments/suite/system_command.h"
#include "synth/family/family.h"
#include "synth/scene/object_reader.h"
#include "synth/write/dataset.h"
#include "variants/registry.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kScene = "scene.";
constexpr std::string_view kPerturb = "perturb.";
constexpr std::string_view kDetector = "scene.detector.";

// What follows "scene." or "perturb." in a path.
std::string KeyOf(const std::string& path) { return path.substr(path.find('.') + 1); }

// Returns the value at a dotted path, or null if there is none.
Json AtPath(const Json& whole, const std::string& path) {
  const Json::json_pointer pointer = PointerTo(path);
  return whole.contains(pointer) ? whole[pointer] : Json(nullptr);
}

bool ChangesDetector(const GridPoint& parameters) {
  for (const auto& [path, value] : parameters.items()) {
    if (path.starts_with(kDetector)) return true;
  }
  return false;
}

// Returns the file of a scene's boxes. A grid point that changes the detector has a file of its
// own.
fs::path SceneDetections(const SuiteSequence& sequence, const PlanJob& job) {
  const std::string level = DetectorLevel(sequence);
  if (level.empty()) return sequence.detections;
  const std::string name = ChangesDetector(job.parameters) ? "custom" : level;
  return fs::path(job.folder) / "detections" / (name + ".txt");
}

}  // namespace

bool IsScenePath(const std::string& path) { return path.starts_with(kScene); }

bool IsOptionPath(const std::string& path) {
  return !IsScenePath(path) && !path.starts_with(kPerturb);
}

Json::json_pointer PointerTo(const std::string& path) {
  Json::json_pointer pointer;
  std::istringstream keys(path);
  for (std::string key; std::getline(keys, key, '.');) pointer /= key;
  return pointer;
}

Options OptionsOf(const Suite& suite, const std::string& variant, const GridPoint& parameters) {
  Options options = variant.empty() ? Options() : FindVariant(variant).defaults();
  const std::vector<OptionLeaf> leaves = OptionLeaves(options);
  MergeOptions(suite.options, "suite " + suite.name, leaves);
  for (const auto& [path, value] : parameters.items()) {
    if (!IsOptionPath(path)) continue;
    Json nested;
    nested[PointerTo(path)] = value;
    MergeOptions(nested, "suite " + suite.name, leaves);
  }
  options.Check();
  return options;
}

Perturbation PerturbationOf(const SuiteSequence& sequence, const GridPoint& parameters,
                            std::uint64_t seed) {
  Json json = sequence.perturb;
  for (const auto& [path, value] : parameters.items()) {
    if (path.starts_with(kPerturb)) json[KeyOf(path)] = value;
  }
  Perturbation perturbation = ParsePerturbation(json, sequence.name + ", perturb");
  perturbation.seed = seed;
  return perturbation;
}

std::vector<std::string> SceneAssignments(const SuiteSequence& sequence,
                                          const GridPoint& parameters) {
  std::vector<std::string> assignments;
  if (const std::string level = DetectorLevel(sequence);
      ChangesDetector(parameters) && !level.empty()) {
    assignments.push_back("detector.level=" + level);
  }
  for (const auto& [path, value] : parameters.items()) {
    if (IsScenePath(path)) assignments.push_back(KeyOf(path) + "=" + value.dump());
  }
  return assignments;
}

std::string DetectorLevel(const SuiteSequence& sequence) {
  return AreFromLabels(sequence.detections) ? "" : sequence.detections;
}

SequenceRequest RequestOf(const Suite& suite, const PlanJob& job, const fs::path& data) {
  const SuiteSequence& sequence = suite.sequences[job.entry];
  SequenceRequest request = sequence;
  request.folder = job.folder;
  request.perturbation = PerturbationOf(sequence, job.parameters, job.seed);
  if (!sequence.labels_file.empty()) request.labels_file = data / sequence.labels_file;
  // The frames of a scene were selected at rendering.
  if (sequence.scene.empty() && !sequence.frames.empty()) {
    const FrameRange range = ParseFrameRange(sequence.frames);
    request.begin_frame = range.begin;
    request.end_frame = range.end;
  }
  if (!sequence.scene.empty()) {
    request.detections_file = SceneDetections(sequence, job);
  } else if (!sequence.detections.empty()) {
    request.detections_file = AreFromLabels(sequence.detections) ? fs::path(sequence.detections)
                                                                 : data / sequence.detections;
  }
  return request;
}

std::vector<std::string> ClassesOf(const SuiteSequence& sequence) {
  return sequence.classes.empty() ? RigidClasses() : sequence.classes;
}

const SuiteSystem* SystemOf(const Suite& suite, const PlanJob& job) {
  return job.system.empty() ? nullptr : FindBy(suite.systems, &SuiteSystem::name, job.system);
}

SystemFiles SystemFilesOf(const Suite& suite, const PlanJob& job, const fs::path& data,
                          const fs::path& cache) {
  const SuiteSystem& system = *SystemOf(suite, job);
  if (system.shipped()) {
    return ShippedSystemFiles(system.name, suite.sequences[job.entry], job.folder, cache);
  }
  const auto below = [&](const std::string& file) {
    return file.empty() ? fs::path() : data / ForJob(file, job);
  };
  return {system.name, below(system.camera), below(system.objects)};
}

namespace {

constexpr double kLargest = 1e15;
constexpr int kMaxAxisValues = 1000;

std::vector<Json> RangeValues(synth::ObjectReader range) {
  const double from = range.Number("from", {-kLargest, kLargest});
  const double to = range.Number("to", {-kLargest, kLargest});
  const int steps = range.Integer("steps", {2, kMaxAxisValues});
  const std::string scale = range.TextOr("scale", "linear");
  const bool integers =
      range.Value("from").is_number_integer() && range.Value("to").is_number_integer();
  range.Finish();
  if (scale != "linear" && scale != "log") {
    ThrowError(range.Where("scale"), "\"" + scale + "\"", "\"linear\" or \"log\"");
  }
  if (scale == "log" && !(from > 0.0 && to > 0.0)) {
    ThrowError(range.Where(""), StrCat(from, " to ", to), "bounds above 0 on a log scale");
  }
  std::vector<Json> values = {range.Value("from")};
  for (int i = 1; i + 1 < steps; ++i) {
    const double part = static_cast<double>(i) / (steps - 1);
    const double value =
        scale == "log" ? from * std::pow(to / from, part) : from + part * (to - from);
    const double rounded = RoundedTo(value, 6);  // as a person would write it
    // Integers between integers, so that count options can be swept.
    const bool integer = integers && rounded == std::round(rounded);
    values.push_back(integer ? Json(static_cast<std::int64_t>(rounded)) : Json(rounded));
  }
  values.push_back(range.Value("to"));
  return values;
}

// Returns the values in the scene file, with those of the sensor and the detector completed by
// their defaults.
Json SceneDefaults(const SuiteSequence& sequence) {
  const auto scene = synth::LoadScene(sequence.scene, {});
  Json values = scene.json();
  synth::SensorOptions sensor = synth::ReadSensor(scene.sensor(), scene.where());
  values["sensor"] = OptionsToJson(OptionLeaves(sensor));
  Json section = scene.detector();
  if (!sequence.detections.empty()) section["level"] = sequence.detections;
  // The last detector is "custom" if the scene changes values of its level.
  std::vector<synth::NamedDetector> detectors = synth::ReadDetectors(section, scene.where(), {});
  for (synth::NamedDetector& detector : detectors) {
    if (detector.name != sequence.detections && detector.name != "custom") continue;
    values["detector"] = OptionsToJson(OptionLeaves(detector.options));
  }
  return values;
}

// Returns the point with every axis at its default.
GridPoint DefaultPoint(const Suite& suite, const SuiteSequence& sequence,
                       const std::string& variant) {
  Options options = OptionsOf(suite, variant, {});
  const Json estimator = OptionsToJson(OptionLeaves(options));
  Json scene;
  GridPoint point = Json::object();
  for (const GridAxis& axis : suite.grid) {
    Json value;
    if (IsScenePath(axis.path)) {
      if (scene.is_null()) scene = SceneDefaults(sequence);
      value = AtPath(scene, KeyOf(axis.path));
      if (value.is_null()) {
        ThrowError("grid." + axis.path, "no such key in scene " + sequence.scene,
                   "an existing key: one-at-a-time grids start from the scene's own values");
      }
    } else if (!IsOptionPath(axis.path)) {
      Perturbation perturbation = PerturbationOf(sequence, {}, 0);
      value = AtPath(OptionsToJson(OptionLeaves(perturbation)), KeyOf(axis.path));
    } else {
      value = AtPath(estimator, axis.path);
    }
    point[axis.path] = value;
  }
  return point;
}

std::vector<GridPoint> OneAtATime(const Suite& suite, const SuiteSequence& sequence,
                                  const std::string& variant) {
  const GridPoint origin = DefaultPoint(suite, sequence, variant);
  std::vector<GridPoint> points = {origin};
  for (const GridAxis& axis : suite.grid) {
    for (const Json& value : axis.values) {
      if (value == origin[axis.path]) continue;
      points.push_back(origin);
      points.back()[axis.path] = value;
    }
  }
  return points;
}

}  // namespace

std::vector<Json> ParseAxisValues(const Json& json, const std::string& where) {
  std::vector<Json> values;
  if (json.is_object()) {
    values = RangeValues(synth::ObjectReader(json, where, ""));
  } else if (json.is_array()) {
    values.assign(json.begin(), json.end());
  }
  if (values.empty()) {
    ThrowError(where, json.is_array() ? "an empty list" : StrCat("a JSON ", json.type_name()),
               "a list of values or {\"from\", \"to\", \"steps\", \"scale\"}");
  }
  if (values.size() > kMaxAxisValues) {
    ThrowError(where, StrCat(values.size(), " values"), StrCat("at most ", kMaxAxisValues));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (values[i] == values[k]) ThrowError(where, values[i].dump() + " twice", "each value once");
    }
  }
  return values;
}

std::vector<GridPoint> GridPoints(const Suite& suite, const SuiteSequence& sequence,
                                  const std::string& variant) {
  if (suite.grid_one_at_a_time) return OneAtATime(suite, sequence, variant);
  std::vector<GridPoint> points = {Json::object()};
  for (const GridAxis& axis : suite.grid) {
    std::vector<GridPoint> longer;
    for (const GridPoint& point : points) {
      for (const Json& value : axis.values) {
        longer.push_back(point);
        longer.back()[axis.path] = value;
      }
    }
    points = std::move(longer);
  }
  return points;
}

namespace {

PlanJob JobOn(const Suite& suite, std::size_t entry, std::uint64_t seed) {
  const SuiteSequence& sequence = suite.sequences[entry];
  PlanJob job;
  job.entry = entry;
  job.sequence = sequence.name;
  job.family = FamilyOf(sequence);
  job.split = SplitOf(sequence);
  job.detections = sequence.detections;
  job.seed = seed;
  return job;
}

void AddVariants(const Suite& suite, std::size_t entry, std::vector<PlanJob>& jobs) {
  const SuiteSequence& sequence = suite.sequences[entry];
  std::vector<std::vector<GridPoint>> points;  // by variant, equal in number
  for (const std::string& variant : suite.variants) {
    points.push_back(GridPoints(suite, sequence, variant));
  }
  for (const std::uint64_t seed : suite.seeds) {
    for (std::size_t point = 0; !points.empty() && point < points.front().size(); ++point) {
      for (const std::vector<std::string>& oracle : suite.oracles) {
        for (std::size_t v = 0; v < suite.variants.size(); ++v) {
          PlanJob job = JobOn(suite, entry, seed);
          job.variant = suite.variants[v];
          job.parameters = points[v][point];
          job.oracle = oracle;
          job.landmarks = suite.landmarks && seed == suite.seeds.front();
          jobs.push_back(std::move(job));
        }
      }
    }
  }
}

// Adds the jobs of other systems. What boxes a sequence has only matters to one that takes them
// (`again`: the same images with other boxes), and trajectories that exist have one seed.
void AddSystems(const Suite& suite, std::size_t entry, bool again, std::vector<PlanJob>& jobs) {
  for (const SuiteSystem& system : suite.systems) {
    if (again && !system.Uses("{detections}")) continue;
    if (system.shipped() && !FindShipped(system.name, suite.sequences[entry])) continue;
    for (const std::uint64_t seed : system.command.empty() ? suite.seeds : system.seeds) {
      jobs.push_back(JobOn(suite, entry, seed));
      jobs.back().system = system.name;
      if (system.command.empty()) break;
    }
  }
}

}  // namespace

std::vector<PlanJob> ExpandSuite(const Suite& suite) {
  std::vector<PlanJob> jobs;
  std::set<std::string> named;
  for (std::size_t entry = 0; entry < suite.sequences.size(); ++entry) {
    AddVariants(suite, entry, jobs);
    const bool again = !named.insert(suite.sequences[entry].name).second;
    AddSystems(suite, entry, again, jobs);
  }
  return jobs;
}

}  // namespace cvo
