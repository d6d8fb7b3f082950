// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/objects/object_matching.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/association/box_association.h"
#include "core/base/error.h"

namespace cvo {

namespace {

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
  Require(truth.world_from_camera.size() == truth.frame_count(),
          "FinishTruth: as many poses of the camera as timestamps");
  int last = 0;
  for (TruthBody& body : truth.bodies) {
    Require(body.id > last, "FinishTruth: ids that increase from 1 on");
    Require(body.frames.size() == truth.frame_count(), "FinishTruth: a body in all frames");
    last = body.id;
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

void CheckEstimate(const ObjectTruth& truth, const ObjectEstimate& estimate) {
  Require(estimate.world_from_camera.size() == truth.frame_count() &&
              estimate.landmarks.size() == truth.frame_count(),
          "CheckEstimate: as many frames as the truth");
  std::int64_t last = estimate.match_by == MatchBy::kLandmarks ? 0 : -1;
  for (const ClusterEstimate& cluster : estimate.clusters) {
    Require(cluster.id > last, "CheckEstimate: ids of clusters that increase");
    last = cluster.id;
    int frame = -1;
    for (const ClusterFrame& at : cluster.frames) {
      Require(at.frame > frame && static_cast<std::size_t>(at.frame) < truth.frame_count(),
              "CheckEstimate: frames of a cluster that increase");
      frame = at.frame;
    }
  }
}

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

template <typename Item>
std::size_t IndexOf(const std::vector<Item>& items, std::int64_t id) {
  const auto item =
      std::lower_bound(items.begin(), items.end(), id,
                       [](const Item& i, std::int64_t value) { return i.id < value; });
  return item == items.end() || item->id != id ? kNone
                                               : static_cast<std::size_t>(item - items.begin());
}

// Number of landmarks of a cluster observed on a body.
struct Overlap {
  int body = 0;
  std::int64_t cluster = 0;
  int landmarks = 0;
};

// Sorted by body, then by cluster.
std::vector<Overlap> FrameOverlaps(const std::vector<LandmarkObservation>& landmarks) {
  std::map<std::pair<int, std::int64_t>, int> counts;
  for (const LandmarkObservation& landmark : landmarks) {
    if (landmark.truth.body < 1 || landmark.cluster < 1) continue;
    counts[{landmark.truth.body, landmark.cluster}] += landmark.count;
  }
  std::vector<Overlap> overlaps;
  for (const auto& [pair, count] : counts) overlaps.push_back({pair.first, pair.second, count});
  return overlaps;
}

// Number of landmarks in a frame shared by each body and each cluster, as indexed in the lists.
Eigen::MatrixXd LandmarksInFrame(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                 std::size_t frame) {
  Eigen::MatrixXd shared =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(truth.bodies.size()),
                            static_cast<Eigen::Index>(estimate.clusters.size()));
  for (const Overlap& overlap : FrameOverlaps(estimate.landmarks[frame])) {
    const std::size_t body = IndexOf(truth.bodies, overlap.body);
    const std::size_t cluster = IndexOf(estimate.clusters, overlap.cluster);
    if (body == kNone || cluster == kNone) continue;
    shared(static_cast<Eigen::Index>(body), static_cast<Eigen::Index>(cluster)) = overlap.landmarks;
  }
  return shared;
}

// Returns [body]: the index of its cluster, or -1. A pair that shares nothing has zero cost. If
// such pairs were forbidden, the assignment would sacrifice shared landmarks to form more pairs.
std::vector<int> AssignMostShared(const Eigen::MatrixXd& shared) {
  std::vector<int> clusters = Assign(-shared);
  for (std::size_t body = 0; body < clusters.size(); ++body) {
    int& cluster = clusters[body];
    if (cluster >= 0 && shared(static_cast<Eigen::Index>(body), cluster) == 0.0) cluster = -1;
  }
  return clusters;
}

// Returns -1 if no cluster has enough landmarks.
std::int64_t BestCluster(const std::vector<Overlap>& overlaps, int body, std::int64_t last) {
  const Overlap* best = nullptr;
  for (const Overlap& overlap : overlaps) {
    if (overlap.body != body || overlap.landmarks < kMinObservedLandmarks) continue;
    const bool better = best == nullptr || overlap.landmarks > best->landmarks ||
                        (overlap.landmarks == best->landmarks && overlap.cluster == last);
    if (better) best = &overlap;
  }
  return best == nullptr ? -1 : best->cluster;
}

// State of a body up to the current frame.
struct Track {
  std::int64_t cluster = -1;  // its last cluster
  bool interrupted = false;   // without a cluster since then, in a visible frame

  void Add(std::int64_t best, Continuity& continuity) {
    if (best == -1) {
      interrupted = cluster != -1;
      return;
    }
    if (cluster != -1 && best != cluster) ++continuity.id_switches;
    if (interrupted) ++continuity.fragments;
    cluster = best;
    interrupted = false;
  }
};

// Returns [body]: the id of its cluster in the frame, -1 if it has none.
std::vector<std::int64_t> ClustersInFrame(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                          std::size_t frame, const std::vector<Track>& tracks) {
  std::vector<std::int64_t> clusters(truth.bodies.size(), -1);
  if (estimate.match_by == MatchBy::kLandmarks) {
    const std::vector<Overlap> overlaps = FrameOverlaps(estimate.landmarks[frame]);
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      clusters[i] = BestCluster(overlaps, truth.bodies[i].id, tracks[i].cluster);
    }
    return clusters;
  }
  if (clusters.empty() || estimate.clusters.empty()) return clusters;
  const std::vector<int> assigned = AssignMostShared(NearnessInFrame(truth, estimate, frame));
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    if (assigned[i] >= 0) clusters[i] = estimate.clusters[static_cast<std::size_t>(assigned[i])].id;
  }
  return clusters;
}

// Returns nullptr if the cluster is not in the frame.
const ClusterFrame* FindFrame(const ClusterEstimate& cluster, std::size_t frame) {
  const auto found = std::lower_bound(
      cluster.frames.begin(), cluster.frames.end(), static_cast<int>(frame),
      [](const ClusterFrame& candidate, int value) { return candidate.frame < value; });
  return found == cluster.frames.end() || found->frame != static_cast<int>(frame) ? nullptr
                                                                                  : &*found;
}

// Positions of the bodies in the camera frame; empty for a body without a box or a pose in the
// frame.
std::vector<std::optional<Eigen::Vector3d>> BodiesInCamera(const ObjectTruth& truth,
                                                           std::size_t frame) {
  const RigidTransform camera_from_world = truth.world_from_camera[frame]->Inverse();
  std::vector<std::optional<Eigen::Vector3d>> centers(truth.bodies.size());
  for (std::size_t b = 0; b < centers.size(); ++b) {
    const TruthBody& body = truth.bodies[b];
    if (!body.frames[frame] || body.diagonal_m <= 0.0) continue;
    centers[b] = camera_from_world * body.frames[frame]->world_from_object.translation();
  }
  return centers;
}

}  // namespace

std::vector<ObjectMatch> MatchObjects(const ObjectTruth& truth, const ObjectEstimate& estimate) {
  if (truth.bodies.empty() || estimate.clusters.empty()) return {};
  Eigen::MatrixXd shared =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(truth.bodies.size()),
                            static_cast<Eigen::Index>(estimate.clusters.size()));
  for (std::size_t k = 0; k < estimate.landmarks.size(); ++k) {
    shared += estimate.match_by == MatchBy::kLandmarks ? LandmarksInFrame(truth, estimate, k)
                                                       : NearnessInFrame(truth, estimate, k);
  }
  const std::vector<int> assigned = AssignMostShared(shared);
  std::vector<ObjectMatch> matches;
  for (std::size_t body = 0; body < assigned.size(); ++body) {
    if (assigned[body] < 0) continue;
    matches.push_back({body, static_cast<std::size_t>(assigned[body]),
                       shared(static_cast<Eigen::Index>(body), assigned[body])});
  }
  return matches;
}

std::vector<Continuity> MeasureContinuity(const ObjectTruth& truth,
                                          const ObjectEstimate& estimate) {
  std::vector<Continuity> continuity(truth.bodies.size());
  std::vector<Track> tracks(truth.bodies.size());
  for (std::size_t k = 0; k < estimate.landmarks.size(); ++k) {
    const std::vector<std::int64_t> clusters = ClustersInFrame(truth, estimate, k, tracks);
    for (std::size_t i = 0; i < truth.bodies.size(); ++i) {
      const auto& frame = truth.bodies[i].frames.at(k);
      if (frame && frame->visible) tracks[i].Add(clusters[i], continuity[i]);
    }
  }
  return continuity;
}

Eigen::MatrixXd NearnessInFrame(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                std::size_t frame) {
  Eigen::MatrixXd nearness =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(truth.bodies.size()),
                            static_cast<Eigen::Index>(estimate.clusters.size()));
  if (!truth.world_from_camera[frame] || !estimate.world_from_camera[frame]) return nearness;
  const auto bodies = BodiesInCamera(truth, frame);
  const RigidTransform camera_from_world = estimate.world_from_camera[frame]->Inverse();
  for (std::size_t c = 0; c < estimate.clusters.size(); ++c) {
    const ClusterFrame* cluster = FindFrame(estimate.clusters[c], frame);
    if (cluster == nullptr) continue;
    const Eigen::Vector3d center =
        camera_from_world * (cluster->world_from_object * cluster->point_in_object);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (!bodies[b]) continue;
      nearness(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(c)) =
          std::max(0.0, 1.0 - (center - *bodies[b]).norm() / truth.bodies[b].diagonal_m);
    }
  }
  return nearness;
}

}  // namespace cvo
