// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/LU>
#include <map>

#include "core/files/json/json.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_job.h"

namespace cvo {

namespace {

Json CountsToJson(const RunResult& run) {
  Json counts = Json::object();
  for (const FrameStatus status :
       {FrameStatus::kFirst, FrameStatus::kTracked, FrameStatus::kRecovered, FrameStatus::kLost,
        FrameStatus::kSkipped}) {
    counts[ToString(status)] = 0;
  }
  for (const FrameRecord& frame : run.frames) {
    Json& count = counts[ToString(frame.report.status)];
    count = count.get<int>() + 1;
  }
  return counts;
}

Json EndingsToJson(const SolverEndings& endings) {
  return {{"converged", endings.converged},
          {"iteration_limit", endings.iteration_limit},
          {"no_usable_step", endings.no_usable_step}};
}

// Counts, over all frames, how the solver ended.
Json SolverEndingsToJson(const RunResult& run) {
  SolverEndings camera;
  SolverEndings clusters;
  for (const FrameRecord& frame : run.frames) {
    camera += frame.report.window_endings;
    clusters += frame.report.cluster_endings;
  }
  return {{"camera_windows", EndingsToJson(camera)}, {"cluster_windows", EndingsToJson(clusters)}};
}

Json UndecodableToJson(const RunResult& run) {
  Json images = Json::array();
  for (const FrameRecord& frame : run.frames) {
    for (const ImageProblem& problem : frame.problems) {
      images.push_back(
          {{"frame", frame.frame}, {"image", problem.image}, {"reason", problem.reason}});
    }
  }
  return images;
}

// Describes the trajectory files beside the result.
Json TrajectoriesToJson(const RunResult& run) {
  Json predicted = Json::array();
  Json omitted = Json::array();
  std::size_t row = 0;
  for (const FrameRecord& frame : run.frames) {
    if (IsPredicted(frame)) predicted.push_back(row);
    if (frame.report.status == FrameStatus::kSkipped) omitted.push_back(frame.frame);
    ++row;
  }
  return {{"camera.kitti", {{"pose", "refined"}, {"predicted_rows", predicted}}},
          {"camera.tum", {{"pose", "refined"}, {"omitted_frames", omitted}}}};
}

std::vector<double> ToList(const Vector6d& v) { return {v.data(), v.data() + v.size()}; }

// The coefficients of StereoCamera::right_field_px; null if they were not estimated.
Json CalibrationToJson(const CalibrationReport& calibration) {
  if (!calibration.IsEstimated()) return nullptr;
  const Vector6d sigma_px = calibration.Covariance_px2().diagonal().cwiseSqrt();
  return {{"right_field_px", ToList(calibration.right_field_px)}, {"sigma_px", ToList(sigma_px)}};
}

// The calibration at the end of the run, with its covariance.
Json LastCalibrationToJson(const RunResult& run) {
  const std::optional<CalibrationReport> last = LastCalibration(run);
  if (!last) return nullptr;
  Json json = CalibrationToJson(*last);
  const Matrix6d covariance_px2 = last->Covariance_px2();
  Json rows = Json::array();
  for (int i = 0; i < covariance_px2.rows(); ++i) rows.push_back(ToList(covariance_px2.col(i)));
  json["covariance_px2"] = rows;
  return json;
}

Json FrameToJson(const FrameRecord& frame) {
  const FrameReport& report = frame.report;
  return {{"frame", frame.frame},
          {"timestamp_ns", frame.timestamp_ns},
          {"status", ToString(report.status)},
          {"causal", PoseOf(report.world_from_camera)},
          {"refined", PoseOf(frame.refined_world_from_camera)},
          {"features", report.features},
          {"matches", report.matches},
          {"inliers", report.inliers},
          {"new_landmarks", report.new_landmarks},
          {"window_frames", report.window_frames},
          {"spatial_ages", report.spatial_ages},
          {"window_landmarks", report.window_landmarks},
          {"window_iterations", report.window_iterations},
          {"mean_error_px", report.mean_error_px},
          {"calibration", CalibrationToJson(report.calibration)},
          {"detections", frame.detections.size()},
          {"clusters", report.clusters.size()}};
}

Json DetectionsToJson(const DetectionCounts& counts) {
  return {{"given", counts.given},
          {"outside", counts.outside},
          {"skipped", counts.skipped},
          {"without_depth", counts.without_depth},
          {"other_classes", counts.other_classes}};
}

// One row per cluster that was live in some frame. Its poses are in objects.csv and clusters/.
Json ClustersToJson(const RunResult& run) {
  struct Life {
    std::string category;
    int frames = 0;
    int tracked = 0;
    int first = 0;
    int last = 0;
  };
  std::map<ClusterId, Life> lives;
  ForEachLiveCluster(run, [&lives](const LiveCluster& row) {
    Life& life = lives[row.id];
    if (life.frames++ == 0) life.first = row.frame.frame;
    life.last = row.frame.frame;
    life.category = row.Last().category;
    life.tracked += row.Last().status == ClusterStatus::kTracked ? 1 : 0;
  });
  Json clusters = Json::array();
  for (const auto& [id, life] : lives) {
    clusters.push_back({{"id", id.value},
                        {"category", life.category},
                        {"frames", life.frames},
                        {"tracked", life.tracked},
                        {"first_frame", life.first},
                        {"last_frame", life.last}});
  }
  return clusters;
}

}  // namespace

std::optional<CalibrationReport> LastCalibration(const RunResult& run) {
  for (std::size_t i = run.frames.size(); i-- > 0;) {
    const CalibrationReport& calibration = run.frames[i].report.calibration;
    if (calibration.IsEstimated()) return calibration;
  }
  return std::nullopt;
}

reports::Pose PoseOf(const RigidTransform& pose) {
  const auto t = pose.translation();
  const auto q = pose.rotation();
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

reports::RunSequence SequenceOf(const Sequence& sequence, const std::string& content,
                                const std::vector<std::string>& warnings) {
  reports::RunSequence of;
  of.name = sequence.name;
  of.type = sequence.type;
  of.dataset = sequence.dataset;
  of.pair = sequence.pair;
  of.groundtruth = sequence.groundtruth;
  of.first_frame = sequence.first_frame;
  of.frames = static_cast<int>(sequence.images.size());
  of.total_frames = sequence.total_frames;
  of.labels = sequence.labels.size();
  of.detections = sequence.detections.size();
  of.detections_hash = DetectionsHash(sequence);
  of.content = content;
  of.camera = CameraOf(sequence.camera);
  const Json perturbation = PerturbationToJson(sequence.perturbation);
  if (!perturbation.empty()) of.perturbation = perturbation;
  of.warnings = warnings;
  if (!sequence.layout.empty()) of.layout = sequence.layout;
  return of;
}

reports::CameraInfo CameraOf(const StereoCamera& camera) {
  return {camera.width_px, camera.height_px, camera.fx,         camera.fy,
          camera.cx,       camera.cy,        camera.baseline_m, camera.right_shift_px};
}

Json ResultJson(reports::RunSummary summary, const Json& details) {
  summary.checksum = ChecksumOf(summary);
  Json json = FileJson(summary);
  json.update(details);
  return json;
}

std::string ResultFile(const RunResult& run) {
  reports::RunSummary summary;
  summary.job = run.job;
  summary.status = ToString(run.status);
  summary.message = run.message;
  summary.variant = run.variant.name;
  summary.seed = run.seed;
  summary.sequence = SequenceOf(run.sequence, run.content, run.warnings);
  summary.sequence.images = run.images_hash;
  summary.options = ResolvedOptions(run.options);
  summary.given = Given(run.sequence, run.classes, run.oracle);
  summary.detection_counts = DetectionsToJson(run.detections);
  summary.build = ThisBuild();
  summary.metrics = run.scores.metrics;
  const std::vector<BodyScore>& refined = run.scores.refined_bodies;
  const std::vector<BodyScore>& causal = run.scores.causal_bodies;
  if (!refined.empty()) {
    summary.bodies =
        reports::RunBodies{{refined.begin(), refined.end()}, {causal.begin(), causal.end()}};
  }
  Json frames = Json::array();
  for (const FrameRecord& frame : run.frames) frames.push_back(FrameToJson(frame));
  return DumpJson(
      ResultJson(summary, {{"clusters", ClustersToJson(run)},
                           {"calibration", LastCalibrationToJson(run)},
                           {"frame_counts", CountsToJson(run)},
                           {"solver_endings", SolverEndingsToJson(run)},
                           {"undecodable", UndecodableToJson(run)},
                           {"trajectories", TrajectoriesToJson(run)},
                           {"pose_layout", {"tx_m", "ty_m", "tz_m", "qx", "qy", "qz", "qw"}},
                           {"frames", frames}}));
}

namespace {

reports::TruthPoses PosesOf(const TruthBody& body, const RigidTransform& estimate_from_truth) {
  reports::TruthPoses poses;
  for (std::size_t i = 0; i < body.frames.size(); ++i) {
    if (!body.frames[i]) continue;
    poses.frames.push_back(static_cast<int>(i));
    poses.poses.push_back(PoseOf(estimate_from_truth * body.frames[i]->world_from_object));
    poses.visible.push_back(body.frames[i]->visible);
  }
  return poses;
}

reports::FramePositions PositionsOf(const reports::FrameErrors& errors,
                                    const std::vector<Eigen::Vector3d>& estimates,
                                    const RigidTransform& estimate_from_truth) {
  reports::FramePositions positions{errors.frames, {}};
  for (const Eigen::Vector3d& estimate : estimates) {
    const Eigen::Vector3d p = estimate_from_truth * estimate;
    positions.positions_m.push_back({p.x(), p.y(), p.z()});
  }
  return positions;
}

reports::TruthOfBody BodyOf(const BodyScore& score, const TruthBody& body,
                            const RigidTransform& estimate_from_truth) {
  reports::TruthOfBody truth;
  truth.id = score.id;
  truth.name = score.name;
  truth.category = score.category;
  truth.mover = score.mover;
  truth.diagonal_m = body.diagonal_m();
  truth.cluster = score.cluster;
  truth.truth = PosesOf(body, estimate_from_truth);
  truth.estimated = PositionsOf(score.errors, score.estimated_positions, estimate_from_truth);
  truth.predicted = PositionsOf(score.predicted, score.predicted_positions, estimate_from_truth);
  return truth;
}

}  // namespace

std::string TruthFile(const RunResult& run, const ObjectTruth* objects) {
  const RigidTransform estimate_from_truth = run.scores.truth_from_estimate.Inverse();
  reports::TruthData data;
  data.job = run.job;
  for (const auto& world_from_camera : run.sequence.groundtruth_world_from_camera) {
    data.camera.emplace_back();
    if (world_from_camera) data.camera.back() = PoseOf(estimate_from_truth * *world_from_camera);
  }
  if (objects != nullptr) {
    for (const BodyScore& score : run.scores.refined_bodies) {
      data.bodies.push_back(BodyOf(score, *FindBody(*objects, score.id), estimate_from_truth));
    }
  }
  return FileText(data);
}

}  // namespace cvo
