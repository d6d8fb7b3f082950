// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/association/feature_grid.h"
#include "core/base/rng.h"
#include "core/estimation/double_track.h"
#include "core/odometry/camera_tracking.h"
#include "core/odometry/landmark_update.h"
#include "core/odometry/motion_model.h"
#include "core/odometry/odometry.h"
#include "core/odometry/window_optimization.h"

namespace cvo {

// The per-frame loop; the policies of `Variant` are its steps (variants/).
template <typename Variant>
class VisualOdometry final : public Odometry {
 public:
  explicit VisualOdometry(const OdometrySetup& setup)
      : camera_(setup.camera),
        options_(setup.options),
        rng_(setup.seed, "odometry"),
        double_track_(options_.window, options_.noise, options_.orb.scale_factor) {
    camera_.Check();
    options_.Check();
  }

  FrameReport Process(const StereoFrame& frame, StageTimes& times) override {
    FrameReport report = Begin(frame.timestamp_ns);
    report.features = static_cast<int>(frame.features.size());
    const FeatureGrid grid(frame.features, camera_);
    const RigidTransform predicted = motion_.Predict(frame.timestamp_ns);

    // Camera against the static landmarks (3.1, first paragraph).
    std::optional<CameraTrack> track;
    if (!window_.temporal.empty()) {
      const ScopedStage stage(times, "track");
      track = TrackCamera(options_, window_, grid, predicted, rng_);
    }
    if (!track && !StartsMap(report.features)) return EndLost(predicted, report);

    // Frame and landmarks enter the window (3.3, double-track frame management).
    WindowFrame entering{newest_, track ? track->world_from_camera : predicted};
    {
      const ScopedStage stage(times, "window");
      if (!track) Restart();
      const std::vector<Match> matches = track ? track->inliers : std::vector<Match>();
      AddObservations(entering, frame.features, matches, window_);
      report.new_landmarks =
          AddLandmarks(entering, frame.features, matches, options_.tracking.min_disparity_px,
                       next_landmark_, window_);
      RemoveUnconfirmed(newest_, options_.window.lost_frames, window_);
      double_track_.Advance(entering, window_);
    }

    // Bundle adjustment with the prior (3.3, static scene and camera pose).
    {
      const ScopedStage stage(times, "optimize");
      const WindowReport window =
          OptimizeWindow<typename Variant::Gauge, typename Variant::Calibration>(options_, window_);
      report.window_landmarks = window.landmarks;
      report.window_iterations = window.iterations;
      report.mean_error_px = window.mean_error_px;
      report.right_shift_px = window_.camera.right_shift_px;
    }
    report.status = !track ? FrameStatus::kFirst
                           : (lost_ > 0 ? FrameStatus::kRecovered : FrameStatus::kTracked);
    report.matches = track ? track->matches : 0;
    report.inliers = track ? static_cast<int>(track->inliers.size()) : 0;
    return EndTracked(frame.timestamp_ns, report);
  }

  FrameReport Skip(std::int64_t timestamp_ns) override {
    FrameReport report = Begin(timestamp_ns);
    report.status = FrameStatus::kSkipped;
    report.world_from_camera = motion_.Predict(timestamp_ns);
    trajectory_.push_back(report.world_from_camera);
    return report;
  }

  std::vector<RigidTransform> Trajectory() const override { return trajectory_; }

  std::vector<ClusterTrajectory> ClusterTrajectories() const override { return {}; }

 private:
  FrameReport Begin(std::int64_t timestamp_ns) {
    Require(!newest_.valid() || timestamp_ns > timestamp_ns_,
            "Odometry: timestamps must increase from frame to frame");
    timestamp_ns_ = timestamp_ns;
    ++newest_.value;
    return {};
  }

  // The first frame starts the map; so does a frame after tracking.restart_after lost ones.
  bool StartsMap(int features) const {
    const bool wanted = window_.temporal.empty() || lost_ >= options_.tracking.restart_after;
    return wanted && features >= options_.tracking.min_inliers;
  }

  void Restart() {
    window_ = Window{camera_, CalibrationPrior(camera_, options_.noise.right_shift_px), {}, {}, {}};
  }

  FrameReport EndLost(const RigidTransform& predicted, FrameReport report) {
    ++lost_;
    report.status = FrameStatus::kLost;
    report.world_from_camera = predicted;
    trajectory_.push_back(predicted);
    return report;
  }

  FrameReport EndTracked(std::int64_t timestamp_ns, FrameReport report) {
    lost_ = 0;
    trajectory_.resize(static_cast<std::size_t>(newest_.value) + 1);
    for (const WindowFrame& frame : window_.temporal) {
      trajectory_[frame.id.value] = frame.world_from_camera;
    }
    report.world_from_camera = trajectory_.back();
    report.window_frames = static_cast<int>(window_.spatial.size() + window_.temporal.size());
    motion_.Update(timestamp_ns, report.world_from_camera);
    return report;
  }

  StereoCamera camera_;
  Options options_;
  Rng rng_;
  DoubleTrack<typename Variant::MarginalizationRule, typename Variant::SpatialTrack> double_track_;

  Window window_;
  MotionModel motion_;
  std::vector<RigidTransform> trajectory_;
  FrameId newest_;
  LandmarkId next_landmark_{0};
  std::int64_t timestamp_ns_ = 0;
  int lost_ = 0;  // frames since the last tracked one
};

}  // namespace cvo
