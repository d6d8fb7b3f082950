// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/changed_options.h"

#include "reports/results/json_fields.h"

namespace cvo::reports {
namespace {

void Flatten(const Json& json, const std::string& path, std::map<std::string, std::string>& flat) {
  if (!json.is_object()) {
    flat[path] = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return;
  }
  for (const auto& [key, value] : json.items()) {
    Flatten(value, path.empty() ? key : path + "." + key, flat);
  }
}

}  // namespace

OptionDefaults::OptionDefaults(const std::string& json) {
  if (!json.empty()) Flatten(ParseJson(json, "default options"), "", defaults_);
}

std::vector<ChangedOption> OptionDefaults::ChangedIn(const std::string& options,
                                                     const std::string& where) {
  if (defaults_.empty() || options.empty()) return {};
  const auto [entry, added] = known_.try_emplace(options);
  if (!added) return entry->second;
  std::map<std::string, std::string> values;
  Flatten(ParseJson(options, where), "", values);
  for (const auto& [path, value] : values) {
    const auto at_default = defaults_.find(path);
    const std::string usual = at_default == defaults_.end() ? "" : at_default->second;
    if (value != usual) entry->second.push_back({path, usual, {value}});
  }
  return entry->second;
}

}  // namespace cvo::reports
