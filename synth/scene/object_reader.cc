// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/scene/object_reader.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"

namespace cvo::synth {
namespace {

// Formats a value as JSON, truncated to fit a line.
std::string Shown(const Json& value) {
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  constexpr std::size_t kLongest = 60;
  return text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
}

}  // namespace

ObjectReader::ObjectReader(const Json& object, std::string where, std::string path)
    : object_(&object), where_(std::move(where)), path_(std::move(path)) {
  if (!object.is_object()) ThrowError(Where(""), Shown(object), "an object");
}

std::string ObjectReader::Path(const std::string& key) const {
  if (key.empty() || path_.empty()) return path_ + key;
  return path_ + "." + key;
}

std::string ObjectReader::Where(const std::string& key) const {
  const std::string path = Path(key);
  return path.empty() ? where_ : where_ + ", " + path;
}

bool ObjectReader::Has(const std::string& key) {
  AddOnce(key, known_);
  return object_->contains(key);
}

const Json& ObjectReader::Value(const std::string& key) {
  if (Has(key)) return (*object_)[key];
  // Report a misspelt key rather than a missing one, which is more helpful.
  for (const auto& [other, value] : object_->items()) {
    const bool is_known = std::find(known_.begin(), known_.end(), other) != known_.end();
    if (!is_known && !ClosestNames(other, {key}).empty()) FailUnknown(other);
  }
  ThrowError(Where(key), "no such key", "a value");
}

double ObjectReader::CheckedNumber(const Json& value, Range range, const std::string& where) const {
  if (!value.is_number()) ThrowError(where, Shown(value), "a number");
  const double number = value.get<double>();
  if (!(number >= range.min && number <= range.max)) {
    ThrowError(where, Shown(value), StrCat("a value in [", range.min, ", ", range.max, "]"));
  }
  return number;
}

double ObjectReader::Number(const std::string& key, Range range) {
  return CheckedNumber(Value(key), range, Where(key));
}

double ObjectReader::NumberOr(const std::string& key, Range range, double fallback) {
  return Has(key) ? Number(key, range) : fallback;
}

int ObjectReader::Integer(const std::string& key, Range range) {
  const Json& value = Value(key);
  if (!value.is_number_integer()) ThrowError(Where(key), Shown(value), "an integer");
  return static_cast<int>(CheckedNumber(value, range, Where(key)));
}

int ObjectReader::IntegerOr(const std::string& key, Range range, int fallback) {
  return Has(key) ? Integer(key, range) : fallback;
}

std::uint64_t ObjectReader::SeedOr(const std::string& key, std::uint64_t fallback) {
  if (!Has(key)) return fallback;
  const Json& value = Value(key);
  if (!value.is_number_unsigned()) {
    ThrowError(Where(key), Shown(value), "an integer from 0 to 18446744073709551615");
  }
  return value.get<std::uint64_t>();
}

bool ObjectReader::BoolOr(const std::string& key, bool fallback) {
  if (!Has(key)) return fallback;
  const Json& value = Value(key);
  if (!value.is_boolean()) ThrowError(Where(key), Shown(value), "true or false");
  return value.get<bool>();
}

std::string ObjectReader::Text(const std::string& key) {
  const Json& value = Value(key);
  if (!value.is_string()) ThrowError(Where(key), Shown(value), "a text");
  return value.get<std::string>();
}

std::string ObjectReader::TextOr(const std::string& key, const std::string& fallback) {
  return Has(key) ? Text(key) : fallback;
}

std::vector<double> ObjectReader::Numbers(const std::string& key, Range range,
                                          const std::set<int>& sizes) {
  const Json& value = Value(key);
  if (!value.is_array() || !sizes.contains(static_cast<int>(value.size()))) {
    ThrowError(Where(key), Shown(value), "a list of " + Joined(sizes, " or ") + " numbers");
  }
  std::vector<double> numbers;
  for (const Json& element : value) {
    const std::string where = StrCat(Where(key), ".", numbers.size());
    numbers.push_back(CheckedNumber(element, range, where));
  }
  return numbers;
}

Eigen::Vector3d ObjectReader::Vector3(const std::string& key, Range range) {
  return Eigen::Vector3d(Numbers(key, range, {3}).data());
}

Eigen::Vector3d ObjectReader::Vector3Or(const std::string& key, Range range,
                                        const Eigen::Vector3d& fallback) {
  return Has(key) ? Vector3(key, range) : fallback;
}

std::vector<std::vector<double>> ObjectReader::Rows(const std::string& key, Range range, int size,
                                                    int least) {
  constexpr int kMost = 1000;
  const Json& value = Value(key);
  const int count = value.is_array() ? static_cast<int>(value.size()) : 0;
  if (count < least || count > kMost) {
    ThrowError(Where(key), count > kMost ? StrCat(count, " lists") : Shown(value),
               StrCat("a list of ", least, " to ", kMost, " lists of ", size, " numbers"));
  }
  std::vector<std::vector<double>> rows;
  for (const Json& element : value) {
    // Read the row as if it were the value of a key.
    const std::string index = std::to_string(rows.size());
    const Json holder = Json::object({{index, element}});
    rows.push_back(ObjectReader(holder, where_, Path(key)).Numbers(index, range, {size}));
  }
  return rows;
}

ObjectReader ObjectReader::Object(const std::string& key) {
  return {Value(key), where_, Path(key)};
}

std::vector<ObjectReader> ObjectReader::ObjectsOr(const std::string& key) {
  if (!Has(key)) return {};
  const Json& value = Value(key);
  if (!value.is_array()) ThrowError(Where(key), Shown(value), "a list of objects");
  std::vector<ObjectReader> objects;
  for (const Json& element : value) {
    objects.emplace_back(element, where_, StrCat(Path(key), ".", objects.size()));
  }
  return objects;
}

void ObjectReader::FailUnknown(const std::string& key) const {
  ThrowError(Where(key), "an unknown key", OneOfKnown(key, known_));
}

void ObjectReader::Finish() const {
  for (const auto& [key, value] : object_->items()) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) FailUnknown(key);
  }
}

std::string ObjectReader::OneOf(const std::vector<std::string>& keys) {
  std::string found;
  std::string all;
  for (const std::string& key : keys) {
    all += (all.empty() ? "" : ", ") + key;
    if (!Has(key)) continue;
    if (!found.empty()) ThrowError(Where(""), found + " and " + key, "exactly one of " + all);
    found = key;
  }
  if (!found.empty()) return found;
  for (const auto& [other, value] : object_->items()) {
    if (!ClosestNames(other, keys).empty()) FailUnknown(other);
  }
  ThrowError(Where(""), "none of " + all, "exactly one of them");
}

}  // namespace cvo::synth
