// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/calibration/yaml_map.h"

#include <algorithm>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/calibration/kitti_calibration.h"

namespace cvo {

namespace {

constexpr std::size_t kMostBytes = 1 << 20;
constexpr std::size_t kMostValues = 1000;  // in one list, which aliases could make endless

YAML::Node Parse(const std::filesystem::path& path) {
  std::string text = ReadFileBytes(path);
  if (text.size() > kMostBytes) {
    ThrowError(path.string(), StrCat(text.size(), " bytes"), "a calibration below 1 MB");
  }
  if (text.starts_with("%YAML:")) text.erase(0, text.find('\n'));
  try {
    std::vector<YAML::Node> documents = YAML::LoadAll(text);
    // Programs of ROS end a message with "---".
    if (documents.size() > 1 && documents.back().IsNull()) documents.pop_back();
    if (documents.size() == 1) return documents[0];
    ThrowError(path.string(), StrCat(documents.size(), " YAML documents"), "one");
  } catch (const YAML::Exception& error) {
    ThrowError(StrCat(path.string(), ":", error.mark.line + 1), error.msg, "YAML or JSON");
  }
}

// Appends the scalars of a node. Returns false if there are too many values.
bool Collect(const YAML::Node& node, std::size_t& values, std::vector<std::string>& scalars) {
  if (++values > kMostValues) return false;
  if (node.IsScalar()) scalars.push_back(node.Scalar());
  if (!node.IsSequence()) return true;
  return std::all_of(node.begin(), node.end(),
                     [&](const YAML::Node& part) { return Collect(part, values, scalars); });
}

}  // namespace

YamlMap YamlMap::Read(const std::filesystem::path& path) {
  YAML::Node root = Parse(path);
  if (!root.IsMap())
    ThrowError(path.string(), "no keys",
               "a calibration of OpenCV, Kalibr, OpenVINS, ROS, ORB-SLAM, KITTI or ours: keys and "
               "values in YAML or JSON");
  return {path.string(), std::move(root)};
}

YamlMap::YamlMap(std::string where, YAML::Node node) : where_(std::move(where)), node_(node) {
  std::set<std::string> keys;
  for (const auto& entry : node_) {
    if (entry.first.IsScalar() && !keys.insert(entry.first.Scalar()).second) {
      Fail(entry.first.Scalar(), "the key twice", "once");
    }
  }
}

void YamlMap::Add(const YamlMap& other) {
  for (const auto& entry : other.node_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (Has(key)) Fail(key, "the key in both files", "in one");
    node_[key] = entry.second;
  }
  where_ += " and " + other.where_;
}

std::string YamlMap::Keys() const {
  constexpr std::size_t kLongest = 60;
  std::string keys;
  for (const auto& entry : node_) {
    if (entry.first.IsScalar()) keys += (keys.empty() ? "" : " ") + entry.first.Scalar();
  }
  return Quoted(keys.substr(0, kLongest));
}

void YamlMap::Fail(const std::string& key, const std::string& found,
                   const std::string& expected) const {
  ThrowError(where_ + ", " + key, found, expected);
}

YAML::Node YamlMap::Get(const std::string& key) const {
  const YAML::Node node = node_[key];
  if (!node) Fail(key, "nothing", "a value");
  return node;
}

YamlMap YamlMap::Map(const std::string& key) const {
  YAML::Node node = Get(key);
  if (!node.IsMap()) Fail(key, "no keys", "keys and values");
  return {where_ + ", " + key, std::move(node)};
}

double YamlMap::Number(const std::string& key) const { return Numbers(key, 1).front(); }

std::string YamlMap::Text(const std::string& key) const {
  const YAML::Node node = Get(key);
  if (!node.IsScalar()) Fail(key, "a list or map", "a text");
  return node.Scalar();
}

std::vector<double> YamlMap::Numbers(const std::string& key) const {
  YAML::Node node = Get(key);
  if (node.IsMap()) {
    const YAML::Node data = node["data"];
    if (!data) Fail(key, "keys without data", "a list of numbers, or a matrix with data");
    node.reset(data);
  }
  std::vector<std::string> scalars;
  std::size_t values = 0;
  if (!Collect(node, values, scalars)) {
    Fail(key, StrCat("more than ", kMostValues, " values"), "a list of numbers");
  }
  std::vector<double> numbers;
  for (const std::string& scalar : scalars) {
    const std::optional<double> number = ParseDouble(scalar);
    if (!number) Fail(key, Quoted(scalar), "a number");
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<double> YamlMap::Numbers(const std::string& key, std::size_t count) const {
  std::vector<double> numbers = Numbers(key);
  if (numbers.size() != count) {
    Fail(key, StrCat(numbers.size(), " numbers"), std::to_string(count));
  }
  return numbers;
}

void YamlMap::AllowOnly(const std::vector<std::string>& keys) const {
  for (const auto& entry : node_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      ThrowError(where_, "key " + Quoted(key) + DidYouMean(key, keys), "a key of a calibration");
    }
  }
}

RigidTransform YamlMap::Transform(const std::string& key) const {
  const std::vector<double> numbers = Numbers(key);
  if (numbers.size() != 12 && numbers.size() != 16) {
    Fail(key, StrCat(numbers.size(), " numbers"), "12 of [R t], or 16");
  }
  return TransformFromRow(numbers, where_ + ", " + key);
}

}  // namespace cvo
