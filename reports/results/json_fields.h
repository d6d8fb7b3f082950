// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace cvo::reports {

using Json = nlohmann::ordered_json;

// Throws Error naming `where` and the byte for text that is not one JSON value.
Json ParseJson(std::string_view text, const std::string& where);
Json ReadJson(const std::filesystem::path& file);

// An object that remembers where it came from, for errors.
class Fields {
 public:
  // Throws Error where `json` is no object. It must outlive this.
  Fields(const Json& json, std::string where);

  bool Has(const char* key) const { return json_.contains(key); }
  const std::string& where() const { return where_; }

  // Each throws Error naming the field where it is missing or of another type.
  std::string Text(const char* key) const;
  double Number(const char* key) const;
  std::int64_t Integer(const char* key) const;
  bool Bool(const char* key) const;
  Fields Object(const char* key) const;
  const Json& Array(const char* key) const;
  std::vector<std::string> Texts(const char* key) const;
  std::map<std::string, std::string> NamedTexts(const char* key) const;

  const Json& json() const { return json_; }

 private:
  const Json& At(const char* key, bool (*is_type)(const Json&), const char* expected) const;

  const Json& json_;
  std::string where_;
};

// Throws Error unless the object's schema_version is the one that is read here.
void CheckSchema(const Fields& fields, int expected);

}  // namespace cvo::reports
