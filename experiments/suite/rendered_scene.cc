// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Whether a rendered scene is as it was rendered.
#include <algorithm>
#include <map>
#include <thread>

#include "core/base/error.h"
#include "core/base/task_pool.h"
#include "core/files/text/number.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/identity.h"
#include "experiments/suite/build_plan.h"
#include "synth/write/dataset.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Whether a file in a rendered folder belongs to one of the frames, or to the sequence as a whole.
bool IsOf(const FrameRange& frames, const std::string& name) {
  const fs::path path = name;
  if (!path.has_parent_path()) return true;
  const std::optional<std::int64_t> number = ParseInteger(path.stem().string());
  return !number || (*number >= frames.begin && (frames.end < 0 || *number < frames.end));
}

}  // namespace

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

}  // namespace cvo
