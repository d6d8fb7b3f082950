// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/write_scene.h"

#include <memory>

namespace cvo::synth {

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
    const auto renderer = std::make_shared<Renderer>(world, threads);
    return DrawingTools{[renderer](const View& view) { return renderer->Draw(view); },
                        [renderer](const View& view, cv::Mat& left, cv::Mat& right) {
                          renderer->DrawImages(view, left, right);
                        }};
  };
  return source;
}

void WriteDataset(const SceneDescription& scene, const RenderRequest& request,
                  const std::filesystem::path& folder) {
  WriteDataset(SourceOf(scene, request), request, folder);
}

}  // namespace cvo::synth
