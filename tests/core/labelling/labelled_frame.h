// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/clusters/cluster_prediction.h"
#include "core/labelling/cluster_labels.h"
#include "core/labelling/landmark_update.h"
#include "core/odometry/cluster_update.h"
#include "tests/core/clusters/small_windows.h"

namespace cvo::test {

// A frame observed by a camera at the origin, with features at given points.
struct Frame {
  Options options;
  StereoFrame frame;
  std::vector<FramePoint> points;
  FrameLabels labels;
  Window window;
  ClusterMap map;

  Frame() { window.camera = kCamera; }

  static Eigen::Vector3d Pixel(const Eigen::Vector3d& p_in_camera) {
    return *kCamera.Project(p_in_camera);
  }
  // Adds a feature that observes a landmark of `owner` and is labelled `assigned`.
  void Add(const Eigen::Vector3d& p_in_camera, int owner, int landmark, ClusterId assigned) {
    FramePoint point;
    point.feature = static_cast<int>(frame.features.size());
    point.owner = owner;
    point.landmark = landmark;
    points.push_back(point);
    StereoFeature feature;
    feature.z_px = Pixel(p_in_camera);
    frame.features.push_back(feature);
    LandmarkReport label;
    label.inferred = label.cluster = assigned;
    label.confidence = 1;
    labels.points.push_back(label);
  }
  template <typename Use>
  auto With(Use use) {
    const FeatureGrid grid(frame.features, kCamera);
    const FrameView view{frame,   UseDetections::Show(frame), grid,
                         kCamera, RigidTransform(),           options};
    return use(view);
  }
};

// A body that moves 0.1 m to the right per frame, and a point that is static or on the body. Frames
// 0 to 3 are in the window; frame 4, in which the body is at x = 0.4 m, is entering.
struct Moving : Frame {
  static constexpr int kBody = 0;
  const Eigen::Vector3d p_in_world{0.5, 0.2, 6.0};  // the point; in frame 4 if it moves
  std::vector<ClusterTrack> tracks{1};
  LandmarkId next{10};

  Moving() {
    Cluster cluster;
    cluster.id = ClusterId{1};
    for (std::int64_t f = 0; f < 4; ++f) {
      window.temporal.push_back({FrameId{f}, {}, false});
      cluster.states.push_back({FrameId{f}, f, BodyAt(f), {1.0, 0.0, 0.0}});
    }
    map.live = {cluster};
    map.next = ClusterId{2};
    tracks[0].is_tracked = true;
    tracks[0].world_from_object = BodyAt(4);
  }
  static RigidTransform BodyAt(std::int64_t frame) {
    return At(0.1 * static_cast<double>(frame), 0.0, 6.0);
  }
  // Returns a landmark that was observed at `where(frame)` in frames 0 to 3.
  template <typename Where>
  static Landmark Seen(const Eigen::Vector3d& p_in_object, Where where) {
    Landmark landmark;
    landmark.id = LandmarkId{7};
    landmark.p_in_object = p_in_object;
    landmark.last_seen = FrameId{3};
    for (std::int64_t f = 0; f < 4; ++f) {
      landmark.observations.push_back({FrameId{f}, Pixel(where(f)), 0});
    }
    return landmark;
  }
  Eigen::Vector3d OnBody(std::int64_t f) const {
    return BodyAt(f) * (BodyAt(4).Inverse() * p_in_world);
  }
  int Update() {
    return With([&](const FrameView& view) {
      return UpdateLandmarks(view, {FrameId{4}, {}, false}, tracks, points, labels, next, window,
                             map);
    });
  }
};

}  // namespace cvo::test
