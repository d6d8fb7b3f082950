// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/trajectory.h"
#include "experiments/record/cluster_tables.h"
#include "experiments/record/table_row.h"

namespace cvo {
namespace {

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
  ForEachClusterRow(run, [&](const ClusterRow& cluster) {
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

}  // namespace cvo
