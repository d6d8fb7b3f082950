// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/run_tables.h"

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "core/association/box_association.h"
#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/geometry/rigid_transform.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {

namespace {

// One row of a table, with cells separated by `separator`. Numbers are written as the shortest text
// that reads back as the same number; a number that is not finite throws Error.
class TableRow {
 public:
  explicit TableRow(char separator) : separator_(separator) {}

  void Text(std::string_view text);
  void Integer(std::int64_t value);
  void Number(double value);
  // Appends the value rounded to a multiple of 10^-decimals.
  void Rounded(double value, int decimals);
  void Vector(const Eigen::Vector3d& vector);
  void Pose(const RigidTransform& pose);         // x y z qx qy qz qw
  void Box(const std::optional<ImageBox>& box);  // left top right bottom, px
  void Empty(int cells);

  // Returns the row with a newline.
  std::string Line() const { return line_ + '\n'; }

 private:
  void Part();

  char separator_;
  bool first_ = true;
  std::string line_;
};

void TableRow::Part() {
  if (!first_) line_ += separator_;
  first_ = false;
}

void TableRow::Text(std::string_view text) {
  Part();
  line_ += text;
}

void TableRow::Integer(std::int64_t value) { Text(std::to_string(value)); }

void TableRow::Number(double value) {
  if (!std::isfinite(value)) {
    ThrowError("a table's row \"" + line_ + "\"", "a number that is not finite", "a finite one");
  }
  Text(FormatDouble(value));
}

void TableRow::Rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  Number(std::round(value * scale) / scale);
}

void TableRow::Vector(const Eigen::Vector3d& vector) {
  for (int i = 0; i < 3; ++i) Number(vector[i]);
}

void TableRow::Pose(const RigidTransform& pose) {
  Vector(pose.translation());
  for (int i = 0; i < 4; ++i) Number(pose.data()[i]);
}

void TableRow::Box(const std::optional<ImageBox>& box) {
  if (!box) return Empty(4);
  for (const double side_px : {box->left_px, box->top_px, box->right_px, box->bottom_px}) {
    Number(side_px);
  }
}

void TableRow::Empty(int cells) {
  for (int i = 0; i < cells; ++i) Text("");
}

constexpr const char* kObjectTableHeader =
    "frame,timestamp_ns,id,category,status,"
    "x,y,z,qx,qy,qz,qw,vx,vy,vz,"
    "refined_x,refined_y,refined_z,refined_qx,refined_qy,refined_qz,refined_qw,"
    "refined_vx,refined_vy,refined_vz,"
    "center_x,center_y,center_z,half_x_m,half_y_m,half_z_m,"
    "box_x,box_y,box_z,box_qx,box_qy,box_qz,box_qw,length_m,height_m,width_m,"
    "left_px,top_px,right_px,bottom_px,observed_landmarks,detection,score\n";
constexpr int kPoseAndVelocity = 10;

void AddPose(const ClusterReport* report, TableRow& row) {
  if (!report) return row.Empty(kPoseAndVelocity);
  row.Pose(report->world_from_object);
  row.Vector(report->velocity_m_s);
}

}  // namespace

void WriteObjectTable(const Sequence& sequence, const RunResult& run, const TextSink& sink) {
  sink(kObjectTableHeader);
  ForEachLiveCluster(run, [&](const LiveCluster& cluster) {
    const ClusterReport& report = cluster.Last();
    TableRow row(',');
    row.Integer(cluster.frame.frame);
    row.Integer(cluster.frame.timestamp_ns);
    row.Integer(cluster.id.value);
    row.Text(report.category);
    row.Text(ToString(report.status));
    AddPose(cluster.causal, row);
    AddPose(cluster.refined, row);
    row.Vector(report.center_in_object);
    row.Vector(report.half_size_m);
    row.Pose(report.box.object_from_box);
    row.Vector(report.box.size_m);
    row.Box(ProjectedBox(cluster, sequence.camera));
    row.Integer(report.observed_landmarks);
    report.detection < 0 ? row.Empty(1) : row.Integer(report.detection);
    row.Number(report.score);
    sink(row.Line());
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

namespace {

// Finer than anything that is computed from these values, and half the bytes of an exact
// representation.
constexpr int kDecimalsPixels = 2;
constexpr int kDecimals = 3;  // m, nats

void Label(ClusterId id, TableRow& row) {
  if (id.valid()) {
    row.Integer(id.value);
  } else {
    row.Empty(1);
  }
}

}  // namespace

const std::string_view kLandmarksHeader =
    "frame,id,u_px,v_px,u_right_px,cluster,inferred,confidence,energy_2d,energy_3d,energy_motion,"
    "x,y,z,truth_body,second,second_2d,second_3d,second_motion\n";

std::string LandmarkRows(int frame, const StereoFrame& given,
                         const std::vector<LandmarkReport>& landmarks,
                         const std::vector<LandmarkTruth>& feature_truth) {
  Require(feature_truth.empty() || feature_truth.size() == given.features.size(),
          "LandmarkRows: truth for every feature, or none");
  std::string rows;
  for (const LandmarkReport& landmark : landmarks) {
    const auto feature = static_cast<std::size_t>(landmark.feature);
    TableRow row(',');
    row.Integer(frame);
    row.Integer(landmark.id.value);
    for (int k = 0; k < 3; ++k) row.Rounded(given.features.at(feature).z_px[k], kDecimalsPixels);
    Label(landmark.cluster, row);
    Label(landmark.inferred, row);
    row.Integer(landmark.confidence);
    row.Rounded(landmark.energy_2d, kDecimals);
    row.Rounded(landmark.energy_3d, kDecimals);
    row.Rounded(landmark.energy_motion, kDecimals);
    for (int k = 0; k < 3; ++k) row.Rounded(landmark.p_in_world[k], kDecimals);
    const int body = feature_truth.empty() ? -1 : feature_truth[feature].body;
    body < 0 ? row.Empty(1) : row.Integer(body);
    Label(landmark.second, row);
    row.Rounded(landmark.second_2d, kDecimals);
    row.Rounded(landmark.second_3d, kDecimals);
    row.Rounded(landmark.second_motion, kDecimals);
    rows += row.Line();
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

void ForEachTrackBox(const Sequence& sequence, const RunResult& run,
                     const std::function<void(const ObjectBox&)>& take) {
  ForEachLiveCluster(run, [&](const LiveCluster& cluster) {
    const std::optional<ImageBox> box2d = Box2d(cluster, sequence.camera);
    if (!box2d) return;
    ObjectBox box;
    box.frame = cluster.frame.frame;
    box.track = static_cast<int>(cluster.id.value);
    box.type = cluster.Last().category.empty() ? "Misc" : cluster.Last().category;
    box.left_px = box2d->left_px;
    box.top_px = box2d->top_px;
    box.right_px = box2d->right_px;
    box.bottom_px = box2d->bottom_px;
    box.box3d = UprightBox(cluster, sequence.left_offset_m);
    box.score = cluster.Last().score;
    take(box);
  });
}

void WriteKittiTracks(const Sequence& sequence, const RunResult& run, const TextSink& sink) {
  ForEachTrackBox(sequence, run, [&sink](const ObjectBox& box) {
    const ObjectBox::Box3d& box3d = *box.box3d;
    const Eigen::Vector3d& bottom = box3d.bottom_in_camera;
    TableRow row(' ');
    row.Integer(box.frame);
    row.Integer(box.track);
    row.Text(box.type);
    row.Integer(-1);  // truncation and occlusion are not estimated
    row.Integer(-1);
    row.Number(std::remainder(box3d.heading_rad - std::atan2(bottom.x(), bottom.z()),
                              2.0 * std::numbers::pi));
    row.Box(ImageBox{box.left_px, box.top_px, box.right_px, box.bottom_px});
    row.Vector({box3d.height_m, box3d.width_m, box3d.length_m});
    row.Vector(bottom);
    row.Number(box3d.heading_rad);
    row.Number(*box.score);
    sink(row.Line());
  });
}

}  // namespace cvo
