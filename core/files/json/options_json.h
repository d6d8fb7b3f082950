// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/options.h"
#include "core/files/json/json.h"

namespace cvo {

// One option of a struct that lives elsewhere, by its dotted path.
struct OptionLeaf {
  std::string path;
  std::variant<bool*, int*, double*> value;
  FieldInfo info;
};

// Every option of `options`, in the order of its visitor.
template <OptionsStruct Options>
std::vector<OptionLeaf> OptionLeaves(Options& options) {
  std::vector<OptionLeaf> leaves;
  VisitLeaves(options, [&leaves](const std::string& path, auto& value, const FieldInfo& info) {
    leaves.push_back({path, &value, info});
  });
  return leaves;
}

// Nested objects over the present values: {"window": {"spatial": 5}}. Throws Error with the dotted
// path for a key that is no option, a value of another type or outside its range. `where` names
// the source in errors.
void MergeOptions(const Json& config, const std::string& where,
                  const std::vector<OptionLeaf>& leaves);

// "window.spatial=5" with a value that is a bool, int or double as a whole, within its range.
void SetOption(std::string_view assignment, const std::vector<OptionLeaf>& leaves);

// The present values as nested objects.
Json OptionsToJson(const std::vector<OptionLeaf>& leaves);

// "bool", "int" or "double".
const char* TypeName(const OptionLeaf& leaf);
Json ValueToJson(const OptionLeaf& leaf);

// Defaults, then the file (where not empty), then the assignments in their order.
template <OptionsStruct Options>
Options ResolveOptions(const std::filesystem::path& config_file,
                       const std::vector<std::string>& assignments, Options options = {}) {
  const std::vector<OptionLeaf> leaves = OptionLeaves(options);
  if (!config_file.empty()) {
    MergeOptions(ReadJson(config_file), config_file.string(), leaves);
  }
  for (const std::string& assignment : assignments) SetOption(assignment, leaves);
  if constexpr (requires { options.Check(); }) {
    options.Check();
  } else {
    CheckRanges(options);
  }
  return options;
}

}  // namespace cvo
