// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/results/json_fields.h"

#include "reports/results/json_text.h"

namespace cvo::reports {

Json ParseJson(std::string_view text, const std::string& where) {
  if (text.empty()) ThrowError(where, "an empty file", "JSON");
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    ThrowError(where,
               error.byte > text.size() ? StrCat("text that ends after ", text.size(), " bytes")
                                        : StrCat("text that breaks off at byte ", error.byte),
               "one complete JSON value");
  } catch (const Json::exception& error) {
    ThrowError(where, error.what(), "JSON");
  }
}

Json ReadJson(const std::filesystem::path& file) {
  return ParseJson(ReadText(file), file.string());
}

Fields::Fields(const Json& json, std::string where) : json_(json), where_(std::move(where)) {
  if (!json_.is_object()) ThrowError(where_, StrCat("a JSON ", json_.type_name()), "an object");
}

const Json& Fields::At(const char* key, bool (*is_type)(const Json&), const char* expected) const {
  const auto found = json_.find(key);
  if (found == json_.end()) ThrowError(StrCat(where_, ", field ", key), "nothing", expected);
  if (!is_type(*found)) {
    ThrowError(StrCat(where_, ", field ", key), StrCat("a JSON ", found->type_name()), expected);
  }
  return *found;
}

std::string Fields::Text(const char* key) const {
  const auto is_text = [](const Json& json) { return json.is_string(); };
  return At(key, is_text, "text").get<std::string>();
}

double Fields::Number(const char* key) const {
  const auto is_number = [](const Json& json) { return json.is_number(); };
  return At(key, is_number, "a number").get<double>();
}

std::int64_t Fields::Integer(const char* key) const {
  const auto is_integer = [](const Json& json) { return json.is_number_integer(); };
  return At(key, is_integer, "an integer").get<std::int64_t>();
}

bool Fields::Bool(const char* key) const {
  const auto is_bool = [](const Json& json) { return json.is_boolean(); };
  return At(key, is_bool, "true or false").get<bool>();
}

Fields Fields::Object(const char* key) const {
  const auto is_object = [](const Json& json) { return json.is_object(); };
  return {At(key, is_object, "an object"), StrCat(where_, ", ", key)};
}

const Json& Fields::Array(const char* key) const {
  const auto is_array = [](const Json& json) { return json.is_array(); };
  return At(key, is_array, "an array");
}

std::vector<std::string> Fields::Texts(const char* key) const {
  std::vector<std::string> texts;
  for (const Json& text : Array(key)) {
    if (!text.is_string()) {
      ThrowError(StrCat(where_, ", field ", key), StrCat("a JSON ", text.type_name()), "texts");
    }
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

std::map<std::string, std::string> Fields::NamedTexts(const char* key) const {
  const Fields object = Object(key);
  std::map<std::string, std::string> texts;
  for (const auto& [name, value] : object.json().items()) texts[name] = object.Text(name.c_str());
  return texts;
}

void CheckSchema(const Fields& fields, int expected) {
  const std::int64_t found = fields.Integer("schema_version");
  if (found != expected) {
    ThrowError(fields.where(), StrCat("schema_version ", found), StrCat(expected));
  }
}

}  // namespace cvo::reports
