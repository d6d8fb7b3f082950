// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "synth/detector/detector_options.h"
#include "synth/sensor/sensor.h"

namespace cvo::synth {

// The "sensor" section of a scene over the defaults. `where` names the scene in errors.
SensorOptions ReadSensor(const Json& section, const std::string& where);

// A detector that writes a file of its own: detections/<name>.txt.
struct NamedDetector {
  std::string name;
  DetectorOptions options;
};

// The detectors of a sequence: every level, and "custom" where the scene's "detector" section
// changes values of its "level" (default "good"). With `chosen`, those of these names. Throws Error
// for an unknown key, value or name.
std::vector<NamedDetector> ReadDetectors(const Json& section, const std::string& where,
                                         const std::vector<std::string>& chosen);

}  // namespace cvo::synth
