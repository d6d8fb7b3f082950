// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/objects/object_truth.h"

#include <algorithm>

#include "core/base/error.h"

namespace cvo {
namespace {

void CheckBody(const ObjectTruth& truth, const TruthBody& body) {
  if (body.frames.size() != truth.frame_count()) {
    ThrowError(StrCat("truth of body ", body.id), StrCat(body.frames.size(), " frames"),
               StrCat(truth.frame_count(), ", as many as timestamps"));
  }
  for (std::size_t k = 0; k < body.frames.size(); ++k) {
    if (!body.frames[k] || body.frames[k]->world_from_object.Matrix().allFinite()) continue;
    ThrowError(StrCat("truth of body ", body.id, ", frame ", k), "a pose that is not finite",
               "finite numbers");
  }
}

// Whether the point was more than kMovedPoint_m away from p_in_world in one of the frames [begin,
// end).
bool HasMoved(const TruthBody& body, int begin, int end, const Eigen::Vector3d& p_in_object,
              const Eigen::Vector3d& p_in_world) {
  for (int k = end - 1; k >= begin; --k) {
    const auto& frame = body.frames[static_cast<std::size_t>(k)];
    if (!frame) continue;
    if ((frame->world_from_object * p_in_object - p_in_world).norm() > kMovedPoint_m) return true;
  }
  return false;
}

}  // namespace

const TruthBody* FindBody(const ObjectTruth& truth, int id) {
  const auto body = std::lower_bound(truth.bodies.begin(), truth.bodies.end(), id,
                                     [](const TruthBody& b, int value) { return b.id < value; });
  return body == truth.bodies.end() || body->id != id ? nullptr : &*body;
}

double FarthestApart_m(const std::vector<std::optional<BodyFrame>>& frames) {
  std::vector<Eigen::Vector3d> positions;
  for (const auto& frame : frames) {
    if (frame) positions.emplace_back(frame->world_from_object.translation());
  }
  double farthest_m = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      farthest_m = std::max(farthest_m, (positions[i] - positions[j]).norm());
    }
  }
  return farthest_m;
}

void FinishTruth(ObjectTruth& truth) {
  if (truth.world_from_camera.size() != truth.frame_count()) {
    ThrowError("truth of the camera", StrCat(truth.world_from_camera.size(), " frames"),
               StrCat(truth.frame_count(), ", as many as timestamps"));
  }
  int last = 0;
  for (TruthBody& body : truth.bodies) {
    if (body.id <= last) {
      ThrowError("truth of the bodies", StrCat("body ", body.id, " after body ", last),
                 "ids that increase from 1 on");
    }
    last = body.id;
    CheckBody(truth, body);
    body.travel_m = FarthestApart_m(body.frames);
    body.mover = body.travel_m > truth.mover_travel_m;
  }
}

std::optional<Eigen::Vector3d> PointVelocity(const ObjectTruth& truth, const TruthBody& body,
                                             int frame, const Eigen::Vector3d& p_in_object) {
  const int last = static_cast<int>(body.frames.size()) - 1;
  Require(frame >= 0 && frame <= last, "PointVelocity: no such frame");
  const auto has = [&](int k) {
    return k >= 0 && k <= last && body.frames[static_cast<std::size_t>(k)].has_value();
  };
  const int before = has(frame - 1) ? frame - 1 : frame;
  const int after = has(frame + 1) ? frame + 1 : frame;
  if (before == after || !has(frame)) return std::nullopt;
  const auto position = [&](int k) {
    return Eigen::Vector3d(body.frames[static_cast<std::size_t>(k)]->world_from_object *
                           p_in_object);
  };
  const double time_s =
      1e-9 * static_cast<double>(truth.timestamps_ns[static_cast<std::size_t>(after)] -
                                 truth.timestamps_ns[static_cast<std::size_t>(before)]);
  return (position(after) - position(before)) / time_s;
}

PointMotion MotionOfPoint(const ObjectTruth& truth, const TruthBody& body, int frame,
                          const Eigen::Vector3d& p_in_object) {
  if (truth.movers_alone_move && !body.mover) return PointMotion::kStill;
  const auto& now = body.frames.at(static_cast<std::size_t>(frame));
  if (!now) return PointMotion::kStill;
  const Eigen::Vector3d p_in_world = now->world_from_object * p_in_object;
  const int recent = std::max(0, frame - kMovedFrames);
  if (HasMoved(body, recent, frame, p_in_object, p_in_world)) return PointMotion::kMoving;
  if (HasMoved(body, 0, recent, p_in_object, p_in_world)) return PointMotion::kStopped;
  return PointMotion::kStill;
}

}  // namespace cvo
