// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <regex>
#include <span>
#include <sstream>

#include "core/base/error.h"
#include "tests/house/house_rules.h"

namespace cvo::test {
namespace {

// The files below `folder`, and the prefixes of the paths that they may include. Nested folders
// that come after it in MakeParts are layers above it, which it must not include.
struct Part {
  std::string folder;
  std::vector<std::string> may_include;
  std::vector<std::string> banned_system;  // regular expressions for names between < and >
};

const std::vector<std::string>& NoFiles() {
  static const std::vector<std::string> headers = {
      "fstream", "filesystem",          "iostream",          "cstdio", "nlohmann/.*", "CLI/.*",
      "random",  "opencv2/imgcodecs.*", "opencv2/highgui.*", "ctime"};
  return headers;
}

// The layers of the estimator; each may include those before it.
std::vector<Part> CoreParts() {
  std::vector<Part> parts;
  std::vector<std::string> below;
  for (const char* layer :
       {"base", "geometry", "features", "association", "clustering", "solvers", "estimation",
        "interface", "clusters", "bodies", "labelling", "odometry", "ceres"}) {
    below.push_back(StrCat("core/", layer, "/"));
    std::vector<std::string> banned = NoFiles();
    if (layer != std::string("base")) banned.emplace_back("chrono");  // results need no clock
    parts.push_back({below.back(), below, banned});
  }
  return parts;
}

// The layers of synth, from models to folders of images; each may include those before it.
std::vector<Part> SynthParts() {
  std::vector<Part> parts;
  std::vector<std::string> below = {"core/base/", "core/geometry/", "core/files/"};
  for (const char* layer :
       {"models", "motion", "scene", "family", "render", "truth", "sensor", "detector", "write"}) {
    below.push_back(StrCat("synth/", layer, "/"));
    parts.push_back({below.back(), below, {"random"}});
  }
  return parts;
}

std::vector<Part> MakeParts() {
  std::vector<Part> parts = CoreParts();
  std::vector<std::string> estimator = parts.back().may_include;
  estimator.emplace_back("variants/");
  parts.push_back({"variants/", estimator, NoFiles()});
  parts.push_back({"experiments/python/", estimator, {}});
  parts.back().may_include.emplace_back("experiments/python/");
  parts.push_back(
      {"core/files/text/", {"core/base/", "core/files/text/"}, {"opencv2/.*", "Eigen/.*"}});
  for (const char* folder : {"core/files/", "core/files/json/"}) {
    parts.push_back({folder, {"core/base/", "core/files/"}, {"opencv2/.*", "Eigen/.*"}});
  }
  parts.push_back({"core/files/images/", {"core/base/", "core/files/"}, {"Eigen/.*"}});
  parts.push_back({"core/record/",
                   {"core/base/", "core/geometry/", "core/files/", "core/record/"},
                   {"opencv2/.*"}});
  for (const Part& part : SynthParts()) parts.push_back(part);
  parts.push_back(
      {"experiments/datasets/calibration/", {"core/", "experiments/datasets/calibration/"}, {}});
  const std::vector<std::string> readers = {"core/", "experiments/datasets/",
                                            "experiments/metrics/"};
  // Reads single files, independently of the sequence that they belong to.
  parts.push_back(
      {"experiments/datasets/formats/", {"core/", "experiments/datasets/formats/"}, {}});
  for (const char* folder : {"datasets/", "metrics/", "metrics/objects/", "metrics/boxes/",
                             "datasets/import/", "datasets/scene_check/"}) {
    parts.push_back({StrCat("experiments/", folder), readers, {}});
  }
  // Results are written with the schema with which reports read them.
  std::vector<std::string> below = {"core/", "variants/", "experiments/datasets/",
                                    "experiments/metrics/"};
  for (const char* folder : {"runner", "suite"}) {
    const std::string part = StrCat("experiments/", folder, "/");
    below.push_back(part);
    if (folder == std::string("suite")) below.emplace_back("synth/");
    parts.push_back({part, below, {}});
  }
  parts.push_back(
      {"experiments/cli/", {"core/", "variants/", "experiments/", "reports/", "synth/"}, {}});
  // Overlays draw on images; all other reports use only files of numbers and text.
  parts.push_back({"reports/overlays/",
                   {"core/base/", "core/geometry/", "core/files/", "core/record/", "reports/"},
                   {"ceres/.*"}});
  parts.push_back({"reports/",
                   {"core/base/", "core/geometry/", "core/files/", "core/record/", "reports/"},
                   {"opencv2/.*", "ceres/.*"}});
  parts.push_back({"tests/", {""}, {}});
  return parts;
}

bool StartsWithAny(const std::string& text, const std::vector<std::string>& prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](const std::string& prefix) { return text.starts_with(prefix); });
}

const Part* FindPart(const std::string& path) {
  static const std::vector<Part> parts = MakeParts();
  const Part* innermost = nullptr;
  for (const Part& part : parts) {
    const bool is_deeper = innermost == nullptr || part.folder.size() > innermost->folder.size();
    if (is_deeper && path.starts_with(part.folder)) innermost = &part;
  }
  return innermost;
}

bool IsInsideAndAbove(const Part* other, const Part& part) {
  return other != nullptr && other > &part && other->folder.starts_with(part.folder);
}

// Headers generated by the build are included without a folder.
bool IsAllowed(const Part& part, const std::string& included, bool system) {
  if (!system) {
    return included.find('/') == std::string::npos || (StartsWithAny(included, part.may_include) &&
                                                       !IsInsideAndAbove(FindPart(included), part));
  }
  return std::none_of(
      part.banned_system.begin(), part.banned_system.end(),
      [&](const std::string& banned) { return std::regex_match(included, std::regex(banned)); });
}

}  // namespace

std::vector<std::string> CheckIncludes(const SourceFile& file) {
  if (!file.path.ends_with(".h") && !file.path.ends_with(".cc")) return {};
  const Part* part = FindPart(file.path);
  if (part == nullptr) return {StrCat(file.path, ":1: in no part of the project")};
  static const std::regex include(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)re");
  std::vector<std::string> violations;
  std::istringstream lines(file.content);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_match(line, match, include)) continue;
    if (!IsAllowed(*part, match[2], match[1] == "<")) {
      violations.push_back(
          StrCat(file.path, ":", number, ": ", part->folder, " must not include ", match[2].str()));
    }
  }
  return violations;
}

}  // namespace cvo::test
