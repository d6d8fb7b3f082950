// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/runner/given.h"
#include "experiments/suite/suite.h"
#include "experiments/suite/system_command.h"
#include "synth/family/family.h"
#include "synth/scene/description.h"
#include "synth/scene/object_reader.h"

namespace cvo {

namespace {

namespace fs = std::filesystem;
using synth::ObjectReader;

constexpr int kMaxSeeds = 10000;

// Returns a text that must be one of `known`; `fallback` if the key is missing.
std::string ReadChoice(ObjectReader& object, const char* key, const std::vector<std::string>& known,
                       const std::string& fallback) {
  const std::string value = object.TextOr(key, fallback);
  if (value == fallback || std::find(known.begin(), known.end(), value) != known.end()) {
    return value;
  }
  ThrowError(object.Where(key), Quoted(value) + DidYouMean(value, known), Joined(known, " or "));
}

// Empty if the key is missing.
std::vector<std::string> ReadTextsOf(ObjectReader& object, const char* key) {
  if (!object.Has(key)) return {};
  return ReadTexts(object.Value(key), object.Where(key));
}

Json ReadObject(ObjectReader& object, const char* key) {
  if (!object.Has(key)) return Json::object();
  object.Object(key);  // throws if it is not an object
  return object.Value(key);
}

// The fields of a sequence but for its scene or folder.
void ReadFields(ObjectReader& object, SuiteSequence& sequence) {
  sequence.name = object.TextOr("name", sequence.name);
  sequence.frames = object.TextOr("frames", "");
  sequence.detections = object.TextOr("detections", "");
  sequence.classes = ReadTextsOf(object, "classes");
  sequence.perturb = ReadObject(object, "perturb");
  if (sequence.folder.empty()) return;
  sequence.pair = ReadChoice(object, "pair", {"grey", "colour"}, "");
  sequence.detections_camera = object.IntegerOr("detections_camera", {0, 3}, -1);
  sequence.min_score = object.NumberOr("min_score", {-1e6, 1e6}, sequence.min_score);
  sequence.labels_file = object.TextOr("labels", "");
  sequence.layout = ReadObject(object, "layout");
}

// Makes the files of scenes, families and commands in a suite absolute, so that it can be read from
// anywhere.
void ResolveFiles(const fs::path& folder, Json& suite) {
  ResolveCommands(folder, suite);
  if (!suite.is_object() || !suite.contains("sequences") || !suite["sequences"].is_array()) return;
  const auto scenes = synth::ShippedScenes();
  const auto families = synth::ShippedFamilies();
  for (Json& sequence : suite["sequences"]) {
    for (const char* key : {"scene", "family"}) {
      if (!sequence.is_object() || !sequence.contains(key) || !sequence[key].is_string()) continue;
      const auto name = sequence[key].get<std::string>();
      if (FindBy(scenes, &synth::ShippedScene::name, name) != nullptr ||
          FindBy(families, &synth::ShippedFamily::name, name) != nullptr) {
        continue;
      }
      std::error_code ignored;
      const fs::path file = folder / name;
      if (fs::exists(file, ignored)) sequence[key] = fs::absolute(file).lexically_normal().string();
    }
  }
}

std::string DefaultName(const SuiteSequence& sequence) {
  if (!sequence.scene.empty()) return fs::path(sequence.scene).stem().string();
  std::string name = NormalFolder(sequence.folder).filename().string();
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

// Appends one sequence for each seed.
void ReadFamily(ObjectReader object, std::vector<SuiteSequence>& out) {
  SuiteSequence sequence;
  const auto [first, end] = ReadSeedRange(object);
  synth::FamilyScene scene;
  scene.family = object.Text("family");
  if (object.Has("set")) {
    ObjectReader set = object.Object("set");
    for (const auto& [knob, value] : object.Value("set").items()) {
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      scene.set.push_back(knob + "=" + text);
    }
  }
  sequence.name = fs::path(scene.family).stem().string();
  ReadFields(object, sequence);
  object.Finish();
  const std::string name = sequence.name;
  for (std::uint64_t seed = first; seed < end; ++seed) {
    if (out.size() > kMaxRuns) return;  // too many, which CheckSuite refuses
    scene.seed = static_cast<std::uint32_t>(seed);
    sequence.scene = scene.Name();
    sequence.name = StrCat(name, "_", seed);
    out.push_back(sequence);
  }
}

SuiteSequence ReadSequence(ObjectReader object) {
  SuiteSequence sequence;
  if (object.OneOf({"scene", "folder", "family"}) == "scene") {
    sequence.scene = object.Text("scene");
  } else {
    sequence.folder = object.Text("folder");
  }
  sequence.name = DefaultName(sequence);
  ReadFields(object, sequence);
  object.Finish();
  return sequence;
}

std::vector<std::uint64_t> ReadSeeds(ObjectReader& object) {
  if (!object.Has("seeds")) return {1};
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

SuiteSystem ReadSystem(ObjectReader object, const std::vector<std::uint64_t>& seeds) {
  constexpr synth::Range kLimit = {0.0, 1e9};
  SuiteSystem system;
  system.name = object.Text("name");
  system.command = ReadTextsOf(object, "command");
  system.version = ReadTextsOf(object, "version");
  system.calibration = ReadChoice(object, "calibration", CalibrationForms(), "kitti");
  system.seeds = object.Has("seeds") ? ReadSeeds(object) : seeds;
  if (object.Has("limits")) {
    ObjectReader limits = object.Object("limits");
    if (limits.Has("time_s")) system.limit_s = limits.Number("time_s", kLimit);
    if (limits.Has("memory_mb")) system.limit_memory_mb = limits.Number("memory_mb", kLimit);
    limits.Finish();
  }
  if (object.Has("writes") || !system.command.empty()) {
    ObjectReader writes = object.Object("writes");
    system.camera = writes.Text("camera");
    system.objects = writes.TextOr("objects", "");
    writes.Finish();
  }
  object.Finish();
  return system;
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
    oracles.push_back(ReadTexts(switches, StrCat(object.Where("oracles"), ".", oracles.size())));
  }
  return oracles;
}

// The table of a suite that does not state one.
SuiteTable StandardTable(const Suite& suite) {
  SuiteTable table;
  for (const GridAxis& axis : suite.grid) {
    if (axis.values.size() > 1) table.rows.push_back(axis.path);
  }
  table.metrics = {"camera_ate",      "object_ate",         "object_success_10cm",
                   "object_coverage", "object_id_switches", "moving_precision"};
  if (suite.variants.size() > 1) table.reference = suite.variants.front();
  return table;
}

SuiteTable ReadTable(ObjectReader table, const SuiteTable& standard) {
  SuiteTable read = standard;
  if (table.Has("rows")) read.rows = ReadTextsOf(table, "rows");
  if (table.Has("metrics")) read.metrics = ReadTextsOf(table, "metrics");
  read.reference = table.TextOr("reference", "");
  table.Finish();
  return read;
}

}  // namespace

std::vector<std::string> ReadTexts(const Json& value, const std::string& where) {
  const auto is_text = [](const Json& element) { return element.is_string(); };
  if (!value.is_array() || !std::all_of(value.begin(), value.end(), is_text)) {
    ThrowError(where, value.dump(), "a list of texts");
  }
  return value.get<std::vector<std::string>>();
}

Suite ReadCheckedSuite(const Json& json, const std::string& where, const fs::path& folder) {
  Suite suite;
  suite.definition = json;
  ResolveFiles(folder, suite.definition);
  ObjectReader object(suite.definition, where, "");
  suite.name = object.Text("name");
  suite.about = object.TextOr("about", "");
  for (ObjectReader& sequence : object.ObjectsOr("sequences")) {
    if (suite.sequences.size() > kMaxRuns) break;  // too many, which CheckSuite refuses
    if (sequence.Has("family")) {
      ReadFamily(std::move(sequence), suite.sequences);
    } else {
      suite.sequences.push_back(ReadSequence(std::move(sequence)));
    }
  }
  suite.variants = ReadTextsOf(object, "variants");
  suite.seeds = ReadSeeds(object);
  suite.options = ReadObject(object, "options");
  suite.grid = ReadGrid(object);
  suite.grid_one_at_a_time = object.BoolOr("grid_one_at_a_time", false);
  if (object.Has("oracles")) suite.oracles = ReadOracles(object);
  for (ObjectReader& system : object.ObjectsOr("systems")) {
    suite.systems.push_back(ReadSystem(std::move(system), suite.seeds));
  }
  suite.timed_threads = object.IntegerOr("timed_threads", {1, kMaxTimedThreads}, 0);
  suite.landmarks = object.BoolOr("landmarks", false);
  suite.table = StandardTable(suite);
  if (object.Has("table")) suite.table = ReadTable(object.Object("table"), suite.table);
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
  std::error_code ignored;
  if (fs::is_regular_file(suite, ignored)) {
    return ParseSuite(ReadJson(suite), suite, fs::absolute(suite).parent_path());
  }
  const std::string meant = DidYouMean(suite, names);
  ThrowError("suite " + Quoted(suite), "neither a shipped suite nor a file" + meant,
             "a JSON file or " + (meant.empty() ? OneOfKnown(suite, names)
                                                : "one that `clustervo list suites` lists"));
}

namespace {

// Parses JSON; any other text is taken as a string, so that a word needs no quotes.
Json ParseValue(const std::string& text) {
  try {
    return ParseJson(text, "value");
  } catch (const Error&) {
    return text;
  }
}

// A path that is no option, or that is an axis, becomes an axis with this value alone.
void Set(const std::string& assignment, Json& suite) {
  const std::size_t equals = assignment.find('=');
  if (equals == 0 || equals == std::string::npos) {
    ThrowError("--set " + assignment, "no PATH=VALUE", "PATH=VALUE, such as window.spatial=5");
  }
  const std::string path = assignment.substr(0, equals);
  const Json value = ParseValue(assignment.substr(equals + 1));
  if (IsOptionPath(path) && !(suite.contains("grid") && suite["grid"].contains(path))) {
    suite["options"][PointerTo(path)] = value;
    return;
  }
  if (suite.value("grid_one_at_a_time", false)) {
    ThrowError("--set " + assignment, "a suite that varies one axis of its grid at a time",
               "an option that is not an axis");
  }
  suite["grid"][path] = Json::array({value});
}

}  // namespace

Json SweepDefinition(const std::string& name, const SuiteSweep& sweep) {
  Json json = {{"name", name}, {"variants", Json::array()}};
  if (!sweep.systems.empty()) {
    Json file = ReadJson(sweep.systems);
    ResolveCommands(fs::absolute(sweep.systems).parent_path(), file);
    if (!file.is_object() || !file.contains("systems")) {
      ThrowError(sweep.systems, "no \"systems\"", "a suite, or {\"systems\": [...]}");
    }
    json["systems"] = file["systems"];
  }
  const std::string variants = sweep.systems.empty() ? "full" : "";
  if (!(sweep.variants + variants).empty()) {
    json["variants"] = AtCommas(sweep.variants.empty() ? variants : sweep.variants);
  }
  for (const std::string& scene : AtCommas(sweep.scenes.empty() ? "tiny" : sweep.scenes)) {
    const std::size_t at = scene.find('@');
    Json sequence = {{"detections", "good"},
                     {at == scene.npos ? "scene" : "family", scene.substr(0, at)}};
    if (at != scene.npos) sequence["seeds"] = scene.substr(at + 1);
    json["sequences"].push_back(sequence);
  }
  for (const std::string& axis : sweep.grid) {
    const std::size_t equals = axis.find('=');
    if (equals == 0 || equals == axis.npos) {
      ThrowError("--grid " + axis, "no PATH=A,B,...", "such as pairwise.alpha=0,5,20");
    }
    Json& values = json["grid"][axis.substr(0, equals)] = Json::array();
    for (const std::string& value : AtCommas(axis.substr(equals + 1))) {
      values.push_back(ParseValue(value));
    }
  }
  return json;
}

Suite Override(const Suite& suite, const SuiteOverrides& overrides) {
  Json json = suite.definition;
  if (overrides.seeds > 0) json["seeds"] = overrides.seeds;
  if (!overrides.frames.empty()) {
    for (Json& sequence : json["sequences"]) sequence["frames"] = overrides.frames;
  }
  for (const std::string& assignment : overrides.set) Set(assignment, json);
  return json == suite.definition ? suite : ParseSuite(json, "suite " + suite.name);
}

}  // namespace cvo
