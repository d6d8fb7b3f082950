// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/write_scene.h"

#include <memory>

#include "synth/render/calibration_target.h"

namespace cvo::synth {
namespace {

std::vector<TargetImages> DrawTargets(const StereoCamera& rig, int threads) {
  const CalibrationTarget target = MakeCalibrationTarget(rig);
  Renderer renderer(target.world, threads);
  std::vector<TargetImages> images;
  for (const View& view : target.views) {
    cv::Mat left, right;
    renderer.DrawImages(view, left, right);
    TargetImages& added = images.emplace_back();
    added.left = LumaOf(left);
    added.right = LumaOf(right);
    const RigidTransform left_from_board = view.world_from_left.Inverse();
    for (const Eigen::Vector3d& corner : target.corners_m) {
      added.corners_in_left.push_back(left_from_board * corner);
    }
  }
  return images;
}

}  // namespace

DrawingTools OpenRenderer(const World& world, int threads) {
  const auto renderer = std::make_shared<Renderer>(world, threads);
  return {[renderer](const View& view) { return renderer->Draw(view); },
          [renderer](const View& view, cv::Mat& left, cv::Mat& right) {
            renderer->DrawImages(view, left, right);
          },
          [rig = world.rig, threads] { return DrawTargets(rig, threads); }};
}

DatasetSource SourceOf(const SceneDescription& scene, const RenderRequest& request) {
  DatasetSource source;
  source.scene = scene.name();
  source.description = scene.json();
  source.render_key = RenderKeyText(scene);
  source.seed = scene.seed();
  source.sensor = ReadSensor(scene.sensor(), scene.where());
  source.detectors = ReadDetectors(scene.detector(), scene.where(), request.detector_levels);
  source.version = FindRendererVersion();
  source.build_world = [scene, threads = request.threads] { return BuildWorld(scene, threads); };
  source.open_tools = [threads = request.threads](const World& world) {
    return OpenRenderer(world, threads);
  };
  return source;
}

void WriteDataset(const SceneDescription& scene, const RenderRequest& request,
                  const std::filesystem::path& folder) {
  WriteDataset(SourceOf(scene, request), request, folder);
}

}  // namespace cvo::synth
