// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/plan/scenes.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "experiments/cache/content_hash.h"
#include "experiments/suite/cell_input.h"
#include "synth/family/generate.h"
#include "synth/write/manifest.h"
#include "synth/write/render_cache.h"
#include "synth/write/write_scene.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

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

}  // namespace cvo
