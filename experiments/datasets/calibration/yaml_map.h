// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo {

// A calibration file in YAML (or JSON). A value that is missing or has the wrong type is an Error
// that names the file and the key.
class YamlMap {
 public:
  // Throws Error unless the file is a single map whose keys occur once. Skips the first line of
  // OpenCV's files, which is not valid YAML.
  static YamlMap Read(const std::filesystem::path& path);

  bool Has(const std::string& key) const { return static_cast<bool>(node_[key]); }
  YamlMap Map(const std::string& key) const;
  double Number(const std::string& key) const;  // must be finite
  std::string Text(const std::string& key) const;
  // Returns all numbers of a list, of a list of lists row by row, or of a matrix as OpenCV writes
  // it.
  std::vector<double> Numbers(const std::string& key) const;
  std::vector<double> Numbers(const std::string& key, std::size_t count) const;
  // Returns a rigid transform from 12 or 16 numbers, row by row. Takes the nearest rotation,
  // because calibrations are written with few digits.
  RigidTransform Transform(const std::string& key) const;
  // Adds the keys of another file. Throws Error for a key that both have.
  void Add(const YamlMap& other);
  std::string Keys() const;  // quoted, for messages
  // Throws Error for a key of the map that is not among `keys`.
  void AllowOnly(const std::vector<std::string>& keys) const;
  [[noreturn]] void Fail(const std::string& key, const std::string& found,
                         const std::string& expected) const;

 private:
  YamlMap(std::string where, YAML::Node node);
  YAML::Node Get(const std::string& key) const;

  std::string where_;
  YAML::Node node_;
};

}  // namespace cvo
