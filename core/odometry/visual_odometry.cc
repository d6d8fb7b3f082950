// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <deque>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/rng.h"
#include "core/bodies/body_boxes.h"
#include "core/bodies/body_place.h"
#include "core/clusters/cluster_prediction.h"
#include "core/clusters/trace_back.h"
#include "core/estimation/window_problem.h"
#include "core/labelling/landmark_update.h"
#include "core/odometry/axes.h"
#include "core/odometry/camera_tracking.h"

namespace cvo {

namespace {

auto Timed(StageTimes& times, const char* stage, const auto& run) {
  const ScopedStage timer(times, stage);
  return run();
}

// The per-frame loop of the estimator, with the steps of a variant (variants/).
class VisualOdometry final : public Odometry {
 public:
  VisualOdometry(const Steps& steps, const OdometrySetup& setup, TaskPool& pool)
      : steps_(steps),
        camera_(setup.camera),
        options_(setup.options),
        pool_(pool),
        rng_(setup.seed, "odometry"),
        cluster_rng_(setup.seed, "clusters"),
        ground_(setup.seed) {
    camera_.Check();
    options_.Check();
  }

  FrameReport Process(const StereoFrame& input, StageTimes& times) override {
    CheckGiven(input);
    FrameReport report = Begin(input.timestamp_ns);
    StereoFrame frame = input;  // a copy, because alignment moves matched features
    const ShownBodies shown = steps_.show(frame);
    const FeatureGrid grid(frame.features, camera_);
    report.features = static_cast<int>(std::ranges::count_if(
        frame.features, [](const StereoFeature& feature) { return !IsLeftOnly(feature); }));

    // Camera against the static landmarks (3.1, first paragraph).
    const RigidTransform predicted =
        frame.given.world_from_camera.value_or(motion_.Predict(frame.timestamp_ns));
    const auto track = Timed(times, "track", [&] { return Track(predicted, shown, frame); });
    if (!track && !StartsMap(report.features)) return EndLost(predicted, report);
    if (!track) Restart();
    Step step{{frame, shown, grid, window_.camera, track ? track->world_from_camera : predicted,
               options_}};
    if (track) step.static_matches = track->inliers;

    // Features and boxes with the clusters (3.1, multi-level probabilistic association).
    Timed(times, "associate", [&] { Associate(frame.features, step); });
    // The body that each point belongs to (3.2, heterogeneous CRF).
    Timed(times, "label", [&] { Label(step); });
    // The frame and its landmarks enter the windows (3.3, double-track frame management).
    Timed(times, "window", [&] { report.new_landmarks = Enter(step); });
    // Bundle adjustment of the static window with its prior (3.3, Eq. 10 and 11).
    Timed(times, "optimize", [&] { OptimizeScene(input.features, report); });
    // The preceding frames are searched for clusters that were found late (METHOD.md 6.5).
    Timed(times, "trace", [&] {
      TraceBack({options_, window_, PredictorAnytimeOf(), steps_.show, steps_.association.find},
                kept_, clusters_, cluster_rng_);
    });
    // Every cluster with its motion prior, the camera held as it is now (3.3, Eq. 12 and 13).
    Timed(times, "optimize_clusters", [&] {
      report.cluster_endings = OptimizeClusters(options_, steps_.energy, window_, pool_, clusters_);
    });

    report.status = !track ? FrameStatus::kFirst
                           : (lost_ > 0 ? FrameStatus::kRecovered : FrameStatus::kTracked);
    report.matches = track ? track->matches : 0;
    report.inliers = static_cast<int>(step.static_matches.size());
    report.landmarks = std::move(step.labels.points);
    report.crf = std::move(step.labels.scene);
    report = EndTracked(step.view, std::move(report));
    Keep(std::move(frame), report.landmarks);
    return report;
  }

  FrameReport Skip(std::int64_t timestamp_ns) override {
    FrameReport report = Begin(timestamp_ns);
    report.status = FrameStatus::kSkipped;
    report.world_from_camera = motion_.Predict(timestamp_ns);
    return EndPredicted(report);
  }

  std::vector<RigidTransform> Trajectory() const override { return trajectory_; }

  std::vector<ClusterTrajectory> ClusterTrajectories() const override {
    return ConfirmedTrajectories(clusters_, options_.clusters);
  }

 private:
  // What is known of a frame so far.
  struct Step {
    FrameView view;
    std::vector<Match> static_matches = {};
    std::vector<ClusterTrack> cluster_tracks = {};
    std::vector<FramePoint> points = {};
    FrameLabels labels = {};
  };

  // Empty if the camera is lost, or if there is no map yet. Moves matched features.
  std::optional<CameraTrack> Track(const RigidTransform& predicted, const ShownBodies& shown,
                                   StereoFrame& frame) {
    if (window_.temporal.empty()) return std::nullopt;
    const FeatureGrid scene_grid(frame.features, camera_,
                                 SceneFeatures(frame.features, shown.detections));
    return TrackCamera(
        options_, window_, scene_grid, frame.features,
        {predicted, frame.given.world_from_camera.has_value(), motion_.HasVelocity()}, rng_);
  }

  // Moves matched features.
  void Associate(std::span<StereoFeature> features, Step& step) {
    TakenFeatures taken(features.size(), 0);
    for (const Match& match : step.static_matches) taken[match.feature] = 1;
    step.cluster_tracks = AssociateClusters(step.view, newest_, steps_.association,
                                            PredictorOfClusters(), clusters_, cluster_rng_, taken);
    for (std::size_t q = 0; q < step.cluster_tracks.size(); ++q) {
      if (!step.cluster_tracks[q].is_tracked) continue;
      PlaceFeatures(step.view, clusters_.live[q], step.cluster_tracks[q], features);
    }
  }

  void Label(Step& step) {
    step.points = CollectPoints(step.view, step.static_matches, step.cluster_tracks);
    step.labels = LabelPoints(step.view, steps_.labels, window_, clusters_, step.cluster_tracks,
                              step.points, crf_memory_);
    AdoptDetections(step.labels, clusters_, step.cluster_tracks);
  }

  // Returns the number of new landmarks.
  int Enter(Step& step) {
    const WindowFrame entering{newest_, step.view.world_from_camera,
                               step.view.frame.given.world_from_camera.has_value()};
    AddStates(step.view, newest_, step.cluster_tracks, clusters_);
    CreateClusters(step.view, newest_, step.points, step.labels, clusters_);
    const int created = UpdateLandmarks(step.view, entering, step.cluster_tracks, step.points,
                                        step.labels, next_landmark_, window_, clusters_);
    RemoveUnconfirmed(newest_, window_.landmarks);
    AdvanceWindow(entering);
    return created;
  }

  void OptimizeScene(const std::vector<StereoFeature>& features, FrameReport& report) {
    if (!TrustsCalibration(options_.noise)) {
      rows_.Add(RowOffsets(features, options_.orb.scale_factor), camera_);
    }
    OptimizeWindow(options_, steps_.energy, rows_, window_, report);
  }

  FrameReport Begin(std::int64_t timestamp_ns) {
    Require(!newest_.valid() || timestamp_ns > timestamp_ns_,
            "Odometry: timestamps must increase from frame to frame");
    timestamp_ns_ = timestamp_ns;
    ++newest_.value;
    return {};
  }

  // Predicts clusters at the time of the current frame.
  ClusterPredictor PredictorOfClusters() const {
    return [predict = PredictorAnytimeOf(), now_ns = timestamp_ns_](const Cluster& cluster) {
      return predict(cluster, now_ns);
    };
  }

  // A frame with enough features starts the map if it is the first one or follows at least
  // tracking.restart_after lost ones.
  bool StartsMap(int features) const {
    const bool wanted = window_.temporal.empty() || lost_ >= options_.tracking.restart_after;
    return wanted && features >= options_.tracking.min_inliers;
  }

  void Restart() {
    window_ = Window{
        camera_, CalibrationPrior(camera_, CalibrationDeviation(options_.noise)), {}, {}, {}};
  }

  PredictorAnytime PredictorAnytimeOf() const {
    return [this](const Cluster& cluster, std::int64_t timestamp_ns) {
      return PredictCluster(cluster, timestamp_ns, *steps_.extrapolate, options_.motion_prior);
    };
  }

  void Keep(StereoFrame frame, const std::vector<LandmarkReport>& landmarks) {
    if (options_.clusters.trace_states == 0) return;
    KeptFrame kept{newest_, std::move(frame), {}};
    kept.taken.resize(kept.frame.features.size(), 0);
    for (const LandmarkReport& landmark : landmarks) {
      kept.taken[landmark.feature] = landmark.cluster.valid() && landmark.cluster != kStaticScene;
    }
    kept_.push_back(std::move(kept));
    while (kept_.front().id < window_.temporal.front().id) kept_.pop_front();
  }

  // Adds the frame to T_t. What the clusters saw in the frame that leaves T_t stays with their
  // landmarks.
  void AdvanceWindow(const WindowFrame& entering) {
    const std::optional<WindowFrame> oldest =
        window_.temporal.empty() ? std::nullopt : std::optional(window_.temporal.front());
    steps_.advance(options_, entering, window_);
    for (Cluster& cluster : clusters_.live) {
      if (oldest && window_.temporal.front().id != oldest->id) {
        AbsorbObservations(window_, *oldest, options_.NoiseOfFeatures(), options_.clusters,
                           cluster);
      }
      RemoveUnconfirmed(newest_, cluster.landmarks);
      TrimCluster(window_, newest_, options_.clusters, cluster);
    }
  }

  FrameReport EndLost(const RigidTransform& predicted, FrameReport report) {
    ++lost_;
    report.status = FrameStatus::kLost;
    report.world_from_camera = predicted;
    return EndPredicted(report);
  }

  FrameReport EndPredicted(FrameReport report) {
    trajectory_.push_back(report.world_from_camera);
    EndClusters(nullptr, report);
    return report;
  }

  // `view` is null for a frame without a tracked camera.
  void EndClusters(const FrameView* view, FrameReport& report) {
    RetireClusters(newest_, options_.LiveFrames(), options_.clusters, clusters_);
    const ClusterPredictor predict = PredictorOfClusters();
    std::vector<ClusterReport> described = DescribeClusters(newest_, predict, clusters_);
    if (view != nullptr) ground_.Update(SeenStaticPoints(), report.world_from_camera);
    boxes_.Describe({options_, clusters_, view, newest_, report.world_from_camera,
                     ground_.Down(report.world_from_camera)},
                    described);
    report.clusters =
        RecordClusters(options_.clusters, newest_, timestamp_ns_, std::move(described), clusters_);
  }

  std::vector<Eigen::Vector3d> SeenStaticPoints() const {
    std::vector<Eigen::Vector3d> points;
    for (const Landmark& landmark : window_.landmarks) {
      if (landmark.last_seen == newest_) points.push_back(landmark.p_in_object);
    }
    return points;
  }

  FrameReport EndTracked(FrameView view, FrameReport report) {
    lost_ = 0;
    trajectory_.resize(static_cast<std::size_t>(newest_.value) + 1);
    for (const WindowFrame& frame : window_.temporal) {
      trajectory_[frame.id.value] = frame.world_from_camera;
    }
    report.world_from_camera = trajectory_.back();
    report.window_frames = static_cast<int>(window_.spatial.size() + window_.temporal.size());
    for (const WindowFrame& frame : window_.spatial) {
      report.spatial_ages.push_back(static_cast<int>(newest_.value - frame.id.value));
    }
    motion_.Update(timestamp_ns_, report.world_from_camera);
    for (Cluster& cluster : clusters_.live) UpdateExtent(cluster);
    view.world_from_camera = report.world_from_camera;
    view.camera = window_.camera;
    EndClusters(&view, report);
    return report;
  }

  Steps steps_;
  StereoCamera camera_;
  Options options_;
  TaskPool& pool_;
  Rng rng_;
  Rng cluster_rng_;
  GroundDirection ground_;

  RowField rows_;  // of the rig
  Window window_;
  std::deque<KeptFrame> kept_;  // of T_t, for TraceBack
  ClusterMap clusters_;
  BodyBoxes boxes_;
  MotionModel motion_;
  CrfMemory crf_memory_;
  std::vector<RigidTransform> trajectory_;
  FrameId newest_;
  LandmarkId next_landmark_{0};
  std::int64_t timestamp_ns_ = 0;
  int lost_ = 0;  // number of frames since the last tracked one
};

}  // namespace

std::unique_ptr<Odometry> MakeOdometry(const Steps& steps, const OdometrySetup& setup,
                                       TaskPool& pool) {
  return std::make_unique<VisualOdometry>(steps, setup, pool);
}

}  // namespace cvo
