// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/files/json.h"

namespace cvo {

// A JSON object that remembers where it came from, for errors. Each call but Has throws Error
// naming the field where it is missing or of another type.
class Fields {
 public:
  // Throws Error where `json` is no object. It must outlive this.
  Fields(const Json& json, std::string where);

  bool Has(const char* key) const { return json_.contains(key); }
  const std::string& where() const { return where_; }

  std::string Text(const char* key) const;
  std::string TextOr(const char* key, const std::string& fallback) const;
  double Number(const char* key) const;
  std::int64_t Integer(const char* key) const;
  std::uint64_t Count(const char* key) const;  // an integer from 0
  bool Bool(const char* key) const;
  Fields Object(const char* key) const;
  const Json& Array(const char* key) const;
  std::vector<std::string> Texts(const char* key) const;
  std::vector<std::uint64_t> Counts(const char* key) const;
  std::map<std::string, std::string> NamedTexts(const char* key) const;

  const Json& json() const { return json_; }

  // Each throws Error unless schema_version, or kind as well, is this.
  void CheckSchema(int schema_version) const;
  void Check(int schema_version, const std::string& kind) const;

 private:
  const Json& At(const char* key, bool (*is_type)(const Json&), const char* expected) const;
  // Of each element of an array.
  template <typename T>
  std::vector<T> List(const char* key, bool (*is_type)(const Json&), const char* expected) const;
  [[noreturn]] void Fail(const char* key, const std::string& found, const char* expected) const;

  const Json& json_;
  std::string where_;
};

}  // namespace cvo
