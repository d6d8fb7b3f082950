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
#include "core/files/json/json.h"

// A record lists its fields once, for both writing and reading, in the order of the file:
//   CVO_FIELDS(name, value);
// or, if not all of them are required,
//   CVO_RECORD(CVO_FIELD(name, value) CVO_OPTIONAL(log) CVO_ADDED(pair));
// An optional field is not written if it has its default value, and may be null; an added one is
// always written, but missing in older files. A record whose fields have other names than its
// members, or that checks them, has the function that these macros write:
//   template <typename Self, typename Archive>
//   static void VisitFields(Self& self, Archive& archive) {
//     archive.Field("name", self.name);
//   }
// Fields are numbers, bools, strings, named enums, records, and optionals, vectors, arrays of
// numbers and string-keyed maps of these. An enum E is written as the name of its value. Its names,
// in the order of its enumerators: constexpr std::array<const char*, n> EnumNames(E).
#define CVO_RECORD(...)                                   \
  template <typename Self, typename Archive>              \
  static void VisitFields(Self& self, Archive& archive) { \
    __VA_ARGS__                                           \
  }                                                       \
  static_assert(true)
#define CVO_FIELDS(...) CVO_RECORD(CVO_FIELD(__VA_ARGS__))
#define CVO_FIELD(...) NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(CVO_ONE_FIELD, __VA_ARGS__))
#define CVO_OPTIONAL(...) NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(CVO_ONE_OPTIONAL, __VA_ARGS__))
#define CVO_ADDED(...) NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(CVO_ONE_ADDED, __VA_ARGS__))
#define CVO_ONE_FIELD(member) archive.Field(#member, self.member);
#define CVO_ONE_OPTIONAL(member) archive.Optional(#member, self.member);
#define CVO_ONE_ADDED(member) archive.Added(#member, self.member);

namespace cvo {

namespace internal {
struct AnyArchive {};  // VisitFields is never instantiated with it
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

// Empty if no enumerator has this name.
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

// Whether T has named or numbered parts. Its place in errors is then "<where>, metrics" and not
// "<where>, field metrics".
template <typename T>
inline constexpr bool kHasParts =
    std::is_class_v<T> && !kIsArray<T> && !std::same_as<T, std::string> && !std::same_as<T, Json>;
template <typename T>
inline constexpr bool kHasParts<std::optional<T>> = kHasParts<T>;

[[noreturn]] void FailType(const Json& json, const std::string& where, const char* expected);
// Each throws Error if `json` has another type.
std::string ReadJsonText(const Json& json, const std::string& where);
double ReadJsonNumber(const Json& json, const std::string& where);
bool ReadJsonBool(const Json& json, const std::string& where);
std::int64_t ReadJsonInteger(const Json& json, const std::string& where, std::int64_t least,
                             std::int64_t most);
std::uint64_t ReadJsonCount(const Json& json, const std::string& where);
void ReadJsonNumbers(const Json& json, const std::string& where, double* numbers,
                     std::size_t count);
// Throws Error unless the file declares this schema version and kind.
void CheckFile(const Json& json, const std::string& where, int schema_version,
               const std::string& kind);
// Returns nullptr if there is no such field. Throws Error if `object` is not an object.
const Json* FindField(const Json& object, const char* key, const std::string& where);
[[noreturn]] void FailMissing(const char* key, const std::string& where);
[[noreturn]] void FailName(const Json& json, const std::string& where, const char* const* names,
                           std::size_t count);

}  // namespace internal

template <typename T>
Json ToJson(const T& value);

class JsonWriter {
 public:
  static constexpr bool kReads = false;

  template <typename T>
  void Field(const char* key, const T& value) {
    json_[key] = ToJson(value);
  }
  template <typename T>
  void Optional(const char* key, const T& value) {
    if constexpr (internal::kIsOptional<T>) {
      if (value) Field(key, *value);
    } else if (!(value == T())) {
      Field(key, value);
    }
  }
  template <typename T>
  void Added(const char* key, const T& value) {
    Field(key, value);
  }
  Json Take() { return std::move(json_); }

 private:
  Json json_ = Json::object();
};

// Throws Error naming `where` and the field if the field is missing or has another type.
template <typename T>
T FromJson(const Json& json, const std::string& where);

class JsonReader {
 public:
  static constexpr bool kReads = true;

  JsonReader(const Json& json, const std::string& where) : json_(json), where_(where) {
    if (!json_.is_object()) internal::FailType(json_, where_, "an object");
  }
  template <typename T>
  void Field(const char* key, T& value) {
    value = FromJson<T>(At(key), Where<T>(key));
  }
  template <typename T>
  void Optional(const char* key, T& value) {
    const Json* found = internal::FindField(json_, key, where_);
    if (found != nullptr && !found->is_null()) Field(key, value);
  }
  template <typename T>
  void Added(const char* key, T& value) {
    Optional(key, value);
  }
  const std::string& where() const { return where_; }

 private:
  const Json& At(const char* key) const {
    const Json* found = internal::FindField(json_, key, where_);
    if (found == nullptr) internal::FailMissing(key, where_);
    return *found;
  }
  template <typename T>
  std::string Where(const char* key) const {
    return where_ + (internal::kHasParts<T> ? ", " : ", field ") + key;
  }

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

// A whole file, which starts with its schema version and kind: T::kSchemaVersion and T::kKind.
template <JsonRecord T>
Json FileJson(const T& record) {
  JsonWriter writer;
  writer.Field("schema_version", T::kSchemaVersion);
  writer.Field("kind", std::string(T::kKind));
  T::VisitFields(record, writer);
  return writer.Take();
}
template <JsonRecord T>
std::string FileText(const T& record) {
  return DumpJson(FileJson(record));
}
template <JsonRecord T>
T ReadRecord(const Json& json, const std::string& where) {
  internal::CheckFile(json, where, T::kSchemaVersion, T::kKind);
  return FromJson<T>(json, where);
}
template <JsonRecord T>
T ReadRecord(const std::filesystem::path& file, const std::vector<std::string>& skipped = {}) {
  return ReadRecord<T>(ReadJson(file, skipped), file.string());
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
    using Element = typename T::value_type;
    T list;
    for (const Json& element : json) {
      const std::string place = internal::kHasParts<Element> ? StrCat("[", list.size(), "]") : "";
      list.push_back(FromJson<Element>(element, where + place));
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
