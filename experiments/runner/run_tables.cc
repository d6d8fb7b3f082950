// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>

#include "core/association/box_association.h"
#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/geometry/rigid_transform.h"
#include "core/record/csv_rows.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_result.h"

namespace cvo {
namespace {

// Of landmarks.csv. Finer than anything that is computed from these values, and half the bytes of
// an exact representation.
constexpr int kDecimalsPixels = 2;
constexpr int kDecimals = 3;  // m

double Rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

Eigen::Vector3d Rounded(const Eigen::Vector3d& values, int decimals) {
  return {Rounded(values.x(), decimals), Rounded(values.y(), decimals),
          Rounded(values.z(), decimals)};
}

std::optional<std::int64_t> LabelOf(ClusterId id) {
  return id.valid() ? std::optional(id.value) : std::nullopt;
}

}  // namespace

void WriteObjectTable(const RunResult& run, const TextSink& sink) {
  sink(CsvHeader<reports::ObjectRow>() + "\n");
  ForEachLiveCluster(run, [&](const LiveCluster& cluster) {
    const ClusterReport& report = cluster.Last();
    reports::ObjectRow row;
    row.frame = cluster.frame.frame;
    row.timestamp_ns = cluster.frame.timestamp_ns;
    row.id = cluster.id.value;
    row.category = report.category;
    if (cluster.causal) {
      row.causal_status = ToString(cluster.causal->status);
      row.causal_world_from_object = cluster.causal->world_from_object;
      row.causal_velocity_m_s = cluster.causal->velocity_m_s;
    }
    if (cluster.refined) {
      row.refined_status = ToString(cluster.refined->status);
      row.refined_world_from_object = cluster.refined->world_from_object;
      row.refined_velocity_m_s = cluster.refined->velocity_m_s;
    }
    row.center_in_object = report.center_in_object;
    row.half_size_m = report.half_size_m;
    row.object_from_box = report.box.object_from_box;
    row.size_m = report.box.size_m;
    row.projected_box = ProjectedBox(cluster, run.sequence.camera);
    row.observed_landmarks = report.observed_landmarks;
    if (report.detection >= 0) row.detection = report.detection;
    row.score = report.score;
    sink(CsvLine(row));
  });
}

std::string ClusterTum(const ClusterTrajectory& cluster) {
  Trajectory tracked;
  for (const ClusterPose& pose : cluster.poses) {
    if (pose.status != ClusterStatus::kTracked) continue;
    tracked.push_back({pose.timestamp_ns, pose.world_from_object});
  }
  return FormatTumTrajectory(tracked);
}

std::string LandmarkRows(int frame, const StereoFrame& given,
                         const std::vector<LandmarkReport>& landmarks,
                         const std::vector<LandmarkTruth>& feature_truth) {
  Require(feature_truth.empty() || feature_truth.size() == given.features.size(),
          "LandmarkRows: truth for every feature, or none");
  std::string rows;
  for (const LandmarkReport& landmark : landmarks) {
    const auto feature = static_cast<std::size_t>(landmark.feature);
    reports::LandmarkRow row;
    row.frame = frame;
    row.id = landmark.id.value;
    row.z_px = Rounded(given.features.at(feature).z_px, kDecimalsPixels);
    row.cluster = LabelOf(landmark.cluster);
    row.inferred = LabelOf(landmark.inferred);
    row.confidence = landmark.confidence;
    row.p_in_world = Rounded(landmark.p_in_world, kDecimals);
    const int body = feature_truth.empty() ? -1 : feature_truth[feature].body;
    if (body >= 0) row.truth_body = body;
    rows += CsvLine(row);
  }
  return rows;
}

namespace {

// The cluster's 3D box, upright in the camera frame: its tilt is ignored, because KITTI takes the
// camera's y axis as the vertical.
ObjectBox::Box3d UprightBox(const LiveCluster& cluster, double left_offset_m) {
  const RigidTransform camera_from_box = cluster.CameraFromBox();
  const Eigen::Vector3d forward = camera_from_box.rotation() * Eigen::Vector3d::UnitX();
  const Eigen::Vector3d& size_m = cluster.Last().box.size_m;
  ObjectBox::Box3d box;
  box.length_m = size_m.x();
  box.height_m = size_m.y();
  box.width_m = size_m.z();
  box.bottom_in_camera =
      camera_from_box.translation() + Eigen::Vector3d(-left_offset_m, 0.5 * box.height_m, 0.0);
  box.heading_rad = std::atan2(-forward.z(), forward.x());
  return box;
}

// The box of the associated detection, otherwise the projected 3D box; empty if out of view.
std::optional<ImageBox> Box2d(const LiveCluster& cluster, const StereoCamera& camera) {
  const int detection = cluster.Last().detection;
  if (detection < 0) return ProjectedBox(cluster, camera);
  return cluster.frame.detections.at(static_cast<std::size_t>(detection)).box;
}

}  // namespace

void ForEachTrackBox(const RunResult& run, const std::function<void(const ObjectBox&)>& take) {
  ForEachLiveCluster(run, [&](const LiveCluster& cluster) {
    if (cluster.Last().status == ClusterStatus::kPredicted) return;
    const std::optional<ImageBox> box2d = Box2d(cluster, run.sequence.camera);
    if (!box2d) return;
    ObjectBox box;
    box.frame = cluster.frame.frame;
    box.track = static_cast<int>(cluster.id.value);
    box.type = cluster.Last().category.empty() ? "Misc" : cluster.Last().category;
    box.left_px = box2d->left_px;
    box.top_px = box2d->top_px;
    box.right_px = box2d->right_px;
    box.bottom_px = box2d->bottom_px;
    box.box3d = UprightBox(cluster, run.sequence.left_offset_m);
    box.score = cluster.Last().score;
    take(box);
  });
}

void WriteKittiTracks(const RunResult& run, const TextSink& sink) {
  ForEachTrackBox(run, [&sink](const ObjectBox& box) {
    const ObjectBox::Box3d& box3d = *box.box3d;
    const Eigen::Vector3d& bottom = box3d.bottom_in_camera;
    std::string line = StrCat(box.frame, " ", box.track, " ", box.type, " -1 -1");
    const double observed_rad = std::remainder(
        box3d.heading_rad - std::atan2(bottom.x(), bottom.z()), 2.0 * std::numbers::pi);
    for (const double number : {observed_rad, box.left_px, box.top_px, box.right_px, box.bottom_px,
                                box3d.height_m, box3d.width_m, box3d.length_m, bottom.x(),
                                bottom.y(), bottom.z(), box3d.heading_rad, *box.score}) {
      if (!std::isfinite(number)) {
        ThrowError("a line of tracks.kitti \"" + line + "\"", "a number that is not finite",
                   "a finite one");
      }
      line += ' ';
      line += FormatDouble(number);
    }
    sink(line + "\n");
  });
}

namespace {

std::array<Eigen::Vector3d, 8> CornersInCamera(const LiveCluster& row) {
  std::array<Eigen::Vector3d, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign((i & 1U) != 0 ? 1.0 : -1.0, (i & 2U) != 0 ? 1.0 : -1.0,
                               (i & 4U) != 0 ? 1.0 : -1.0);
    corners[i] =
        row.CameraFromBox() * Eigen::Vector3d(0.5 * sign.cwiseProduct(row.Last().box.size_m));
  }
  return corners;
}

}  // namespace

RigidTransform LiveCluster::CameraFromBox() const {
  const RigidTransform& world_from_camera =
      refined ? frame.refined_world_from_camera : frame.report.world_from_camera;
  return world_from_camera.Inverse() * Last().world_from_object * Last().box.object_from_box;
}

void ForEachLiveCluster(const RunResult& run, const std::function<void(const LiveCluster&)>& take) {
  std::vector<std::map<ClusterId, const ClusterPose*>> refined(run.frames.size());
  for (const ClusterTrajectory& cluster : run.clusters) {
    for (const ClusterPose& pose : cluster.poses) {
      refined.at(static_cast<std::size_t>(pose.frame))[cluster.id] = &pose;
    }
  }
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const FrameRecord& frame = run.frames[i];
    std::map<ClusterId, LiveCluster> rows;
    const auto row = [&](ClusterId id) -> LiveCluster& {
      return rows.try_emplace(id, LiveCluster{frame, id}).first->second;
    };
    for (const ClusterReport& report : frame.report.clusters) row(report.id).causal = &report;
    for (const auto& [id, pose] : refined[i]) row(id).refined = pose;
    for (const auto& [id, row_of_id] : rows) take(row_of_id);
  }
}

std::optional<ImageBox> ProjectedBox(const LiveCluster& row, const StereoCamera& camera) {
  const std::array<Eigen::Vector3d, 8> corners = CornersInCamera(row);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNear_m = 0.1;
  ImageBox box = {kInfinity, kInfinity, -kInfinity, -kInfinity};
  const auto add = [&](const Eigen::Vector3d& p_in_camera) {
    const double u_px = camera.fx * p_in_camera.x() / p_in_camera.z() + camera.cx;
    const double v_px = camera.fy * p_in_camera.y() / p_in_camera.z() + camera.cy;
    box = {std::min(box.left_px, u_px), std::min(box.top_px, v_px), std::max(box.right_px, u_px),
           std::max(box.bottom_px, v_px)};
  };
  // Edges connect corners whose indices differ in one bit. An edge through the near plane is cut
  // there.
  for (unsigned i = 0; i < 8; ++i) {
    if (corners[i].z() >= kNear_m) add(corners[i]);
    for (const unsigned bit : {1U, 2U, 4U}) {
      const Eigen::Vector3d& a = corners[i];
      const Eigen::Vector3d& b = corners[i | bit];
      if ((a.z() < kNear_m) == (b.z() < kNear_m)) continue;
      add(a + (kNear_m - a.z()) / (b.z() - a.z()) * (b - a));
    }
  }
  const double right_px = camera.width_px - 1;
  const double bottom_px = camera.height_px - 1;
  if (!(box.right_px >= 0.0 && box.bottom_px >= 0.0 && box.left_px <= right_px &&
        box.top_px <= bottom_px)) {
    return std::nullopt;
  }
  return ImageBox{std::max(box.left_px, 0.0), std::max(box.top_px, 0.0),
                  std::min(box.right_px, right_px), std::min(box.bottom_px, bottom_px)};
}

const char* ToString(RunStatus status) {
  static constexpr std::array kNames = {"ok", "lost", "failed"};
  return kNames.at(static_cast<std::size_t>(status));
}

}  // namespace cvo
