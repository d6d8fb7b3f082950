// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/scenes.h"

#include <algorithm>

#include "core/base/error.h"
#include "experiments/datasets/frame_range.h"
#include "experiments/suite/cell_input.h"
#include "synth/write/manifest.h"
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

}  // namespace

const SceneFolders::Source& SceneFolders::SourceFor(const SuiteSequence& sequence,
                                                    const std::vector<std::string>& assignments) {
  std::string key = sequence.scene;
  for (const std::string& assignment : assignments) key += "\n" + assignment;
  const auto found = sources_.find(key);
  if (found != sources_.end()) return found->second;
  const auto scene = synth::SceneDescription::Load(sequence.scene, assignments);
  Source source = {synth::SourceOf(scene, {}), scene.parts().frames};
  return sources_.emplace(key, std::move(source)).first->second;
}

SceneFolder SceneFolders::Find(const SuiteSequence& sequence, const GridPoint& parameters,
                               std::uint64_t seed) {
  const std::vector<std::string> assignments = SceneAssignments(sequence, parameters);
  const auto& [source, all_frames] = SourceFor(sequence, assignments);
  const synth::RenderRequest request = RenderOf(sequence, seed);
  SceneFolder found;
  const std::string key = synth::DatasetKey(source, request).substr(0, kKeyDigits);
  found.folder = cache_ / "scenes" / StrCat(source.scene, "-", key) / source.scene;
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

bool IsRendered(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder / synth::kManifestName, error)) return false;
  try {
    const std::vector<synth::FileRecord> files = synth::ReadManifest(folder).files;
    return std::all_of(files.begin(), files.end(), [&](const synth::FileRecord& file) {
      const auto size = fs::file_size(folder / file.name, error);
      return !error && static_cast<std::int64_t>(size) == file.size_bytes;
    });
  } catch (const Error&) {
    return false;  // damaged: rendered again
  }
}

}  // namespace cvo
