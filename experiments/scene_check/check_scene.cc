// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/scene_check/check_scene.h"

#include <array>
#include <exception>
#include <functional>
#include <utility>

#include "core/base/error.h"
#include "experiments/scene_check/checks.h"

namespace cvo {
namespace {

using Checks = std::vector<SceneCheck>;

// Adds the checks of a group. A group whose files cannot be read counts as one failed check, so
// that the other groups still run.
void AddGroup(const char* name, const std::function<Checks()>& group, Checks& checks) {
  try {
    Checks added = group();
    checks.insert(checks.end(), added.begin(), added.end());
  } catch (const std::exception& error) {
    if (dynamic_cast<const Error*>(&error) == nullptr &&
        dynamic_cast<const std::filesystem::filesystem_error*>(&error) == nullptr) {
      throw;
    }
    checks.push_back({StrCat(name, "_unreadable"), 1, "files", Bound::kAtMost, 0, error.what()});
  }
}

struct Group {
  const char* name;
  Checks (*check)(const SceneFolder&, TaskPool&);
};

constexpr std::array<Group, 9> kGroups = {{{"stereo", CheckStereo},
                                           {"poses", CheckPoses},
                                           {"motion", CheckMotion},
                                           {"flow", CheckFlow},
                                           {"masks", CheckMasks},
                                           {"labels", CheckLabels},
                                           {"detections", CheckDetections},
                                           {"targets", CheckTargets},
                                           {"features", CheckFeatures}}};

}  // namespace

SceneCheckReport CheckScene(const std::filesystem::path& folder, int threads) {
  if (!std::filesystem::is_regular_file(folder / "objects.csv")) {
    ThrowError(folder.string(), "no objects.csv", "the folder of a rendered scene");
  }
  TaskPool pool(threads);
  SceneCheckReport report;
  report.folder = folder.string();
  AddGroup(
      "manifest", [&] { return CheckFiles(folder, pool); }, report.checks);
  SceneFolder scene;
  const auto open = [&] {
    scene = OpenSceneFolder(folder);
    return Checks();
  };
  AddGroup("scene", open, report.checks);
  if (scene.image_frames.empty()) return report;
  report.frames = scene.frame_count();
  report.image_frames = static_cast<int>(scene.image_frames.size());
  for (const Group& group : kGroups) {
    AddGroup(
        group.name, [&] { return group.check(scene, pool); }, report.checks);
  }
  return report;
}

}  // namespace cvo
