// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/files/json/json.h"

namespace cvo::synth {

// The closed interval [min, max].
struct Range {
  double min = 0.0;
  double max = 0.0;
};
inline constexpr Range kPlace = {-1e5, 1e5};  // coordinates, in metres or pixels

// Reads one object of a JSON text key by key. Every accessor throws Error with the source and the
// dotted path of the key if the value has the wrong type or is out of range, or if the key is
// missing, unless the name of the accessor ends in Or. The JSON must outlive the reader.
class ObjectReader {
 public:
  // `where` names the source; `path` is the dotted path of the object within it, empty for the
  // root.
  ObjectReader(const Json& object, std::string where, std::string path);

  bool Has(const std::string& key);
  double Number(const std::string& key, Range range);
  double NumberOr(const std::string& key, Range range, double fallback);
  int Integer(const std::string& key, Range range);
  int IntegerOr(const std::string& key, Range range, int fallback);
  std::uint64_t SeedOr(const std::string& key, std::uint64_t fallback);
  bool BoolOr(const std::string& key, bool fallback);
  std::string Text(const std::string& key);
  std::string TextOr(const std::string& key, const std::string& fallback);
  // Reads a list of numbers whose length is one of `sizes`.
  std::vector<double> Numbers(const std::string& key, Range range, const std::set<int>& sizes);
  Eigen::Vector3d Vector3(const std::string& key, Range range);
  Eigen::Vector3d Vector3Or(const std::string& key, Range range, const Eigen::Vector3d& fallback);
  // Reads at least `least` rows of `size` numbers each.
  std::vector<std::vector<double>> Rows(const std::string& key, Range range, int size, int least);
  ObjectReader Object(const std::string& key);
  // Reads a list of objects; returns an empty list if the key is missing.
  std::vector<ObjectReader> ObjectsOr(const std::string& key);
  const Json& Value(const std::string& key);

  // Throws Error if the object has a key that was never asked for.
  void Finish() const;
  // Returns the location of a key for error messages, "<where>, objects.2.size_m". An empty key
  // stands for the object itself.
  std::string Where(const std::string& key) const;
  // Returns the only one of `keys` that is present. Throws Error unless there is exactly one.
  std::string OneOf(const std::vector<std::string>& keys);

 private:
  std::string Path(const std::string& key) const;
  [[noreturn]] void FailUnknown(const std::string& key) const;
  double CheckedNumber(const Json& value, Range range, const std::string& where) const;

  const Json* object_;
  std::string where_;
  std::string path_;
  std::vector<std::string> known_;
};

}  // namespace cvo::synth
