// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "synth/models/street_map.h"

namespace cvo::synth {

// Returns grass, carriageways at z = 0 with markings, kerbs and raised pavements, in world. They
// cast no shadows.
std::vector<Part> MakeStreetGround(const StreetMap& map, Rng& look);

}  // namespace cvo::synth
