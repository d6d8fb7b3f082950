// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/scene_check/check_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/datasets/scene_check/checks.h"

namespace cvo {

namespace {

namespace fs = std::filesystem;

struct ListedFile {
  std::string name;
  std::uint64_t bytes = 0;
  std::string sha256;
};

std::vector<ListedFile> ReadManifest(const fs::path& path) {
  const Json manifest = ReadJson(path);
  std::vector<ListedFile> files;
  try {
    for (const Json& file : manifest.at("files")) {
      files.push_back({file.at("name"), file.at("size_bytes"), file.at("sha256")});
    }
  } catch (const Json::exception& error) {
    ThrowError(path.string(), StrCat("no list of files (", error.what(), ")"),
               "\"files\": [{\"name\", \"size_bytes\", \"sha256\"}, ...]");
  }
  return files;
}

// Describes what is wrong with a listed file; empty if nothing is.
std::string FindFault(const fs::path& folder, const ListedFile& file) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(folder / file.name, error);
  if (error) return "missing";
  if (size != file.bytes) return StrCat(size, " bytes, listed with ", file.bytes);
  return Sha256Hex(ReadFileBytes(folder / file.name)) == file.sha256 ? "" : "other SHA-256";
}

std::set<std::string> FilesIn(const fs::path& folder) {
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) files.insert(fs::relative(entry.path(), folder).generic_string());
  }
  return files;
}

// Returns the check that `count` is zero, with the first of the files counted.
SceneCheck CountOf(const std::string& name, int count, const std::string& first) {
  return {name, static_cast<double>(count), "files", 0.0, first};
}

// Compares every file of the folder with the manifest.
std::vector<SceneCheck> CheckFiles(const fs::path& folder, TaskPool& pool) {
  const std::vector<ListedFile> listed = ReadManifest(folder / "manifest.json");
  const std::vector<std::string> faults = ForAll<std::string>(
      static_cast<int>(listed.size()), pool,
      [&](int i) { return FindFault(folder, listed[static_cast<std::size_t>(i)]); });
  int changed = 0;
  std::string first_changed;
  std::set<std::string> present = FilesIn(folder);
  present.erase("manifest.json");
  for (std::size_t i = 0; i < listed.size(); ++i) {
    present.erase(listed[i].name);
    if (faults[i].empty()) continue;
    if (changed++ == 0) first_changed = listed[i].name + ": " + faults[i];
  }
  return {CountOf("manifest_changed_files", changed, first_changed),
          CountOf("manifest_unlisted_files", static_cast<int>(present.size()),
                  present.empty() ? "" : *present.begin())};
}

// Comparing images takes 0.2 s per frame, which would add up to almost a minute for 250 frames.
constexpr int kMaxImageFrames = 40;

std::vector<int> ChooseImageFrames(int frames) {
  const int count = std::min(frames, kMaxImageFrames);
  std::vector<int> chosen;
  for (int i = 0; i < count; ++i) {
    chosen.push_back(count == 1 ? 0 : static_cast<int>(1LL * i * (frames - 1) / (count - 1)));
  }
  return chosen;
}

SceneFolder OpenSceneFolder(const fs::path& path) {
  SceneFolder scene;
  scene.path = path;
  scene.sequence = OpenSequence({.folder = path, .type = "kitti-odometry"});
  for (const auto& pose : scene.sequence.groundtruth_world_from_camera) {
    if (!pose) ThrowError((path / "poses.txt").string(), "frames without a pose", "one per frame");
    scene.world_from_left.push_back(*pose);
  }
  scene.bodies = ReadSceneBodies(path / "objects.csv", scene.frame_count());
  scene.image_frames = ChooseImageFrames(scene.frame_count());
  return scene;
}

using Checks = std::vector<SceneCheck>;

// Adds the checks of a group. A group whose files cannot be read counts as one failed check, so
// that the other groups still run.
void AddGroup(const char* name, const std::function<Checks()>& group, Checks& checks) {
  try {
    Checks added = group();
    checks.insert(checks.end(), added.begin(), added.end());
  } catch (const std::exception& error) {
    if (dynamic_cast<const Error*>(&error) == nullptr &&
        dynamic_cast<const fs::filesystem_error*>(&error) == nullptr) {
      throw;
    }
    checks.push_back({StrCat(name, "_unreadable"), 1, "files", 0, error.what()});
  }
}

struct Group {
  const char* name;
  Checks (*check)(const SceneFolder&, TaskPool&);
};

constexpr std::array<Group, 3> kGroups = {
    {{"stereo", CheckStereo}, {"poses", CheckPoses}, {"masks", CheckMasks}}};

}  // namespace

fs::path SceneFolder::FileOf(const char* folder, int frame, const char* extension) const {
  std::array<char, 16> number{};
  std::snprintf(number.data(), number.size(), "%06d", frame);
  return path / folder / (number.data() + std::string(extension));
}

void Worst::Add(double candidate, const std::string& place) {
  if (!where.empty() && (std::isnan(figure) || candidate <= figure)) return;
  figure = candidate;
  where = place;
}

SceneCheck Worst::AtMost(const std::string& name, const std::string& unit, double limit) const {
  return {name, figure, unit, limit, figure == 0.0 ? "" : where};
}

bool SceneCheckReport::Passed() const {
  return std::all_of(checks.begin(), checks.end(),
                     [](const SceneCheck& check) { return check.Passed(); });
}

SceneCheckReport CheckScene(const fs::path& folder, int threads) {
  if (!fs::is_regular_file(folder / "objects.csv")) {
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
