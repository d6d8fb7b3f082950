// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/changed_options.h"

#include "core/files/json.h"

namespace cvo::reports {
OptionDefaults::OptionDefaults(const std::string& json) {
  if (!json.empty()) defaults_ = FlatJson(ParseJson(json, "default options"));
}

std::vector<ChangedOption> OptionDefaults::ChangedIn(const Json& options) {
  if (defaults_.empty() || options.empty()) return {};
  const auto [entry, added] = known_.try_emplace(options.dump());
  if (!added) return entry->second;
  for (const auto& [path, value] : FlatJson(options)) {
    const auto at_default = defaults_.find(path);
    const std::string usual = at_default == defaults_.end() ? "" : at_default->second;
    if (value != usual) entry->second.push_back({path, usual, {value}});
  }
  return entry->second;
}

}  // namespace cvo::reports
