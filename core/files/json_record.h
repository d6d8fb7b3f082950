// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/error.h"
#include "core/files/json.h"

// A record lists its fields once, for writing and for reading:
//   template <typename Self, typename Archive>
//   static void VisitFields(Self& self, Archive& archive) {
//     archive.Field("name", self.name);
//     archive.Optional("log", self.log);  // left out where it is as by default, or null
//   }
// Fields are numbers, bools, texts, enums with names, records, and optionals, vectors, arrays of
// numbers and maps by text of these. An enum E is written by its names, in the order of its
// enumerators: constexpr std::array<const char*, n> EnumNames(E).
namespace cvo {

namespace internal {
struct AnyArchive {
  template <typename T>
  void Field(const char*, T&) {}
  template <typename T>
  void Optional(const char*, T&) {}
};
}  // namespace internal

template <typename T>
concept JsonRecord = requires(T& record, internal::AnyArchive& archive) {
  std::remove_const_t<T>::VisitFields(record, archive);
};

template <typename E>
concept NamedEnum = std::is_enum_v<E> && requires(E value) {
  EnumNames(value);
};

template <NamedEnum E>
const char* NameOf(E value) {
  return EnumNames(value)[static_cast<std::size_t>(value)];
}

// Empty for a text that is no name.
template <NamedEnum E>
std::optional<E> EnumOf(std::string_view name) {
  const auto names = EnumNames(E());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<E>(i);
  }
  return std::nullopt;
}

namespace internal {

template <typename T>
inline constexpr bool kIsOptional = false;
template <typename T>
inline constexpr bool kIsOptional<std::optional<T>> = true;
template <typename T>
inline constexpr bool kIsVector = false;
template <typename T>
inline constexpr bool kIsVector<std::vector<T>> = true;
template <typename T>
inline constexpr bool kIsMap = false;
template <typename T>
inline constexpr bool kIsMap<std::map<std::string, T>> = true;

template <typename T>
inline constexpr bool kIsArray = false;
template <typename T, std::size_t kSize>
inline constexpr bool kIsArray<std::array<T, kSize>> = true;

// What its elements are named in errors: "<where>, metrics" and not "<where>, field metrics".
template <typename T>
inline constexpr bool kHasParts = JsonRecord<T> || kIsVector<T> || kIsMap<T>;
template <typename T>
inline constexpr bool kHasParts<std::optional<T>> = kHasParts<T>;

[[noreturn]] void FailType(const Json& json, const std::string& where, const char* expected);
// Throw Error where `json` is of another type.
std::string ReadJsonText(const Json& json, const std::string& where);
double ReadJsonNumber(const Json& json, const std::string& where);
bool ReadJsonBool(const Json& json, const std::string& where);
std::int64_t ReadJsonInteger(const Json& json, const std::string& where, std::int64_t least,
                             std::int64_t most);
std::uint64_t ReadJsonCount(const Json& json, const std::string& where);
void ReadJsonNumbers(const Json& json, const std::string& where, double* numbers,
                     std::size_t count);
// Throws Error unless the file says so of itself.
void CheckFile(const Json& json, const std::string& where, int schema_version, const char* kind);
// nullptr where there is none. Throws Error where `object` is no object.
const Json* FindField(const Json& object, const char* key, const std::string& where);
[[noreturn]] void FailMissing(const char* key, const std::string& where);
[[noreturn]] void FailName(const Json& json, const std::string& where, const char* const* names,
                           std::size_t count);

}  // namespace internal

template <typename T>
Json ToJson(const T& value);

class JsonWriter {
 public:
  template <typename T>
  void Field(const char* key, const T& value) {
    json_[key] = ToJson(value);
  }
  template <typename T>
  void Optional(const char* key, const T& value) {
    if (!(value == T())) Field(key, value);
  }
  Json Take() { return std::move(json_); }

 private:
  Json json_ = Json::object();
};

// Throws Error naming `where` and the field, which is missing or of another type.
template <typename T>
T FromJson(const Json& json, const std::string& where);

class JsonReader {
 public:
  JsonReader(const Json& json, const std::string& where) : json_(json), where_(where) {
    if (!json_.is_object()) internal::FailType(json_, where_, "an object");
  }
  template <typename T>
  void Field(const char* key, T& value) {
    const Json* found = internal::FindField(json_, key, where_);
    if (found == nullptr) internal::FailMissing(key, where_);
    value = FromJson<T>(*found, where_ + (internal::kHasParts<T> ? ", " : ", field ") + key);
  }
  template <typename T>
  void Optional(const char* key, T& value) {
    const Json* found = internal::FindField(json_, key, where_);
    if (found != nullptr && !found->is_null()) Field(key, value);
  }

 private:
  const Json& json_;
  const std::string& where_;
};

template <typename T>
Json ToJson(const T& value) {
  if constexpr (NamedEnum<T>) {
    return NameOf(value);
  } else if constexpr (JsonRecord<T>) {
    JsonWriter writer;
    T::VisitFields(value, writer);
    return writer.Take();
  } else if constexpr (internal::kIsOptional<T>) {
    return value ? ToJson(*value) : Json(nullptr);
  } else if constexpr (internal::kIsVector<T>) {
    Json list = Json::array();
    for (const auto& element : value) list.push_back(ToJson(element));
    return list;
  } else if constexpr (internal::kIsMap<T>) {
    Json object = Json::object();
    for (const auto& [key, element] : value) object[key] = ToJson(element);
    return object;
  } else {
    return Json(value);
  }
}

// A whole file, which says its schema version and kind first: T::kSchemaVersion and T::kKind.
template <JsonRecord T>
std::string FileText(const T& record) {
  JsonWriter writer;
  writer.Field("schema_version", T::kSchemaVersion);
  writer.Field("kind", std::string(T::kKind));
  T::VisitFields(record, writer);
  return DumpJson(writer.Take());
}
template <JsonRecord T>
T ReadRecord(const std::filesystem::path& file) {
  const Json json = ReadJson(file);
  internal::CheckFile(json, file.string(), T::kSchemaVersion, T::kKind);
  return FromJson<T>(json, file.string());
}

template <typename T>
T FromJson(const Json& json, const std::string& where) {
  if constexpr (NamedEnum<T>) {
    const std::string name = internal::ReadJsonText(json, where);
    const std::optional<T> value = EnumOf<T>(name);
    if (!value) {
      const auto names = EnumNames(T());
      internal::FailName(json, where, names.data(), names.size());
    }
    return *value;
  } else if constexpr (JsonRecord<T>) {
    T record;
    JsonReader reader(json, where);
    T::VisitFields(record, reader);
    return record;
  } else if constexpr (internal::kIsOptional<T>) {
    if (json.is_null()) return std::nullopt;
    return FromJson<typename T::value_type>(json, where);
  } else if constexpr (internal::kIsVector<T>) {
    if (!json.is_array()) internal::FailType(json, where, "an array");
    T list;
    for (const Json& element : json) {
      list.push_back(FromJson<typename T::value_type>(element, where));
    }
    return list;
  } else if constexpr (internal::kIsMap<T>) {
    if (!json.is_object()) internal::FailType(json, where, "an object");
    T map;
    for (const auto& [key, element] : json.items()) {
      constexpr const char* kNext =
          internal::kHasParts<typename T::mapped_type> ? ", " : ", field ";
      map[key] = FromJson<typename T::mapped_type>(element, where + kNext + key);
    }
    return map;
  } else if constexpr (internal::kIsArray<T>) {
    T numbers{};
    internal::ReadJsonNumbers(json, where, numbers.data(), numbers.size());
    return numbers;
  } else if constexpr (std::same_as<T, Json>) {
    return json;
  } else if constexpr (std::same_as<T, std::string>) {
    return internal::ReadJsonText(json, where);
  } else if constexpr (std::same_as<T, bool>) {
    return internal::ReadJsonBool(json, where);
  } else if constexpr (std::floating_point<T>) {
    return internal::ReadJsonNumber(json, where);
  } else if constexpr (std::unsigned_integral<T>) {
    static_assert(sizeof(T) == 8);
    return internal::ReadJsonCount(json, where);
  } else {
    static_assert(std::signed_integral<T>);
    return static_cast<T>(internal::ReadJsonInteger(json, where, std::numeric_limits<T>::min(),
                                                    std::numeric_limits<T>::max()));
  }
}

}  // namespace cvo
