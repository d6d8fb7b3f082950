// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "core/files/json/json.h"
#include "experiments/suite/suite.h"

namespace cvo {

// Loads a shipped suite by name, or a suite file (experiments/configs/README.md). Parsing is
// strict: throws Error naming the file and the key of anything unknown, missing, of the wrong type
// or out of range.
Suite LoadSuite(const std::string& suite);

// Parses and checks a suite. Paths of scene files are relative to `folder`; `where` names the
// source in errors.
Suite ParseSuite(const Json& json, const std::string& where,
                 const std::filesystem::path& folder = {});
// The same without CheckSuite: validates keys and types only, for a suite that has been checked
// before.
Suite ReadCheckedSuite(const Json& json, const std::string& where,
                       const std::filesystem::path& folder = {});

// Returns the suite as a file that ParseSuite reads back, with everything resolved.
Json SuiteToJson(const Suite& suite);

// Throws Error naming `where` and the key if the suite cannot be run: an unknown name, an invalid
// option, or grid points that its table would mix.
void CheckSuite(const Suite& suite, const std::string& where);

}  // namespace cvo
