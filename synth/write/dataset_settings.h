// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "synth/detector/detector_options.h"
#include "synth/sensor/sensor.h"

namespace cvo::synth {

// Returns the default options, overridden by the "sensor" section of a scene. `where` names the
// scene in errors.
SensorOptions ReadSensor(const Json& section, const std::string& where);

// A detector whose detections are written to detections/<name>.txt.
struct NamedDetector {
  std::string name;
  DetectorOptions options;
};

// Returns the detectors of a sequence: every level, plus "custom" if the "detector" section of the
// scene overrides values of its "level" (default "good"). If `chosen` is not empty, returns only
// the detectors with these names. Throws Error for an unknown key, value or name.
std::vector<NamedDetector> ReadDetectors(const Json& section, const std::string& where,
                                         const std::vector<std::string>& chosen);

}  // namespace cvo::synth
