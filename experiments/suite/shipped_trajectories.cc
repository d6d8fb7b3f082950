// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Trajectories of other systems that come with the program.
#include <filesystem>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/suite/suite.h"
#include "synth/scene/description.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHashLine = "# scene_sha256 ";

const ShippedTrajectory* Find(const std::string& system, const SuiteSequence& sequence) {
  const std::string scene = fs::path(sequence.scene).stem().string();
  for (const ShippedTrajectory& trajectory : ShippedTrajectories()) {
    if (trajectory.system == system && trajectory.scene == scene) return &trajectory;
  }
  return nullptr;
}

std::string SceneText(const std::string& scene) {
  const std::vector<synth::ShippedScene> shipped = synth::ShippedScenes();
  const synth::ShippedScene* found = FindBy(shipped, &synth::ShippedScene::name, scene);
  return found != nullptr ? found->text : ReadFileBytes(scene);
}

// Returns why the trajectory was made from other images than the sequence has; empty if it was not.
std::string Difference(const ShippedTrajectory& trajectory, const SuiteSequence& sequence) {
  if (!sequence.frames.empty()) return "ran on all frames, not " + sequence.frames;
  if (!sequence.perturb.empty()) return "ran on images without the perturbation";
  const std::string_view hash = trajectory.text.substr(kHashLine.size(), kHashBytes);
  if (Sha256Hex(SceneText(sequence.scene)) == hash) return "";
  return StrCat("ran on the scene file of SHA-256 ", hash.substr(0, 8), ", which has changed");
}

}  // namespace

bool IsShipped(const std::string& system, const SuiteSequence& sequence) {
  return Find(system, sequence) != nullptr;
}

SystemFiles ShippedSystemFiles(const std::string& system, const SuiteSequence& sequence,
                               const fs::path& cache) {
  const ShippedTrajectory& trajectory = *Find(system, sequence);
  const std::string difference = Difference(trajectory, sequence);
  if (!difference.empty()) {
    throw Error(StrCat(kStale, system, " on ", sequence.name, " ", difference));
  }
  const fs::path folder = cache / "trajectories" / system;
  const std::string name =
      StrCat(trajectory.scene, "-", Sha256Hex(trajectory.text).substr(0, 8), ".tum");
  std::error_code ignored;
  if (!fs::exists(folder / name, ignored)) {
    fs::create_directories(folder);
    WriteFilesAtomically(folder, {{name, std::string(trajectory.text)}});
  }
  return {system, folder / name, ""};
}

}  // namespace cvo
