// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/scene_check/scene_folder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "experiments/datasets/load_image.h"

namespace cvo {
namespace {

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

}  // namespace

std::filesystem::path SceneFolder::FileOf(const char* folder, int frame,
                                          const char* extension) const {
  std::array<char, 16> number{};
  std::snprintf(number.data(), number.size(), "%06d", frame);
  return path / folder / (number.data() + std::string(extension));
}

SceneFolder OpenSceneFolder(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path / "objects.csv")) {
    ThrowError(path.string(), "no objects.csv", "the folder of a rendered scene");
  }
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

cv::Mat ReadGrey(const std::filesystem::path& path) {
  LoadedImage image = LoadGrey(path);
  if (!image.ok()) throw Error(image.problem);
  return image.grey;
}

void Worst::Add(double candidate, const std::string& place) {
  if (!where.empty() && (std::isnan(figure) || candidate <= figure)) return;
  figure = candidate;
  where = place;
}

SceneCheck Worst::AtMost(const std::string& name, const std::string& unit, double limit) const {
  return {name, figure, unit, Bound::kAtMost, limit, figure == 0.0 ? "" : where};
}

std::string Short(double value) { return FormatGeneral(value, 3); }

}  // namespace cvo
