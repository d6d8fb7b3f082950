// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// The bodies of a rendered scene, from objects.csv and the masks in instance_0.

#include <array>
#include <cmath>
#include <cstdio>

#include "experiments/datasets/body_truth_parts.h"
#include "experiments/datasets/formats/scene_truth.h"

namespace cvo {

BodyTracks ReadSceneBodyTracks(const Sequence& sequence) {
  constexpr int kMinVisible_px = 400;
  constexpr double kMinVisibleFraction = 0.3;
  const auto rows = ReadSceneBodies(sequence.folder / "objects.csv", sequence.total_frames);
  BodyTracks tracks;
  tracks.truth = reports::TruthSource::kScene;
  tracks.visible = {reports::VisibleBy::kMask, kMinVisible_px,
                    static_cast<int>(std::lround(100.0 * kMinVisibleFraction))};
  tracks.mover_travel_m = kIndoorTravel_m;
  for (std::size_t i = 0; i < rows.front().size(); ++i) {
    const SceneBody& first = rows.front()[i];
    if (IsTraffic(first.category)) tracks.mover_travel_m = kOutdoorTravel_m;
    BodyTrack body{first.id, first.id, first.name, first.category, first.size_m, {}};
    for (const std::vector<SceneBody>& frame : rows) {
      const SceneBody& now = frame[i];
      const bool visible =
          now.visible_px >= kMinVisible_px && now.visible_fraction >= kMinVisibleFraction;
      body.frames.push_back(BodyFrame{now.world_from_object, visible});
    }
    tracks.bodies.push_back(std::move(body));
  }
  tracks.mask = [folder = sequence.folder / "instance_0",
                 size_px =
                     cv::Size(sequence.camera.width_px, sequence.camera.height_px)](int frame) {
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "%06d.png", frame);
    return ReadInstances(folder / name.data(), size_px);
  };
  return tracks;
}

}  // namespace cvo
