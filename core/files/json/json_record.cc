// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/json/json_record.h"

#include "core/files/text_file.h"

namespace cvo::internal {

void FailType(const Json& json, const std::string& where, const char* expected) {
  ThrowError(where, json.is_number() ? json.dump() : StrCat("a JSON ", json.type_name()), expected);
}

std::string ReadJsonText(const Json& json, const std::string& where) {
  if (!json.is_string()) FailType(json, where, "text");
  return json.get<std::string>();
}

double ReadJsonNumber(const Json& json, const std::string& where) {
  if (!json.is_number()) FailType(json, where, "a number");
  return json.get<double>();
}

bool ReadJsonBool(const Json& json, const std::string& where) {
  if (!json.is_boolean()) FailType(json, where, "true or false");
  return json.get<bool>();
}

std::int64_t ReadJsonInteger(const Json& json, const std::string& where, std::int64_t least,
                             std::int64_t most) {
  if (!json.is_number_integer()) FailType(json, where, "an integer");
  const bool too_large =
      json.is_number_unsigned() && json.get<std::uint64_t>() > static_cast<std::uint64_t>(most);
  if (too_large || json.get<std::int64_t>() < least || json.get<std::int64_t>() > most) {
    FailType(json, where, StrCat("an integer from ", least, " to ", most).c_str());
  }
  return json.get<std::int64_t>();
}

std::uint64_t ReadJsonCount(const Json& json, const std::string& where) {
  if (!json.is_number_integer() || (!json.is_number_unsigned() && json.get<std::int64_t>() < 0)) {
    FailType(json, where, "an integer from 0");
  }
  return json.get<std::uint64_t>();
}

void ReadJsonNumbers(const Json& json, const std::string& where, double* numbers,
                     std::size_t count) {
  bool good = json.is_array() && json.size() == count;
  for (std::size_t i = 0; good && i < count; ++i) good = json[i].is_number();
  if (!good) ThrowError(where, json.dump().substr(0, 80), StrCat(count, " numbers"));
  for (std::size_t i = 0; i < count; ++i) numbers[i] = json[i].get<double>();
}

void CheckFile(const Json& json, const std::string& where, int schema_version,
               const std::string& kind) {
  const Json* found_version = FindField(json, "schema_version", where);
  const Json* found_kind = FindField(json, "kind", where);
  if (found_version == nullptr || found_kind == nullptr) {
    ThrowError(where, "JSON without schema_version and kind", StrCat("kind \"", kind, "\""));
  }
  if (*found_kind != kind) {
    ThrowError(where, "kind " + found_kind->dump(), StrCat("kind \"", kind, "\""));
  }
  if (*found_version != schema_version) {
    ThrowError(where, "schema_version " + found_version->dump(), StrCat(schema_version));
  }
}

const Json* FindField(const Json& object, const char* key, const std::string& where) {
  if (!object.is_object()) FailType(object, where, "an object");
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

void FailMissing(const char* key, const std::string& where) {
  ThrowError(StrCat(where, ", field ", key), "nothing", "a value");
}

void FailName(const Json& json, const std::string& where, const char* const* names,
              std::size_t count) {
  std::string expected;
  for (std::size_t i = 0; i < count; ++i) expected += StrCat(i > 0 ? ", \"" : "\"", names[i], "\"");
  ThrowError(where, Quoted(json.get<std::string>()), "one of " + expected);
}

}  // namespace cvo::internal
