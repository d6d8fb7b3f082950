// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/plan_inputs.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "detector_sources.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/identity.h"
#include "experiments/suite/job_input.h"
#include "synth/family/family.h"
#include "synth/write/dataset.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Whether the last components of `path` are those of `end`.
bool EndsWith(const fs::path& path, const fs::path& end) {
  auto a = path.end();
  auto b = end.end();
  while (b != end.begin()) {
    if (a == path.begin() || *--a != *--b) return false;
  }
  return true;
}

// Returns as many of the last components of `path` as `other` has.
std::string LastParts(const fs::path& path, const fs::path& other) {
  fs::path last;
  auto part = path.end();
  for (auto i = other.begin(); i != other.end() && part != path.begin(); ++i) last = *--part / last;
  return NormalFolder(fs::path("/") / last).relative_path().string();
}

constexpr std::size_t kKeyDigits = 16;

synth::RenderRequest RenderOf(const SuiteSequence& sequence, std::uint64_t seed) {
  synth::RenderRequest request;
  request.seed = seed;
  if (!sequence.frames.empty()) {
    const FrameRange range = ParseFrameRange(sequence.frames);
    request.frames.first = range.begin;
    if (range.end >= 0) request.frames.end = range.end;
  }
  return request;
}

// Whether a file in a rendered folder belongs to one of the frames, or to the sequence as a whole.
bool IsOf(const FrameRange& frames, const std::string& name) {
  const fs::path path = name;
  if (!path.has_parent_path()) return true;
  const std::optional<std::int64_t> number = ParseInteger(path.stem().string());
  return !number || (*number >= frames.begin && (frames.end < 0 || *number < frames.end));
}

// Returns the arguments with which the program writes the boxes.
std::vector<std::string> DetectArguments(const DetectorInput& input, const fs::path& model,
                                         const std::string& boxes) {
  const SuiteSequence& written = input.written;
  const SuiteDetector& detector = written.detector;
  std::vector<std::string> arguments = {"detect",  input.sequence.folder.string(),
                                        "--model", model.string(),
                                        "--names", (input.data / detector.names).string()};
  const auto add = [&arguments](const char* flag, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {flag, value});
  };
  if (!detector.weights.empty()) add("--weights", (input.data / detector.weights).string());
  add("--input", detector.input);
  if (detector.min_score) add("--min-score", Json(*detector.min_score).dump());
  if (detector.max_overlap) add("--max-overlap", Json(*detector.max_overlap).dump());
  add("--pair", written.pair);
  // The frames of a scene were selected at rendering.
  if (written.scene.empty()) add("--frames", written.frames);
  if (!written.layout.empty()) add("--layout", written.layout.dump());
  arguments.insert(arguments.end(), {"-o", boxes, "--checksum"});
  return arguments;
}

}  // namespace

const std::vector<FoundSequence>& DataFolder::All() {
  if (!all_) all_ = FindSequences(root_);
  return *all_;
}

DataFolder::Found DataFolder::Find(const std::string& folder) {
  if (root_.empty()) return {{}, "no data folder: use --data or set CLUSTERVO_DATA"};
  std::error_code ignored;
  if (!fs::is_directory(root_, ignored)) return {{}, "no data folder " + root_.string()};
  const fs::path direct = NormalFolder(root_ / folder);
  if (!DetectSequenceType(direct).empty()) {
    if (HasImages(direct)) return {fs::absolute(direct), ""};
    return {{}, StrCat("no images of both cameras of ", folder, " below ", root_.string())};
  }
  Found found;
  for (const FoundSequence& sequence : All()) {
    if (!EndsWith(sequence.folder, NormalFolder(fs::path("/") / folder).relative_path())) continue;
    if (!found.folder.empty()) {
      return {{},
              StrCat("both ", found.folder.string(), " and ", sequence.folder.string(), " end in ",
                     folder)};
    }
    found.folder = fs::absolute(sequence.folder);
  }
  if (found.folder.empty()) {
    std::vector<std::string> known;
    for (const FoundSequence& sequence : All()) {
      known.push_back(LastParts(sequence.folder, fs::path(folder)));
    }
    found.missing = StrCat("no ", folder, DidYouMean(folder, known), " below ", root_.string());
  }
  return found;
}

const SceneFolders::Source& SceneFolders::SourceFor(const SuiteSequence& sequence,
                                                    const std::vector<std::string>& assignments) {
  std::string key = sequence.scene;
  for (const std::string& assignment : assignments) key += "\n" + assignment;
  const auto found = sources_.find(key);
  if (found != sources_.end()) return found->second;
  const auto scene = synth::LoadScene(sequence.scene, assignments);
  Source source = {synth::SourceOf(scene, {}), scene.parts().frames};
  return sources_.emplace(key, std::move(source)).first->second;
}

RenderedScene SceneFolders::Find(const SuiteSequence& sequence, const GridPoint& parameters,
                                 std::uint64_t seed) {
  const std::vector<std::string> assignments = SceneAssignments(sequence, parameters);
  const auto& [source, all_frames] = SourceFor(sequence, assignments);
  const synth::RenderRequest request = RenderOf(sequence, seed);
  RenderedScene found;
  const std::string key = synth::DatasetKey(source, request).substr(0, kKeyDigits);
  found.folder = synth::ScenesFolder(cache_) / StrCat(source.scene, "-", key) / source.scene;
  found.drawing = synth::DrawingKey(source, request);
  std::error_code ignored;
  found.drawn = fs::exists(cache_ / found.drawing / synth::kManifestName, ignored);
  found.frames = request.frames.end.value_or(all_frames) - request.frames.first;
  found.arguments = {"synth",
                     "render",
                     sequence.scene,
                     "-o",
                     found.folder.string(),
                     "--seed",
                     std::to_string(seed)};
  if (!sequence.frames.empty()) {
    found.arguments.insert(found.arguments.end(), {"--frames", sequence.frames});
  }
  for (const std::string& assignment : assignments) {
    found.arguments.insert(found.arguments.end(), {"--set", assignment});
  }
  return found;
}

std::vector<std::string> HashesByReading(const std::vector<fs::path>& files) {
  std::vector<std::string> hashes;
  for (const fs::path& file : files) hashes.push_back(HashFile(file));
  return hashes;
}

std::optional<std::string> FindSceneDamage(const fs::path& folder, const HashFiles& hash,
                                           const FrameRange& frames) try {
  std::vector<synth::FileRecord> records = synth::ReadManifest(folder).files;
  std::erase_if(records, [&](const auto& record) { return !IsOf(frames, record.name); });
  std::vector<fs::path> files;
  for (const synth::FileRecord& record : records) files.push_back(folder / record.name);
  const std::vector<std::string> hashes = hash(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (hashes[i] == records[i].sha256) continue;
    return files[i].string() +
           (hashes[i].empty() ? " cannot be read" : " has changed since it was written");
  }
  return std::nullopt;
} catch (const Error& error) {
  return error.what();
}

void RequireAsRendered(const Sequence& sequence, const HashFiles& hash) {
  std::error_code ignored;
  if (!fs::exists(sequence.folder / synth::kManifestName, ignored)) return;
  const int frames = static_cast<int>(sequence.images.size());
  const auto damage =
      FindSceneDamage(sequence.folder, hash, {sequence.first_frame, sequence.first_frame + frames});
  if (!damage) return;
  throw Error(StrCat(*damage, "; expected the files that ", synth::kManifestName,
                     " lists: render the scene again, or remove that file to use other files"));
}

std::string FindMissingFile(const SuiteSequence& sequence, const fs::path& data) {
  const SuiteDetector& detector = sequence.detector;
  std::vector<std::string> files = {detector.model, detector.weights, detector.names,
                                    sequence.labels};
  const bool is_file =
      detector.model.empty() && sequence.scene.empty() && !AreFromLabels(sequence.detections);
  if (is_file) files.push_back(sequence.detections);
  for (const std::string& file : files) {
    std::error_code ignored;
    if (!file.empty() && !fs::is_regular_file(data / file, ignored)) return file;
  }
  return "";
}

DetectedBoxes FindDetectedBoxes(const DetectorInput& input, const HashFiles& hash) {
  const SuiteDetector& detector = input.written.detector;
  const fs::path model = input.data / detector.model;
  const fs::path weights = detector.weights.empty() ? fs::path(model).replace_extension(".weights")
                                                    : input.data / detector.weights;
  Json json = {{"program", kDetectorSources},
               {"opencv", ThisBuild().libraries.opencv},
               {"cpu_level", ThisBuild().cpu_level},
               {"network", hash({model, weights, input.data / detector.names})},
               {"input", detector.input},
               {"first_frame", input.sequence.first_frame},
               {"images", Json::array()}};
  if (detector.min_score) json["min_score"] = *detector.min_score;
  if (detector.max_overlap) json["max_overlap"] = *detector.max_overlap;
  if (input.sequence.rectification) json["rectified"] = input.sequence.rectification->identity();
  for (const ImageHashes& pair : input.images) json["images"].push_back(pair.left);
  DetectedBoxes boxes;
  boxes.file = input.cache / "detections" / (Sha256Hex(DumpJson(json)) + ".txt");
  boxes.arguments = DetectArguments(input, model, boxes.file.string());
  try {
    boxes.whole = ReadFileBytes(boxes.file.string() + kChecksumSuffix, kHashBytes) ==
                  hash({boxes.file}).front();
  } catch (const Error&) {  // one of the two does not exist
  }
  return boxes;
}

}  // namespace cvo
