// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/suite_grid.h"

#include <cmath>

#include "core/base/error.h"
#include "core/files/json/options_json.h"
#include "core/files/text/number.h"
#include "core/interface/options.h"
#include "experiments/suite/cell_input.h"
#include "synth/family/generate.h"
#include "synth/scene/object_reader.h"
#include "synth/write/dataset_settings.h"

namespace cvo {
namespace {

constexpr std::string_view kScene = "scene.";
constexpr std::string_view kPerturb = "perturb.";
constexpr double kLargest = 1e15;
constexpr int kMaxAxisValues = 1000;

// Returns an integer if both ends of the range are integers, so that count options can be swept.
Json AxisValue(double value, bool integers) {
  const double rounded = RoundedTo(value, 6);  // as a person would write it
  if (integers && rounded == std::round(rounded)) return static_cast<std::int64_t>(rounded);
  return rounded;
}

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
    values.push_back(AxisValue(value, integers));
  }
  values.push_back(range.Value("to"));
  return values;
}

// Returns the value at a dotted path, or null if there is none.
Json AtPath(const Json& whole, const std::string& path) {
  const Json* value = &whole;
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t end = std::min(path.find('.', start), path.size());
    const std::string key = path.substr(start, end - start);
    if (value->is_object() && value->contains(key)) {
      value = &(*value)[key];
    } else if (const auto index = ParseInteger(key);
               value->is_array() && index && *index >= 0 &&
               *index < static_cast<std::int64_t>(value->size())) {
      value = &(*value)[static_cast<std::size_t>(*index)];
    } else {
      return nullptr;
    }
    start = end + 1;
  }
  return *value;
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
  GridPoint point;
  for (const GridAxis& axis : suite.grid) {
    Json value;
    if (IsScenePath(axis.path)) {
      if (scene.is_null()) scene = SceneDefaults(sequence);
      value = AtPath(scene, SceneKey(axis.path));
      if (value.is_null()) {
        ThrowError("grid." + axis.path, "no such key in scene " + sequence.scene,
                   "an existing key: one-at-a-time grids start from the scene's own values");
      }
    } else if (IsPerturbPath(axis.path)) {
      Perturbation perturbation = PerturbationOf(sequence, {}, 0);
      value = AtPath(OptionsToJson(OptionLeaves(perturbation)), PerturbKey(axis.path));
    } else {
      value = AtPath(estimator, axis.path);
    }
    point.emplace_back(axis.path, value);
  }
  return point;
}

std::vector<GridPoint> OneAtATime(const Suite& suite, const SuiteSequence& sequence,
                                  const std::string& variant) {
  const GridPoint origin = DefaultPoint(suite, sequence, variant);
  std::vector<GridPoint> points = {origin};
  for (std::size_t i = 0; i < suite.grid.size(); ++i) {
    for (const Json& value : suite.grid[i].values) {
      if (value == origin[i].second) continue;
      points.push_back(origin);
      points.back()[i].second = value;
    }
  }
  return points;
}

}  // namespace

bool IsScenePath(const std::string& path) { return path.starts_with(kScene); }

std::string SceneKey(const std::string& path) { return path.substr(kScene.size()); }

bool IsPerturbPath(const std::string& path) { return path.starts_with(kPerturb); }

std::string PerturbKey(const std::string& path) { return path.substr(kPerturb.size()); }

bool IsOptionPath(const std::string& path) { return !IsScenePath(path) && !IsPerturbPath(path); }

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
  std::vector<GridPoint> points = {{}};
  for (const GridAxis& axis : suite.grid) {
    std::vector<GridPoint> longer;
    for (const GridPoint& point : points) {
      for (const Json& value : axis.values) {
        longer.push_back(point);
        longer.back().emplace_back(axis.path, value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

}  // namespace cvo
