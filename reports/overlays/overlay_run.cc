// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/overlay_run.h"

#include <algorithm>
#include <set>
#include <span>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/geometry/rigid_transform.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

constexpr double kTail_s = 2.0;

void CheckCamera(const CameraInfo& camera, const fs::path& file) {
  constexpr int kLargest_px = 20000;
  const bool good = camera.width_px > 0 && camera.height_px > 0 && camera.width_px <= kLargest_px &&
                    camera.height_px <= kLargest_px && camera.fx_px > 0.0 && camera.fy_px > 0.0;
  if (!good) ThrowError(file.string() + ", sequence, camera", ToJson(camera).dump(), "a camera");
}

void ReadHead(const fs::path& file, OverlayRun& run) {
  const auto head =
      ReadRecord<RunSummary>(file, {"bodies", "clusters", "frames", "metrics", "options"});
  run.variant = head.variant;
  run.seed = head.seed;
  run.sequence = head.sequence;
  CheckCamera(run.sequence.camera, file);
  if (head.given.contains("classes")) {
    run.classes = FromJson<std::vector<std::string>>(head.given["classes"],
                                                     file.string() + ", given, classes");
  }
}

// By cluster: the body that holds most of its landmarks, not counting the static scene.
std::map<std::int64_t, std::int64_t> BodiesOfClusters(const OverlayRun& run) {
  std::map<std::int64_t, std::map<std::int64_t, int>> seen;
  for (const auto& [frame, landmarks] : run.landmarks) {
    for (const LabelledLandmark& landmark : landmarks) {
      if (landmark.label > kStaticLabel && landmark.truth_body > 0) {
        ++seen[landmark.label][landmark.truth_body];
      }
    }
  }
  std::map<std::int64_t, std::int64_t> bodies;
  for (const auto& [cluster, counts] : seen) {
    const auto most =
        std::max_element(counts.begin(), counts.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    bodies[cluster] = most->first;
  }
  return bodies;
}

using Rows = std::span<const ObjectRow>;

Rows RowsOfFrame(const std::vector<ObjectRow>& rows, int frame) {
  const auto first = std::ranges::lower_bound(rows, frame, {}, &ObjectRow::frame);
  const auto last = std::ranges::upper_bound(rows, frame, {}, &ObjectRow::frame);
  return {first, last};
}

double Seconds(const CameraFrame& from, const CameraFrame& to) {
  return 1e-9 * static_cast<double>(to.timestamp_ns - from.timestamp_ns);
}

// The positions in world, oldest first, of the point that is the cluster's centre in frame `index`,
// in the uninterrupted frames before it and in this one.
std::vector<Eigen::Vector3d> TailOf(const RunDetail& run, std::size_t index, const ObjectRow& row) {
  const Eigen::Vector3d center_in_object = row.object_from_box.translation();
  std::vector<Eigen::Vector3d> tail;
  for (std::size_t i = index + 1; i-- > 0;) {
    const Rows rows = RowsOfFrame(run.clusters, run.camera[i].frame);
    const ObjectRow* there = FindBy(rows, &ObjectRow::id, row.id);
    if (there == nullptr || Seconds(run.camera[i], run.camera[index]) > kTail_s + 1e-6) break;
    tail.push_back(there->WorldFromObject() * center_in_object);
  }
  std::reverse(tail.begin(), tail.end());
  return tail;
}

ClusterShape ShapeOf(const RunDetail& run, std::size_t index, const ObjectRow& row) {
  constexpr double kAhead_s = 0.5;
  constexpr double kLeastSpeed_m_s = 0.1;
  const RigidTransform camera_from_world =
      TransformOf(run.camera[index].world_from_camera).Inverse();
  const RigidTransform camera_from_box =
      camera_from_world * row.WorldFromObject() * row.object_from_box;
  ClusterShape shape;
  shape.id = row.id;
  shape.category = row.category;
  shape.predicted = row.predicted();
  for (unsigned i = 0; i < 8; ++i) {
    const Eigen::Vector3d side((i & 1U) != 0 ? 0.5 : -0.5, (i & 2U) != 0 ? 0.5 : -0.5,
                               (i & 4U) != 0 ? 0.5 : -0.5);
    shape.corners[i] = camera_from_box * side.cwiseProduct(row.size_m);
  }
  const std::vector<Eigen::Vector3d> tail = TailOf(run, index, row);
  for (const Eigen::Vector3d& p_in_world : tail) {
    shape.tail.push_back(camera_from_world * p_in_world);
  }
  const auto& velocity_m_s =
      row.refined_velocity_m_s ? row.refined_velocity_m_s : row.causal_velocity_m_s;
  if (velocity_m_s && velocity_m_s->norm() > kLeastSpeed_m_s) {
    shape.next = camera_from_world * (tail.back() + kAhead_s * *velocity_m_s);
  }
  return shape;
}

// A round distance ahead within which nine tenths of the clusters are.
double RangeOf(const RunDetail& run) {
  std::vector<double> ahead_m;
  for (const CameraFrame& camera : run.camera) {
    const RigidTransform camera_from_world = TransformOf(camera.world_from_camera).Inverse();
    for (const ObjectRow& row : RowsOfFrame(run.clusters, camera.frame)) {
      ahead_m.push_back((camera_from_world * row.WorldFromObject().translation()).z());
    }
  }
  if (ahead_m.empty()) return 10.0;
  std::ranges::sort(ahead_m);
  const double far_m = ahead_m[ahead_m.size() * 9 / 10];
  for (const double range_m : {2.0, 4.0, 6.0, 10.0, 20.0, 40.0, 60.0}) {
    if (range_m >= far_m) return range_m;
  }
  return 100.0;
}

}  // namespace

RigidTransform TransformOf(const Pose& pose) {
  return {Eigen::Quaterniond(pose[6], pose[3], pose[4], pose[5]),
          Eigen::Vector3d(pose[0], pose[1], pose[2])};
}

// Each colour is far from all others (CIE 1976 colour difference of at least 26) and from every
// grey. Consecutive ids differ most. Blue is lighter than usual, to be visible on dark images.
Rgb ClusterColor(std::int64_t id) {
  constexpr std::array<Rgb, 16> kColors = {{{230, 159, 0},
                                            {86, 180, 233},
                                            {0, 190, 130},
                                            {240, 228, 66},
                                            {235, 95, 20},
                                            {225, 130, 195},
                                            {60, 95, 250},
                                            {160, 240, 60},
                                            {170, 90, 240},
                                            {0, 230, 235},
                                            {255, 55, 105},
                                            {255, 195, 160},
                                            {175, 120, 75},
                                            {175, 255, 205},
                                            {195, 185, 255},
                                            {255, 80, 235}}};
  return kColors[(static_cast<std::uint64_t>(id) - 1U) % kColors.size()];
}

OverlayRun ReadOverlayRun(const fs::path& folder, LandmarkLabel label) {
  OverlayRun run;
  run.folder = fs::absolute(folder / "").parent_path().lexically_normal();
  run.detail = ReadRunDetail(folder);
  ReadHead(folder / "result.json", run);
  for (const std::string& line : run.detail.missing) {
    if (line.find("objects.csv") != std::string::npos) {
      run.missing.push_back("without clusters: " + line);
    }
  }
  const fs::path landmarks = folder / "landmarks.csv";
  try {
    if (!fs::exists(landmarks)) throw Error(landmarks.string() + ": no such file");
    run.landmarks = ReadLandmarks(landmarks, label);
  } catch (const Error& error) {
    run.missing.push_back(StrCat("without landmarks: ", error.what()));
  }
  MarkWrongLabels(run);
  run.range_m = RangeOf(run.detail);
  return run;
}

void MarkWrongLabels(OverlayRun& run) {
  if (run.detail.bodies.empty()) return;
  std::set<std::int64_t> movers;
  for (const BodyDetail& body : run.detail.bodies) {
    if (body.mover) movers.insert(body.id);
  }
  const std::map<std::int64_t, std::int64_t> bodies = BodiesOfClusters(run);
  for (auto& [frame, landmarks] : run.landmarks) {
    for (LabelledLandmark& landmark : landmarks) {
      if (landmark.truth_body < 0) continue;
      run.has_truth = true;
      const auto body = bodies.find(landmark.label);
      if (landmark.label > kStaticLabel) {
        landmark.wrong = body == bodies.end() || body->second != landmark.truth_body;
      } else if (landmark.label == kStaticLabel) {
        landmark.wrong = movers.contains(landmark.truth_body);
      }
    }
  }
}

OverlayFrame FrameOf(const OverlayRun& run, int frame) {
  const auto& camera = run.detail.camera;
  const auto found = std::ranges::lower_bound(camera, frame, {}, &CameraFrame::frame);
  if (found == camera.end() || found->frame != frame) {
    ThrowError(StrCat("frame ", frame), "none of this number in the run",
               camera.empty() ? "a run with frames"
                              : StrCat(camera.front().frame, " to ", camera.back().frame));
  }
  OverlayFrame drawn;
  drawn.frame = frame;
  drawn.time_s = Seconds(camera.front(), *found);
  drawn.status = found->status;
  drawn.run = StrCat(run.variant, ", seed ", run.seed);
  drawn.has_truth = run.has_truth;
  const auto of_frame = [frame](const auto& all, auto& drawn_there) {
    if (const auto there = all.find(frame); there != all.end()) drawn_there = there->second;
  };
  of_frame(run.landmarks, drawn.landmarks);
  of_frame(run.detections, drawn.detections);
  of_frame(run.truth, drawn.truth);
  drawn.range_m = run.range_m;
  const auto index = static_cast<std::size_t>(found - camera.begin());
  for (const ObjectRow& row : RowsOfFrame(run.detail.clusters, frame)) {
    drawn.clusters.push_back(ShapeOf(run.detail, index, row));
  }
  return drawn;
}

}  // namespace cvo::reports
