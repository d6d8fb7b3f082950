// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/json_fields.h"

namespace cvo {
namespace {

bool IsText(const Json& json) { return json.is_string(); }
bool IsNumber(const Json& json) { return json.is_number(); }
bool IsInteger(const Json& json) { return json.is_number_integer(); }
// Numbers above 2^63 - 1 would change their sign.
bool IsSigned(const Json& json) {
  return IsInteger(json) && (!json.is_number_unsigned() || json.get<std::int64_t>() >= 0);
}
bool IsCount(const Json& json) { return json.is_number_unsigned(); }
bool IsBool(const Json& json) { return json.is_boolean(); }
bool IsObject(const Json& json) { return json.is_object(); }
bool IsArray(const Json& json) { return json.is_array(); }

std::string Shown(const Json& json) {
  return json.is_number() ? json.dump() : StrCat("a JSON ", json.type_name());
}

}  // namespace

Fields::Fields(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
  if (!json_.is_object()) ThrowError(where_, StrCat("a JSON ", json_.type_name()), "an object");
}

void Fields::Fail(const char* key, const std::string& found, const char* expected) const {
  ThrowError(StrCat(where_, ", field ", key), found, expected);
}

const Json& Fields::At(const char* key, bool (*is_type)(const Json&), const char* expected) const {
  const auto found = json_.find(key);
  if (found == json_.end()) Fail(key, "nothing", expected);
  if (!is_type(*found)) Fail(key, Shown(*found), expected);
  return *found;
}

std::string Fields::Text(const char* key) const {
  return At(key, IsText, "text").get<std::string>();
}

std::string Fields::TextOr(const char* key, const std::string& fallback) const {
  return Has(key) ? Text(key) : fallback;
}

double Fields::Number(const char* key) const { return At(key, IsNumber, "a number").get<double>(); }

std::int64_t Fields::Integer(const char* key) const {
  return At(key, IsSigned, "an integer").get<std::int64_t>();
}

std::uint64_t Fields::Count(const char* key) const {
  return At(key, IsCount, "an integer from 0").get<std::uint64_t>();
}

bool Fields::Bool(const char* key) const { return At(key, IsBool, "true or false").get<bool>(); }

Fields Fields::Object(const char* key) const {
  return {At(key, IsObject, "an object"), StrCat(where_, ", ", key)};
}

const Json& Fields::Array(const char* key) const { return At(key, IsArray, "an array"); }

template <typename T>
std::vector<T> Fields::List(const char* key, bool (*is_type)(const Json&),
                            const char* expected) const {
  std::vector<T> values;
  for (const Json& element : Array(key)) {
    if (!is_type(element)) Fail(key, Shown(element), expected);
    values.push_back(element.get<T>());
  }
  return values;
}

std::vector<std::string> Fields::Texts(const char* key) const {
  return List<std::string>(key, IsText, "texts");
}

std::vector<std::uint64_t> Fields::Counts(const char* key) const {
  return List<std::uint64_t>(key, IsCount, "integers from 0");
}

std::map<std::string, std::string> Fields::NamedTexts(const char* key) const {
  const Fields object = Object(key);
  std::map<std::string, std::string> texts;
  for (const auto& [name, value] : object.json().items()) texts[name] = object.Text(name.c_str());
  return texts;
}

void Fields::CheckSchema(int schema_version) const {
  const std::int64_t found = Integer("schema_version");
  if (found != schema_version) {
    ThrowError(where_, StrCat("schema_version ", found), StrCat(schema_version));
  }
}

void Fields::Check(int schema_version, const std::string& kind) const {
  CheckSchema(schema_version);
  if (Text("kind") != kind) {
    ThrowError(where_, StrCat("kind \"", Text("kind"), "\""), StrCat("\"", kind, "\""));
  }
}

}  // namespace cvo
