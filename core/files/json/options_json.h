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

// Reference to one option of an options struct, which must outlive it, with its dotted path.
struct OptionLeaf {
  std::string path;
  std::variant<bool*, int*, double*> value;
  FieldInfo info;
};

// Returns all options of `options`, in the order of their visitor.
template <OptionsStruct Options>
std::vector<OptionLeaf> OptionLeaves(Options& options) {
  std::vector<OptionLeaf> leaves;
  VisitLeaves(options, [&leaves](const std::string& path, auto& value, const FieldInfo& info) {
    leaves.push_back({path, &value, info});
  });
  return leaves;
}

// Overwrites current values with those in nested objects: {"window": {"spatial": 5}}. Throws Error
// with the dotted path if a key is not an option, or a value has the wrong type or is outside its
// range. `where` names the source in errors.
void MergeOptions(const Json& config, const std::string& where,
                  const std::vector<OptionLeaf>& leaves);

// Applies an assignment such as "window.spatial=5". Throws Error unless the whole value is a bool,
// int or double, as the option requires, and within its range.
void SetOption(std::string_view assignment, const std::vector<OptionLeaf>& leaves);

// Returns the current values as nested objects.
Json OptionsToJson(const std::vector<OptionLeaf>& leaves);

Json ValueToJson(const OptionLeaf& leaf);

// Returns `options` (the defaults) overridden by the file, unless its name is empty, and then by
// the assignments in their order. Throws Error if an option is invalid.
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
