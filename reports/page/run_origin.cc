// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/run_origin.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "reports/results/json_fields.h"
#include "reports/results/json_text.h"

namespace cvo::reports {
namespace {

std::string TextOf(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string Words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// What an object holds is a fact each.
void AddFact(const std::string& name, const Json& value, std::vector<Fact>& facts) {
  if (!value.is_object()) {
    facts.emplace_back(Words(name), TextOf(value));
    return;
  }
  for (const auto& [part, of_part] : value.items()) {
    facts.emplace_back(Words(part), TextOf(of_part));
  }
}

void AddFacts(const std::vector<JsonMember>& members, const std::string& where,
              const std::vector<std::string>& names, std::vector<Fact>& facts) {
  for (const std::string& name : names) {
    const std::string_view value = FindMember(members, name);
    if (!value.empty()) facts.emplace_back(name, TextOf(ParseJson(value, where)));
  }
}

void ReadBuild(const std::filesystem::path& file, RunOrigin& origin) {
  const std::string text = ReadText(file);
  const std::string_view build = FindMember(JsonMembers(text, file.string()), "build");
  if (build.empty()) return;
  const Json json = ParseJson(build, file.string());
  if (!json.is_object()) return;
  for (const auto& [name, value] : json.items()) AddFact(name, value, origin.build);
}

std::string Seconds(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f s", seconds);
  return text.data();
}

void ReadTiming(const std::filesystem::path& file, RunOrigin& origin) {
  const std::string text = ReadText(file);
  const std::string where = file.string();
  const std::vector<JsonMember> members = JsonMembers(text, where);
  AddFacts(members, where, {"host", "cpu", "cpus", "threads"}, origin.machine);
  AddFacts(members, where, {"date"}, origin.time);
  const std::string_view wall = FindMember(members, "wall_s");
  if (wall.empty()) return;
  const Json seconds = ParseJson(wall, where);
  if (seconds.is_number()) origin.time.emplace_back("took", Seconds(seconds.get<double>()));
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

}  // namespace cvo::reports
