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
// A record that can be interpreted only with another one takes that one as context:
// Field("row", row, table) calls Row::VisitFields(row, archive, table).
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

template <typename T, typename... Context>
concept JsonRecord = requires(T& record, internal::AnyArchive& archive, const Context&... context) {
  std::remove_const_t<T>::VisitFields(record, archive, context...);
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
[[noreturn]] void FailConstant(const char* key, const std::string& where, const std::string& found,
                               const std::string& expected);
void CheckCount(const Json& list, const std::string& where, std::size_t count);

}  // namespace internal

template <typename T, typename... Context>
Json ToJson(const T& value, const Context&... context);

class JsonWriter {
 public:
  static constexpr bool kReads = false;

  template <typename T, typename... Context>
  void Field(const char* key, const T& value, const Context&... context) {
    json_[key] = ToJson(value, context...);
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
  // A value that follows from other fields: written for the convenience of readers, and verified on
  // reading.
  void Constant(const char* key, const std::string& text) { json_[key] = text; }
  // A bool, written as one of two names.
  void Flag(const char* key, bool value, const char* if_false, const char* if_true) {
    json_[key] = value ? if_true : if_false;
  }
  // Whether the fields that belong to `key` are present: `has` when writing, the presence of `key`
  // when reading.
  bool Has(const char* /*key*/, bool has) const { return has; }
  // A list with one element per context.
  template <typename T, typename Context>
  void Each(const char* key, const std::vector<T>& values, const std::vector<Context>& contexts) {
    Json& list = json_[key] = Json::array();
    for (std::size_t i = 0; i < values.size(); ++i) list.push_back(ToJson(values[i], contexts[i]));
  }
  // An object with one value per name.
  template <typename T>
  void Named(const char* key, const std::vector<T>& values, const std::vector<std::string>& names) {
    Json& object = json_[key] = Json::object();
    for (std::size_t i = 0; i < values.size(); ++i) object[names[i]] = ToJson(values[i]);
  }
  Json Take() { return std::move(json_); }

 private:
  Json json_ = Json::object();
};

// Throws Error naming `where` and the field if the field is missing or has another type.
template <typename T, typename... Context>
T FromJson(const Json& json, const std::string& where, const Context&... context);

class JsonReader {
 public:
  static constexpr bool kReads = true;

  JsonReader(const Json& json, const std::string& where) : json_(json), where_(where) {
    if (!json_.is_object()) internal::FailType(json_, where_, "an object");
  }
  template <typename T, typename... Context>
  void Field(const char* key, T& value, const Context&... context) {
    value = FromJson<T>(At(key), Where<T>(key), context...);
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
  void Constant(const char* key, const std::string& text) {
    const std::string found = internal::ReadJsonText(At(key), Where<std::string>(key));
    if (found != text) internal::FailConstant(key, where_, found, text);
  }
  void Flag(const char* key, bool& value, const char* if_false, const char* if_true) {
    const std::array names = {if_false, if_true};
    const std::string name = internal::ReadJsonText(At(key), Where<std::string>(key));
    value = name == if_true;
    if (!value && name != if_false) {
      internal::FailName(At(key), Where<std::string>(key), names.data(), names.size());
    }
  }
  bool Has(const char* key, bool /*has*/) const { return json_.contains(key); }
  const std::string& where() const { return where_; }
  template <typename T, typename Context>
  void Each(const char* key, std::vector<T>& values, const std::vector<Context>& contexts) {
    const Json& list = At(key);
    internal::CheckCount(list, Where<std::vector<T>>(key), contexts.size());
    for (std::size_t i = 0; i < contexts.size(); ++i) {
      values.push_back(FromJson<T>(list[i], StrCat(where_, ", ", key, "[", i, "]"), contexts[i]));
    }
  }
  template <typename T>
  void Named(const char* key, std::vector<T>& values, const std::vector<std::string>& names) {
    const std::string where = StrCat(where_, ", ", key);
    JsonReader object(At(key), where);
    values.resize(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) object.Field(names[i].c_str(), values[i]);
  }

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

template <typename T, typename... Context>
Json ToJson(const T& value, const Context&... context) {
  if constexpr (NamedEnum<T>) {
    return NameOf(value);
  } else if constexpr (JsonRecord<T, Context...>) {
    JsonWriter writer;
    T::VisitFields(value, writer, context...);
    return writer.Take();
  } else if constexpr (internal::kIsOptional<T>) {
    return value ? ToJson(*value) : Json(nullptr);
  } else if constexpr (internal::kIsVector<T>) {
    Json list = Json::array();
    for (const auto& element : value) list.push_back(ToJson(element, context...));
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

template <typename T, typename... Context>
T FromJson(const Json& json, const std::string& where, const Context&... context) {
  if constexpr (NamedEnum<T>) {
    const std::string name = internal::ReadJsonText(json, where);
    const std::optional<T> value = EnumOf<T>(name);
    if (!value) {
      const auto names = EnumNames(T());
      internal::FailName(json, where, names.data(), names.size());
    }
    return *value;
  } else if constexpr (JsonRecord<T, Context...>) {
    T record;
    JsonReader reader(json, where);
    T::VisitFields(record, reader, context...);
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
      list.push_back(FromJson<Element>(element, where + place, context...));
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
