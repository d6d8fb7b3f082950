// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/overlays/drawing/project.h"
#include "reports/overlays/overlay_run.h"

namespace cvo::reports {
namespace {

using Rows = std::span<const ClusterRow>;

// Half the time span over which a velocity is computed.
constexpr double kVelocityHalf_s = 0.12;

Rows RowsOfFrame(const std::vector<ClusterRow>& rows, int frame) {
  const auto below = [](const ClusterRow& row, int number) { return row.frame < number; };
  const auto above = [](int number, const ClusterRow& row) { return number < row.frame; };
  const auto first = std::lower_bound(rows.begin(), rows.end(), frame, below);
  return {first, std::upper_bound(first, rows.end(), frame, above)};
}

Position CenterInObject(const ClusterRow& row) {
  return {row.object_from_box[0], row.object_from_box[1], row.object_from_box[2]};
}

double Seconds(const CameraFrame& from, const CameraFrame& to) {
  return 1e-9 * static_cast<double>(to.timestamp_ns - from.timestamp_ns);
}

// Follows one cluster through the frames before and after a given one.
class ClusterPath {
 public:
  ClusterPath(const OverlayRun& run, std::size_t index, const ClusterRow& row)
      : run_(run), index_(index), row_(row) {}

  // Position in world, `steps` frames away, of the point that is the centre of the cluster in the
  // given frame. Empty if the cluster is absent there.
  std::optional<Position> Center(std::ptrdiff_t steps) const {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(index_) + steps;
    const auto& camera = run_.detail.camera;
    if (at < 0 || at >= static_cast<std::ptrdiff_t>(camera.size())) return std::nullopt;
    const int frame = camera[static_cast<std::size_t>(at)].frame;
    const Rows rows = RowsOfFrame(run_.detail.clusters, frame);
    const ClusterRow* row = FindBy(rows, &ClusterRow::id, row_.id);
    if (row == nullptr) return std::nullopt;
    return Transform(row->world_from_object, CenterInObject(row_));
  }
  // Number of consecutive frames in which the cluster is present, up to `limit_s` away. It has the
  // sign of `step`, which is 1 or -1.
  std::ptrdiff_t Reach(std::ptrdiff_t step, double limit_s) const {
    const auto& camera = run_.detail.camera;
    std::ptrdiff_t steps = 0;
    while (Center(steps + step)) {
      const auto at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index_) + steps + step);
      if (std::abs(Seconds(camera[index_], camera[at])) > limit_s + 1e-6) break;
      steps += step;
    }
    return steps;
  }
  // Velocity of its centre in world, from its positions shortly before and after the given frame. A
  // predicted cluster, or one without such neighbours, has the velocity of the motion model.
  Position Velocity() const {
    if (row_.predicted) return row_.velocity_m_s;
    const std::ptrdiff_t before = Reach(-1, kVelocityHalf_s);
    const std::ptrdiff_t after = Reach(1, kVelocityHalf_s);
    if (before == after) return row_.velocity_m_s;
    const auto& camera = run_.detail.camera;
    const auto at = [&](std::ptrdiff_t steps) -> const CameraFrame& {
      return camera[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index_) + steps)];
    };
    const Position first = *Center(before);
    const Position last = *Center(after);
    Position velocity;
    for (std::size_t i = 0; i < 3; ++i) {
      velocity[i] = (last[i] - first[i]) / Seconds(at(before), at(after));
    }
    return velocity;
  }

 private:
  const OverlayRun& run_;
  std::size_t index_;
  const ClusterRow& row_;
};

ClusterShape ShapeOf(const OverlayRun& run, std::size_t index, const ClusterRow& row) {
  const Pose& world_from_camera = run.detail.camera[index].world_from_camera;
  const ClusterPath path(run, index, row);
  ClusterShape shape;
  shape.id = row.id;
  shape.category = row.category;
  shape.predicted = row.predicted;
  for (std::size_t i = 0; i < 8; ++i) {
    Position corner;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      corner[axis] = (((i >> axis) & 1U) != 0 ? 0.5 : -0.5) * row.size_m[axis];
    }
    shape.corners[i] =
        TransformBack(world_from_camera,
                      Transform(row.world_from_object, Transform(row.object_from_box, corner)));
  }
  const Position center = Transform(row.world_from_object, CenterInObject(row));
  const Position velocity = path.Velocity();
  Position ahead;
  for (std::size_t i = 0; i < 3; ++i) ahead[i] = center[i] + kAhead_s * velocity[i];
  shape.center = TransformBack(world_from_camera, center);
  shape.ahead = TransformBack(world_from_camera, ahead);
  for (std::ptrdiff_t steps = path.Reach(-1, kTrail_s); steps < 0; ++steps) {
    shape.trail.push_back(TransformBack(world_from_camera, *path.Center(steps)));
  }
  return shape;
}

}  // namespace

OverlayFrame FrameOf(const OverlayRun& run, int frame) {
  const auto& camera = run.detail.camera;
  const auto found =
      std::lower_bound(camera.begin(), camera.end(), frame,
                       [](const CameraFrame& entry, int number) { return entry.frame < number; });
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
  drawn.has_landmarks = run.has_landmarks;
  drawn.has_clusters = run.has_clusters;
  drawn.has_truth = run.has_truth;
  drawn.color_ids = run.color_ids;
  const auto landmarks = run.landmarks.find(frame);
  if (landmarks != run.landmarks.end()) drawn.landmarks = landmarks->second;
  const auto boxes = run.detections.find(frame);
  if (boxes != run.detections.end()) drawn.detections = boxes->second;
  const auto index = static_cast<std::size_t>(found - camera.begin());
  for (const ClusterRow& row : RowsOfFrame(run.detail.clusters, frame)) {
    drawn.clusters.push_back(ShapeOf(run, index, row));
  }
  return drawn;
}

}  // namespace cvo::reports
