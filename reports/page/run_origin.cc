// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/run_origin.h"

#include <algorithm>

#include "core/files/json/json.h"
#include "core/files/json/json_record.h"
#include "core/files/text/number.h"

namespace cvo::reports {
namespace {

std::string TextOf(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string Words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// Adds a fact, or one fact per member of an object.
void AddFact(const std::string& name, const Json& value, std::vector<Fact>& facts) {
  if (!value.is_object()) {
    facts.emplace_back(Words(name), TextOf(value));
    return;
  }
  for (const auto& [part, of_part] : value.items()) {
    facts.emplace_back(Words(part), TextOf(of_part));
  }
}

void AddFacts(const Json& json, const std::vector<std::string>& names, std::vector<Fact>& facts) {
  for (const std::string& name : names) {
    if (json.contains(name)) facts.emplace_back(name, TextOf(json[name]));
  }
}

void ReadBuild(const std::filesystem::path& file, RunOrigin& origin) {
  const Json json = ReadJson(file, {"bodies", "clusters", "frames", "metrics"});
  if (!json.contains("build")) return;
  for (const auto& [name, value] : json["build"].items()) AddFact(name, value, origin.build);
}

void ReadTiming(const std::filesystem::path& file, RunOrigin& origin) {
  const Json json = ReadJson(file, {"frames"});
  AddFacts(json, {"host", "cpu", "cpus", "threads"}, origin.machine);
  AddFacts(json, {"date"}, origin.time);
  if (json.contains("wall_s")) {
    const double wall_s = FromJson<double>(json["wall_s"], file.string() + ", field wall_s");
    origin.time.emplace_back("took", FormatFixed(wall_s, 1) + " s");
  }
}

}  // namespace

RunOrigin ReadRunOrigin(const std::filesystem::path& run_folder) {
  RunOrigin origin;
  try {
    ReadBuild(run_folder / "result.json", origin);
  } catch (const Error& error) {
    origin.missing.emplace_back(error.what());
  }
  try {
    ReadTiming(run_folder / "timing.json", origin);
  } catch (const Error& error) {
    origin.missing.emplace_back(error.what());
  }
  return origin;
}

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
