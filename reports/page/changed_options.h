// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/tables/table.h"

namespace cvo::reports {

// Which options of a run are not at their default. Runs with the same options are compared once.
class OptionDefaults {
 public:
  // Nested JSON; empty: not known, then no option is reported as changed.
  explicit OptionDefaults(const std::string& json);

  std::vector<ChangedOption> ChangedIn(const Json& options);

 private:
  std::map<std::string, std::string> defaults_;
  std::map<std::string, std::vector<ChangedOption>> known_;
};

}  // namespace cvo::reports
