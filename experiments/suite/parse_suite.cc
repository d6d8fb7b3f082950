// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/parse_suite.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/suite/collection.h"
#include "experiments/suite/shipped/shipped_suites.h"
#include "experiments/suite/shipped_trajectories.h"
#include "experiments/suite/suite_grid.h"
#include "synth/family/generate.h"
#include "synth/scene/object_reader.h"
#include "synth/scene/shipped_scenes.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using synth::ObjectReader;

constexpr int kMaxSeeds = 10000;

std::vector<std::string> TextsOr(ObjectReader& object, const std::string& key,
                                 std::vector<std::string> fallback) {
  if (!object.Has(key)) return fallback;
  const Json& value = object.Value(key);
  const auto is_text = [](const Json& element) { return element.is_string(); };
  if (!value.is_array() || !std::all_of(value.begin(), value.end(), is_text)) {
    ThrowError(object.Where(key), value.dump(), "a list of texts");
  }
  return value.get<std::vector<std::string>>();
}

// Empty if the key is absent.
std::string OneOfOr(ObjectReader& object, const std::string& key,
                    const std::vector<std::string>& known) {
  std::string text = object.TextOr(key, "");
  if (text.empty() || std::find(known.begin(), known.end(), text) != known.end()) return text;
  ThrowError(object.Where(key), Quoted(text) + DidYouMean(text, known), Joined(known, " or "));
}

Json ObjectOr(ObjectReader& object, const std::string& key) {
  if (!object.Has(key)) return Json::object();
  object.Object(key);  // throws if it is not an object
  return object.Value(key);
}

// Resolves a scene file relative to the suite's folder.
std::string ResolveScene(const std::string& scene, const fs::path& folder) {
  for (const synth::ShippedScene& shipped : synth::ShippedScenes()) {
    if (shipped.name == scene) return scene;
  }
  std::error_code ignored;
  const fs::path file = folder / scene;
  return fs::exists(file, ignored) ? fs::absolute(file).lexically_normal().string() : scene;
}

std::string ResolveFamily(const std::string& family, const fs::path& folder) {
  for (const synth::ShippedFamily& shipped : synth::ShippedFamilies()) {
    if (shipped.name == family) return family;
  }
  std::error_code ignored;
  const fs::path file = folder / family;
  return fs::exists(file, ignored) ? fs::absolute(file).lexically_normal().string() : family;
}

std::string DefaultName(const SuiteSequence& sequence) {
  if (!sequence.scene.empty()) return fs::path(sequence.scene).stem().string();
  fs::path folder = fs::path(sequence.folder).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  std::string name = folder.filename().string();
  constexpr std::string_view kRawSuffix = "_sync";  // part of no drive's name
  if (name.ends_with(kRawSuffix)) name.resize(name.size() - kRawSuffix.size());
  return name;
}

constexpr std::uint64_t kMaxFamilySeeds = 10000;
constexpr int kMaxTimedThreads = 256;

// Parses "1000:1040" (end exclusive), or a single number.
std::pair<std::uint32_t, std::uint64_t> ReadSeedRange(ObjectReader& object) {
  const std::string where = object.Where("seeds");
  try {
    if (object.Value("seeds").is_number()) {
      const std::uint32_t seed = synth::ParseFamilySeed(object.Value("seeds").dump());
      return {seed, seed + std::uint64_t{1}};
    }
    const std::string text = object.Text("seeds");
    const std::size_t colon = text.find(':');
    const std::uint32_t first = synth::ParseFamilySeed(text.substr(0, colon));
    if (colon == std::string::npos) return {first, first + std::uint64_t{1}};
    const std::uint32_t end = synth::ParseFamilySeed(text.substr(colon + 1));
    if (end > first && end - first <= kMaxFamilySeeds) return {first, end};
  } catch (const Error&) {
  }
  ThrowError(where, object.Value("seeds").dump(),
             "\"FIRST:END\" with seeds from 0 to 4294967295, END not included, or one seed");
}

// Reads a string, or an object that describes a network that detects the boxes, named after its
// model by default.
void ReadDetections(ObjectReader& object, SuiteSequence& sequence) {
  if (!object.Has("detections") || !object.Value("detections").is_object()) {
    sequence.detections = object.TextOr("detections", "");
    return;
  }
  ObjectReader read = object.Object("detections");
  SuiteDetector& detector = sequence.detector;
  detector.model = read.Text("model");
  detector.names = read.Text("names");
  detector.weights = read.TextOr("weights", "");
  detector.input = read.TextOr("input", "");
  if (read.Has("min_score")) detector.min_score = read.Number("min_score", {0.0, 1.0});
  if (read.Has("max_overlap")) detector.max_overlap = read.Number("max_overlap", {0.0, 1.0});
  sequence.detections = read.TextOr("name", fs::path(detector.model).stem().string());
  read.Finish();
  if (detector.model.empty() || sequence.detections.empty()) {
    ThrowError(object.Where("detections"), "a model without a name", "its file");
  }
}

// Appends one sequence for each seed.
void ReadFamily(ObjectReader object, const fs::path& folder, std::vector<SuiteSequence>& out) {
  SuiteSequence sequence;
  const std::string family = object.Text("family");
  const auto [first, end] = ReadSeedRange(object);
  synth::FamilyScene scene;
  scene.family = ResolveFamily(family, folder);
  if (object.Has("set")) {
    ObjectReader set = object.Object("set");
    for (const auto& [knob, value] : object.Value("set").items()) {
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      scene.set.push_back(knob + "=" + text);
    }
  }
  const std::string name = object.TextOr("name", fs::path(family).stem().string());
  sequence.frames = object.TextOr("frames", "");
  ReadDetections(object, sequence);
  sequence.classes = TextsOr(object, "classes", {});
  sequence.perturb = ObjectOr(object, "perturb");
  object.Finish();
  for (std::uint64_t seed = first; seed < end; ++seed) {
    if (out.size() > kMaxRuns) return;  // too many, which CheckSuite refuses
    scene.seed = static_cast<std::uint32_t>(seed);
    sequence.scene = scene.Name();
    sequence.name = StrCat(name, "_", seed);
    out.push_back(sequence);
  }
}

SuiteSequence ReadSequence(ObjectReader object, const fs::path& folder) {
  SuiteSequence sequence;
  if (object.OneOf({"scene", "folder", "family"}) == "scene") {
    sequence.scene = ResolveScene(object.Text("scene"), folder);
  } else {
    sequence.folder = object.Text("folder");
  }
  sequence.name = object.TextOr("name", DefaultName(sequence));
  sequence.frames = object.TextOr("frames", "");
  ReadDetections(object, sequence);
  sequence.classes = TextsOr(object, "classes", {});
  sequence.perturb = ObjectOr(object, "perturb");
  if (!sequence.folder.empty()) {
    sequence.dataset = OneOfOr(object, "dataset", {"kitti", "other"});
    sequence.pair = OneOfOr(object, "pair", {"grey", "colour"});
    sequence.groundtruth = object.TextOr("groundtruth", sequence.groundtruth);
    sequence.detections_camera = object.IntegerOr("detections_camera", {0, 3}, -1);
    if (object.Has("min_score")) sequence.min_score = object.Number("min_score", {-1e6, 1e6});
    sequence.labels = object.TextOr("labels", "");
    sequence.layout = ObjectOr(object, "layout");
  }
  object.Finish();
  return sequence;
}

SuiteSystem ReadSystem(ObjectReader object, const std::vector<SuiteSequence>& sequences) {
  SuiteSystem system;
  system.name = object.Text("name");
  system.shipped = !object.Has("files");
  for (ObjectReader files : object.ObjectsOr("files")) {
    system.files.push_back(
        {files.Text("sequence"), files.Text("camera"), files.TextOr("objects", "")});
    files.Finish();
  }
  object.Finish();
  if (system.shipped) {
    system.files = ShippedFilesOf(system.name, sequences, object.Where("files"));
  }
  if (system.files.empty()) ThrowError(object.Where("files"), "none", "a file for each sequence");
  return system;
}

std::vector<std::uint64_t> ReadSeeds(ObjectReader& object) {
  const Json& value = object.Value("seeds");
  std::vector<std::uint64_t> seeds;
  if (!value.is_array()) {
    seeds.resize(static_cast<std::size_t>(object.Integer("seeds", {1, kMaxSeeds})));
    std::iota(seeds.begin(), seeds.end(), 1);
    return seeds;
  }
  if (value.size() > kMaxSeeds) {
    ThrowError(object.Where("seeds"), StrCat(value.size()), StrCat("at most ", kMaxSeeds));
  }
  for (const Json& seed : value) {
    const bool integer =
        seed.is_number_unsigned() || (seed.is_number_integer() && seed.get<std::int64_t>() >= 0);
    if (!integer) {
      ThrowError(object.Where("seeds"), seed.dump(), "integers from 0 to 18446744073709551615");
    }
    seeds.push_back(seed.get<std::uint64_t>());
  }
  return seeds;
}

std::vector<GridAxis> ReadGrid(ObjectReader& object) {
  std::vector<GridAxis> grid;
  if (!object.Has("grid")) return grid;
  object.Object("grid");  // throws if it is not an object
  for (const auto& [path, values] : object.Value("grid").items()) {
    grid.push_back({path, ParseAxisValues(values, object.Where("grid." + path))});
  }
  return grid;
}

std::vector<std::vector<std::string>> ReadOracles(ObjectReader& object) {
  std::vector<std::vector<std::string>> oracles;
  const Json& value = object.Value("oracles");
  if (!value.is_array()) {
    ThrowError(object.Where("oracles"), value.dump(), "a list of lists of switches");
  }
  for (const Json& switches : value) {
    const std::string index = std::to_string(oracles.size());
    const Json holder = Json::object({{index, switches}});
    ObjectReader row(holder, object.Where("oracles"), "");
    oracles.push_back(TextsOr(row, index, {}));
  }
  return oracles;
}

SuiteTable ReadTable(ObjectReader table) {
  SuiteTable read;
  read.rows = TextsOr(table, "rows", read.rows);
  table.Value("metrics");  // throws if it is missing
  read.metrics = TextsOr(table, "metrics", {});
  read.reference = table.TextOr("reference", "");
  table.Finish();
  return read;
}

}  // namespace

Suite ReadCheckedSuite(const Json& json, const std::string& where, const fs::path& folder) {
  ObjectReader object(json, where, "");
  Suite suite;
  suite.name = object.Text("name");
  suite.about = object.TextOr("about", "");
  for (ObjectReader& sequence : object.ObjectsOr("sequences")) {
    if (suite.sequences.size() > kMaxRuns) break;  // too many, which CheckSuite refuses
    if (sequence.Has("family")) {
      ReadFamily(std::move(sequence), folder, suite.sequences);
    } else {
      suite.sequences.push_back(ReadSequence(std::move(sequence), folder));
    }
  }
  suite.variants = TextsOr(object, "variants", {});
  suite.seeds = ReadSeeds(object);
  suite.options = ObjectOr(object, "options");
  suite.grid = ReadGrid(object);
  suite.grid_one_at_a_time = object.BoolOr("grid_one_at_a_time", false);
  if (object.Has("oracles")) suite.oracles = ReadOracles(object);
  for (ObjectReader& system : object.ObjectsOr("systems")) {
    suite.systems.push_back(ReadSystem(std::move(system), suite.sequences));
  }
  suite.timed_threads = object.IntegerOr("timed_threads", {1, kMaxTimedThreads}, 0);
  suite.landmarks = object.BoolOr("landmarks", false);
  suite.table = ReadTable(object.Object("table"));
  object.Finish();
  return suite;
}

Suite ParseSuite(const Json& json, const std::string& where, const fs::path& folder) {
  Suite suite = ReadCheckedSuite(json, where, folder);
  CheckSuite(suite, where);
  return suite;
}

Suite LoadSuite(const std::string& suite) {
  std::vector<std::string> names;
  for (const ShippedSuite& shipped : ShippedSuites()) {
    if (shipped.name == suite) {
      return ParseSuite(ParseJson(shipped.text, "suite " + suite), "suite " + suite);
    }
    names.push_back(shipped.name);
  }
  if (const std::optional<Collection> collection = FindCollection(suite)) {
    std::string suites;
    for (const CollectionSection& section : collection->sections) {
      if (!section.suite.empty()) suites += (suites.empty() ? "" : ", ") + section.suite;
    }
    ThrowError("suite " + Quoted(suite), "a collection of suites", "one of these: " + suites);
  }
  std::error_code ignored;
  if (fs::is_regular_file(suite, ignored)) {
    return ParseSuite(ReadJson(suite), suite, fs::path(suite).parent_path());
  }
  const std::string meant = DidYouMean(suite, names);
  ThrowError("suite " + Quoted(suite), "neither a shipped suite nor a file" + meant,
             "a JSON file or " + (meant.empty() ? OneOfKnown(suite, names)
                                                : "one that `clustervo experiment list` lists"));
}

}  // namespace cvo
