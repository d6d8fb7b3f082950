// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Trajectories of other systems that come with the program.
#include <filesystem>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/suite/suite.h"
#include "synth/family/family.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Returns why the trajectory was made from other images than the job has; empty if it was not.
std::string Difference(const ShippedTrajectory& trajectory, const SuiteSequence& sequence,
                       const fs::path& rendered) {
  const std::string frames = sequence.frames.empty() ? "all" : sequence.frames;
  if (frames != trajectory.frames) {
    return StrCat("ran on frames ", trajectory.frames, ", not ", frames);
  }
  if (!sequence.perturb.empty()) return "ran on images without the perturbation";
  const std::string hash = Sha256Hex(ReadFileBytes(rendered / "scene.json"));
  if (hash == trajectory.scene_hash) return "";
  return StrCat("ran on a scene.json of SHA-256 ", trajectory.scene_hash.substr(0, 8), ", not ",
                hash.substr(0, 8));
}

}  // namespace

const ShippedTrajectory* FindShipped(const std::string& system, const SuiteSequence& sequence) {
  const std::string& name = sequence.scene;
  const std::string scene = synth::IsFamilyScene(name) ? name : fs::path(name).stem().string();
  for (const ShippedTrajectory& trajectory : ShippedTrajectories()) {
    if (trajectory.system == system && trajectory.scene == scene) return &trajectory;
  }
  return nullptr;
}

SystemFiles ShippedSystemFiles(const std::string& system, const SuiteSequence& sequence,
                               const fs::path& rendered, const fs::path& cache) {
  const ShippedTrajectory& trajectory = *FindShipped(system, sequence);
  const std::string difference = Difference(trajectory, sequence, rendered);
  if (!difference.empty()) {
    throw Error(StrCat(kStale, system, " on ", sequence.name, " ", difference));
  }
  std::string all;
  for (const NamedContent& file : trajectory.files) all += file.content;
  const fs::path folder =
      cache / "trajectories" / system / StrCat(trajectory.scene, "-", Sha256Hex(all).substr(0, 8));
  std::error_code ignored;
  if (!fs::exists(folder / trajectory.files.back().name, ignored)) {
    fs::create_directories(folder);
    WriteFilesAtomically(folder, trajectory.files);
  }
  const bool bodies = trajectory.files.size() > 1;
  return {system, folder / "camera.tum", bodies ? folder / "bodies" : fs::path()};
}

}  // namespace cvo
