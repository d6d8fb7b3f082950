// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/files/json/json.h"

namespace cvo::reports {

// Converts a result.json of schema version 2 to the present one. They differ in the contracts,
// which were sentences: these are kept as such, so that the numbers are comparable only with each
// other. Throws Error naming the field if the file is damaged; `where` names the file.
Json UpgradedFromSchema2(Json result, const std::string& where);

}  // namespace cvo::reports
