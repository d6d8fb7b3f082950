// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/suite/collection.h"
#include "experiments/suite/job_input.h"
#include "experiments/suite/suite.h"
#include "synth/family/family.h"
#include "synth/scene/description.h"
#include "synth/scene/object_reader.h"

namespace cvo {

namespace {

namespace fs = std::filesystem;
using synth::ObjectReader;

constexpr int kMaxSeeds = 10000;

// Reads one object of a suite file, or writes it: one list of fields serves both. A field that is
// not in the file keeps its value, and an empty one is not written.
class Fields {
 public:
  explicit Fields(ObjectReader& in) : in_(&in) {}
  explicit Fields(Json& out) : out_(&out) {}

  // Without `known`, any text is valid.
  void Text(const char* key, std::string& value, const std::vector<std::string>& known = {}) {
    if (out_ != nullptr && !value.empty()) (*out_)[key] = value;
    if (in_ == nullptr || !in_->Has(key)) return;
    value = in_->Text(key);
    if (known.empty() || std::find(known.begin(), known.end(), value) != known.end()) return;
    ThrowError(in_->Where(key), Quoted(value) + DidYouMean(value, known), Joined(known, " or "));
  }
  void Texts(const char* key, std::vector<std::string>& value) {
    if (out_ != nullptr && !value.empty()) (*out_)[key] = value;
    if (in_ != nullptr && in_->Has(key)) value = ReadTexts(in_->Value(key), in_->Where(key));
  }
  void Number(const char* key, std::optional<double>& value, const synth::Range& range) {
    if (out_ != nullptr && value) (*out_)[key] = *value;
    if (in_ != nullptr && in_->Has(key)) value = in_->Number(key, range);
  }
  // A value below 0 is not written.
  void Integer(const char* key, int& value, const synth::Range& range) {
    if (out_ != nullptr && value >= 0) (*out_)[key] = value;
    if (in_ != nullptr) value = in_->IntegerOr(key, range, value);
  }
  void Object(const char* key, Json& value) {
    if (out_ != nullptr && !value.empty()) (*out_)[key] = value;
    if (in_ == nullptr || !in_->Has(key)) return;
    in_->Object(key);  // throws if it is not an object
    value = in_->Value(key);
  }
  // A string, or an object that describes a network that detects the boxes, named after its model
  // by default.
  void Detections(SuiteSequence& sequence) {
    constexpr const char* kKey = "detections";
    if (out_ != nullptr && !sequence.detector.model.empty()) {
      Fields(out_->emplace(kKey, Json::object()).first.value()).Detector(sequence);
    } else if (in_ != nullptr && in_->Has(kKey) && in_->Value(kKey).is_object()) {
      ObjectReader read = in_->Object(kKey);
      read.Value("names");  // throws if it is missing
      sequence.detections = fs::path(read.Text("model")).stem().string();
      Fields(read).Detector(sequence);
      read.Finish();
      if (!sequence.detector.model.empty() && !sequence.detections.empty()) return;
      ThrowError(in_->Where(kKey), "a model without a name", "its file");
    } else {
      Text(kKey, sequence.detections);
    }
  }

 private:
  void Detector(SuiteSequence& sequence) {
    Text("name", sequence.detections);
    Text("model", sequence.detector.model);
    Text("names", sequence.detector.names);
    Text("weights", sequence.detector.weights);
    Text("input", sequence.detector.input);
    Number("min_score", sequence.detector.min_score, {0.0, 1.0});
    Number("max_overlap", sequence.detector.max_overlap, {0.0, 1.0});
  }

  ObjectReader* in_ = nullptr;
  Json* out_ = nullptr;
};

// The fields of a sequence but for its scene or folder.
void VisitSequence(Fields fields, SuiteSequence& sequence) {
  fields.Text("name", sequence.name);
  fields.Text("frames", sequence.frames);
  fields.Detections(sequence);
  fields.Texts("classes", sequence.classes);
  fields.Object("perturb", sequence.perturb);
  if (sequence.folder.empty()) return;
  fields.Text("dataset", sequence.dataset, {"kitti", "other"});
  fields.Text("pair", sequence.pair, {"grey", "colour"});
  fields.Text("groundtruth", sequence.groundtruth, {"devkit", "interpolated"});
  fields.Integer("detections_camera", sequence.detections_camera, {0, 3});
  fields.Number("min_score", sequence.min_score, {-1e6, 1e6});
  fields.Text("labels", sequence.labels);
  fields.Object("layout", sequence.layout);
}

// Resolves a file of a scene or a family relative to the suite's folder.
template <typename Shipped>
std::string Resolved(const std::string& name, const std::vector<Shipped>& shipped,
                     const fs::path& folder) {
  if (FindBy(shipped, &Shipped::name, name) != nullptr) return name;
  std::error_code ignored;
  const fs::path file = folder / name;
  return fs::exists(file, ignored) ? fs::absolute(file).lexically_normal().string() : name;
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

// Appends one sequence for each seed.
void ReadFamily(ObjectReader object, const fs::path& folder, std::vector<SuiteSequence>& out) {
  SuiteSequence sequence;
  const std::string family = object.Text("family");
  const auto [first, end] = ReadSeedRange(object);
  synth::FamilyScene scene;
  scene.family = Resolved(family, synth::ShippedFamilies(), folder);
  if (object.Has("set")) {
    ObjectReader set = object.Object("set");
    for (const auto& [knob, value] : object.Value("set").items()) {
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      scene.set.push_back(knob + "=" + text);
    }
  }
  sequence.name = fs::path(family).stem().string();
  VisitSequence(Fields(object), sequence);
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

SuiteSequence ReadSequence(ObjectReader object, const fs::path& folder) {
  SuiteSequence sequence;
  if (object.OneOf({"scene", "folder", "family"}) == "scene") {
    sequence.scene = Resolved(object.Text("scene"), synth::ShippedScenes(), folder);
  } else {
    sequence.folder = object.Text("folder");
  }
  sequence.name = DefaultName(sequence);
  VisitSequence(Fields(object), sequence);
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
    oracles.push_back(ReadTexts(switches, StrCat(object.Where("oracles"), ".", oracles.size())));
  }
  return oracles;
}

SuiteTable ReadTable(ObjectReader table) {
  SuiteTable read;
  table.Value("metrics");  // throws if it is missing
  Fields fields(table);
  fields.Texts("rows", read.rows);
  fields.Texts("metrics", read.metrics);
  fields.Text("reference", read.reference);
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
  Fields fields(object);
  fields.Texts("variants", suite.variants);
  suite.seeds = ReadSeeds(object);
  fields.Object("options", suite.options);
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
                                                : "one that `clustervo list suites` lists"));
}

namespace {

Json SystemToJson(const SuiteSystem& system) {
  if (system.shipped) return {{"name", system.name}};
  Json files = Json::array();
  for (const SuiteSystem::Files& file : system.files) {
    files.push_back({{"sequence", file.sequence}, {"camera", file.camera}});
    if (!file.objects.empty()) files.back()["objects"] = file.objects;
  }
  return {{"name", system.name}, {"files", std::move(files)}};
}

}  // namespace

Json SuiteToJson(const Suite& suite) {
  Json json = {{"name", suite.name}, {"about", suite.about}, {"sequences", Json::array()}};
  for (SuiteSequence sequence : suite.sequences) {
    Json& written = json["sequences"].emplace_back(Json::object());
    if (!sequence.scene.empty()) written["scene"] = sequence.scene;
    if (!sequence.folder.empty()) written["folder"] = sequence.folder;
    VisitSequence(Fields(written), sequence);
  }
  json["variants"] = suite.variants;
  json["seeds"] = suite.seeds;
  json["options"] = suite.options;
  json["grid"] = Json::object();
  for (const GridAxis& axis : suite.grid) json["grid"][axis.path] = axis.values;
  json["grid_one_at_a_time"] = suite.grid_one_at_a_time;
  json["oracles"] = suite.oracles;
  json["systems"] = Json::array();
  for (const SuiteSystem& system : suite.systems) json["systems"].push_back(SystemToJson(system));
  if (suite.timed_threads > 0) json["timed_threads"] = suite.timed_threads;
  json["landmarks"] = suite.landmarks;
  json["table"] = ToJson(suite.table);
  return json;
}

}  // namespace cvo
