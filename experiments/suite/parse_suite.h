// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "core/files/json/json.h"
#include "experiments/suite/suite.h"

namespace cvo {

// A shipped suite's name or a suite file (experiments/configs/README.md), read strictly: throws
// Error that names the file and the key of what is unknown, missing, of another type or out of
// range.
Suite LoadSuite(const std::string& suite);

// Scene files are meant relative to `folder`; `where` names the text in errors.
Suite ParseSuite(const Json& json, const std::string& where,
                 const std::filesystem::path& folder = {});
// The same without CheckSuite: keys and types alone, for a suite that was checked once.
Suite ReadCheckedSuite(const Json& json, const std::string& where,
                       const std::filesystem::path& folder = {});

// The suite as a file that ParseSuite reads back, everything in it resolved.
Json SuiteToJson(const Suite& suite);

// Throws Error naming `where` and the key for a suite that cannot be run: a name that is not known,
// an option that cannot be, points of a grid that its table would mix.
void CheckSuite(const Suite& suite, const std::string& where);

}  // namespace cvo
