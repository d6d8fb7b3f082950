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

// Numbers from min to max, both allowed.
struct Range {
  double min = 0.0;
  double max = 0.0;
};
inline constexpr Range kPlace = {-1e5, 1e5};  // coordinates, in metres or pixels

// One object of a JSON text, read key by key. Every function throws Error naming the source and the
// dotted path for a key that is missing (unless it ends in Or), of another type or out of range.
// The JSON must outlive it.
class ObjectReader {
 public:
  // `where` names the source, `path` the object within it: empty at the top.
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
  // As many numbers as one of `sizes`.
  std::vector<double> Numbers(const std::string& key, Range range, const std::set<int>& sizes);
  Eigen::Vector3d Vector3(const std::string& key, Range range);
  Eigen::Vector3d Vector3Or(const std::string& key, Range range, const Eigen::Vector3d& fallback);
  // Rows of `size` numbers, at least `least` rows.
  std::vector<std::vector<double>> Rows(const std::string& key, Range range, int size, int least);
  ObjectReader Object(const std::string& key);
  // Empty where the key is missing.
  std::vector<ObjectReader> ObjectsOr(const std::string& key);
  const Json& Value(const std::string& key);

  // Throws for a key that nothing asked for.
  void Finish() const;
  // "<where>, objects.2.size_m"; an empty key: the object itself.
  std::string Where(const std::string& key) const;
  // Throws unless exactly one of the keys is there; returns it.
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
