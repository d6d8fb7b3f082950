// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/dataset_settings.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/files/json/options_json.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"

namespace cvo::synth {

namespace {

bool Among(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// Returns the options of the level that the scene names, and removes "level" from `values`.
DetectorOptions TakeLevel(const std::string& where, Json& values) {
  if (!values.contains("level")) return DetectorLevel("good");
  const Json level = values["level"];
  values.erase("level");
  if (!level.is_string() || !Among(DetectorLevels(), level)) {
    ThrowError(where + ": detector.level", level.dump(), "\"oracle\", \"good\" or \"poor\"");
  }
  return DetectorLevel(level);
}

}  // namespace

SensorOptions ReadSensor(const Json& section, const std::string& where) {
  SensorOptions options;
  MergeOptions(section, where + ": sensor", OptionLeaves(options));
  return options;
}

std::vector<NamedDetector> ReadDetectors(const Json& section, const std::string& where,
                                         const std::vector<std::string>& chosen) {
  Json values = section;
  DetectorOptions custom = TakeLevel(where, values);
  MergeOptions(values, where + ": detector", OptionLeaves(custom));

  std::vector<NamedDetector> detectors;
  std::vector<std::string> names = DetectorLevels();
  for (const std::string& name : names) detectors.push_back({name, DetectorLevel(name)});
  if (!values.empty()) {
    detectors.push_back({"custom", custom});
    names.emplace_back("custom");
  }
  for (const std::string& name : chosen) {
    if (Among(names, name)) continue;
    ThrowError("detector level", Quoted(name) + DidYouMean(name, names),
               names.size() > 3 ? "oracle, good, poor or custom" : "oracle, good or poor");
  }
  if (!chosen.empty()) {
    std::erase_if(detectors, [&](const NamedDetector& d) { return !Among(chosen, d.name); });
  }
  return detectors;
}

}  // namespace cvo::synth
