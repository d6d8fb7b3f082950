// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <thread>

#include "core/base/error.h"
#include "core/base/task_pool.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/identity.h"
#include "experiments/suite/build_plan.h"
#include "experiments/suite/suite.h"
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
  if (found.folder.empty()) found.missing = StrCat("no ", folder, " below ", root_.string());
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

Preparation SceneFolders::Find(const SuiteSequence& sequence, const GridPoint& parameters,
                               std::uint64_t seed) {
  const std::vector<std::string> assignments = SceneAssignments(sequence, parameters);
  const auto& [source, all_frames] = SourceFor(sequence, assignments);
  const synth::RenderRequest request = RenderOf(sequence, seed);
  const std::string key =
      StrCat(source.scene, "-", synth::DatasetKey(source, request).substr(0, kKeyDigits));
  Preparation render;
  render.name = StrCat("render-", sequence.name, "-", key);
  render.sequence = sequence.name;
  render.output = synth::ScenesFolder(cache_) / key / source.scene;
  render.drawing = synth::DrawingKey(source, request);
  std::error_code ignored;
  const bool drawn = fs::exists(cache_ / render.drawing / synth::kManifestName, ignored);
  render.stage = drawn ? Stage::kNoise : Stage::kDrawing;
  render.frames = request.frames.end.value_or(all_frames) - request.frames.first;
  render.arguments = {"synth",
                      "render",
                      sequence.scene,
                      "-o",
                      render.output.string(),
                      "--seed",
                      std::to_string(seed)};
  const auto add = [&](const char* flag, const std::string& value) {
    render.arguments.insert(render.arguments.end(), {flag, value});
  };
  if (!sequence.frames.empty()) add("--frames", sequence.frames);
  for (const std::string& assignment : assignments) add("--set", assignment);
  return render;
}

std::optional<std::string> FindSceneDamage(const fs::path& folder, const FrameRange& frames) try {
  synth::Manifest manifest = synth::ReadManifest(folder);
  std::erase_if(manifest.files, [&](const auto& record) { return !IsOf(frames, record.name); });
  TaskPool pool(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  return synth::FindDamage(folder, manifest, pool);
} catch (const Error& error) {
  return error.what();
}

void RequireAsRendered(const Sequence& sequence) {
  std::error_code ignored;
  if (!fs::exists(sequence.folder / synth::kManifestName, ignored)) return;
  const int frames = static_cast<int>(sequence.images.size());
  const auto damage =
      FindSceneDamage(sequence.folder, {sequence.first_frame, sequence.first_frame + frames});
  if (!damage) return;
  throw Error(StrCat(*damage, "; expected the files that ", synth::kManifestName,
                     " lists: render the scene again, or remove that file to use other files"));
}

std::vector<ImageHashes> RenderedHashes(const Sequence& sequence) {
  std::error_code ignored;
  if (!fs::exists(sequence.folder / synth::kManifestName, ignored)) return HashImages(sequence);
  std::map<fs::path, std::string> known;
  for (const synth::FileRecord& file : synth::ReadManifest(sequence.folder).files) {
    known[sequence.folder / file.name] = file.sha256;
  }
  std::vector<ImageHashes> images;
  for (const StereoPaths& pair : sequence.images) {
    images.push_back({known[pair.left], known[pair.right]});
  }
  return images;
}

std::string FindMissingFile(const SuiteSequence& sequence, const fs::path& data) {
  std::vector<std::string> files = {sequence.labels_file.string()};
  if (sequence.scene.empty() && !AreFromLabels(sequence.detections)) {
    files.push_back(sequence.detections);
  }
  for (const std::string& file : files) {
    std::error_code ignored;
    if (!file.empty() && !fs::is_regular_file(data / file, ignored)) return file;
  }
  return "";
}

}  // namespace cvo
