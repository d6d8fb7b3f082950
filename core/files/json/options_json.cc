// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/json/options_json.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"

namespace cvo {
namespace {

bool IsGroup(const std::string& path, const std::vector<OptionLeaf>& leaves) {
  const std::string start = path + ".";
  return std::any_of(leaves.begin(), leaves.end(),
                     [&start](const OptionLeaf& leaf) { return leaf.path.starts_with(start); });
}

[[noreturn]] void ThrowUnknown(const std::string& where, std::string_view path,
                               const std::vector<OptionLeaf>& leaves) {
  std::vector<std::string> known;
  for (const OptionLeaf& leaf : leaves) known.push_back(leaf.path);
  // A short list of names is more helpful than a reference to where they are listed.
  constexpr std::size_t kShort = 20;
  const std::string expected =
      known.size() <= kShort
          ? OneOfKnown(path, known)
          : "one of those that `clustervo list options` lists" + DidYouMean(path, known);
  ThrowError(where, StrCat("unknown option ", path), expected);
}

// Formats a value as the source wrote it, truncated to fit a line.
std::string Shown(const Json& value) {
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  constexpr std::size_t kLongest = 60;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

const char* Expected(const OptionLeaf& leaf) {
  if (std::holds_alternative<bool*>(leaf.value)) return "true or false";
  return std::holds_alternative<int*>(leaf.value) ? "an integer" : "a finite number";
}

void CheckRange(const OptionLeaf& leaf, double number, const std::string& where) {
  if (!(number >= leaf.info.min && number <= leaf.info.max)) {
    ThrowError(StrCat(where, ", option ", leaf.path), StrCat(number),
               StrCat("a value in [", leaf.info.min, ", ", leaf.info.max, "]"));
  }
}

// Reads a value of an option from JSON. Empty if it has another type.
template <typename T>
std::optional<T> Read(const Json& value) {
  if constexpr (std::same_as<T, bool>) {
    if (value.is_boolean()) return value.get<bool>();
  } else if constexpr (std::same_as<T, int>) {
    constexpr double kMost = std::numeric_limits<int>::max();
    if (value.is_number_integer() && std::abs(value.get<double>()) <= kMost) {
      return value.get<int>();
    }
  } else if (value.is_number()) {
    return value.get<double>();
  }
  return std::nullopt;
}

// The same from text.
template <typename T>
std::optional<T> Read(std::string_view text) {
  if constexpr (std::same_as<T, bool>) {
    if (text == "true" || text == "false") return text == "true";
    return std::nullopt;
  } else if constexpr (std::same_as<T, int>) {
    return ParseInt(text);
  } else {
    return ParseDouble(text);
  }
}

std::string Found(const Json& value) { return Shown(value); }
std::string Found(std::string_view text) { return StrCat("'", text, "'"); }

// Throws Error if the source has another type or is out of range.
template <typename Source>
void Store(const OptionLeaf& leaf, const Source& source, const std::string& where) {
  std::visit(
      [&]<typename T>(T* target) {
        const std::optional<T> read = Read<T>(source);
        if (!read) ThrowError(StrCat(where, ", option ", leaf.path), Found(source), Expected(leaf));
        CheckRange(leaf, static_cast<double>(*read), where);
        *target = *read;
      },
      leaf.value);
}

void MergeGroup(const Json& group, const std::string& prefix, const std::string& where,
                const std::vector<OptionLeaf>& leaves) {
  for (const auto& [key, value] : group.items()) {
    if (key.find('.') != std::string::npos) {
      ThrowError(where, StrCat("key \"", key, "\""), "nested objects instead of a dotted key");
    }
    const std::string path = prefix.empty() ? key : prefix + "." + key;
    if (const OptionLeaf* leaf = FindBy(leaves, &OptionLeaf::path, path)) {
      Store(*leaf, value, where);
    } else if (!IsGroup(path, leaves)) {
      ThrowUnknown(where, path, leaves);
    } else if (!value.is_object()) {
      ThrowError(StrCat(where, ", option ", path), Shown(value), "an object of options");
    } else {
      MergeGroup(value, path, where, leaves);
    }
  }
}

}  // namespace

void MergeOptions(const Json& config, const std::string& where,
                  const std::vector<OptionLeaf>& leaves) {
  if (!config.is_object()) ThrowError(where, StrCat("a JSON ", config.type_name()), "an object");
  MergeGroup(config, "", where, leaves);
}

void SetOption(std::string_view assignment, const std::vector<OptionLeaf>& leaves) {
  const std::string where = StrCat("--set ", assignment);
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    ThrowError(where, "no '='", "PATH=VALUE, for example orb.features=2000");
  }
  const std::string_view path = assignment.substr(0, equals);
  const std::string_view text = assignment.substr(equals + 1);
  const OptionLeaf* leaf = FindBy(leaves, &OptionLeaf::path, path);
  if (leaf == nullptr) ThrowUnknown(where, path, leaves);
  Store(*leaf, text, where);
}

Json OptionsToJson(const std::vector<OptionLeaf>& leaves) {
  Json options = Json::object();
  for (const OptionLeaf& leaf : leaves) {
    Json* at = &options;
    std::size_t begin = 0;
    for (std::size_t dot = leaf.path.find('.'); dot != std::string::npos;
         dot = leaf.path.find('.', begin)) {
      at = &(*at)[leaf.path.substr(begin, dot - begin)];
      begin = dot + 1;
    }
    (*at)[leaf.path.substr(begin)] = ValueToJson(leaf);
  }
  return options;
}

Json ValueToJson(const OptionLeaf& leaf) {
  return std::visit([](const auto* value) { return Json(*value); }, leaf.value);
}

}  // namespace cvo
