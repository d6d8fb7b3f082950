// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// A name and a value, both for readers.
using Fact = std::pair<std::string, std::string>;

// What produced a result: the program (result.json) and the machine (timing.json). Facts that a
// file lacks are omitted; a file that cannot be read is named in `missing`.
struct RunOrigin {
  std::vector<Fact> build;    // commit, compiler, versions
  std::vector<Fact> machine;  // host, processor
  std::vector<Fact> time;     // date and duration
  std::vector<std::string> missing;
};

RunOrigin ReadRunOrigin(const std::filesystem::path& run_folder);

// Finds the options of a run that are not at their default. The result is cached for runs with the
// same options.
class OptionDefaults {
 public:
  // Nested JSON. If it is empty, the defaults are unknown, and no option is reported as changed.
  explicit OptionDefaults(const std::string& json);

  std::vector<ChangedOption> ChangedIn(const Json& options);

 private:
  std::map<std::string, std::string> defaults_;
  std::map<std::string, std::vector<ChangedOption>> known_;
};

}  // namespace cvo::reports
