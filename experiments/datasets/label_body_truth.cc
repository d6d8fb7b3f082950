// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// Bodies from KITTI tracking labels. A body's frame has its origin at the centre of its box, x
// along its length, y down, z along its width.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/error.h"
#include "experiments/datasets/body_truth.h"

namespace cvo {
namespace {

constexpr int kMaxOcclusion = 1;
constexpr double kMinHeight_px = 25.0;

// Track ids start at 0, body ids at 1.
int BodyOf(int track) { return track + 1; }

// The box of a body in one frame.
struct LabelBox {
  int body = 0;
  RigidTransform object_from_camera;
  Eigen::Vector3d half_m = Eigen::Vector3d::Zero();
};

LabelBox MakeBox(const ObjectBox& label, double left_offset_m) {
  const ObjectBox::Box3d& box = *label.box3d;
  const Eigen::Vector3d center =
      box.bottom_in_camera + Eigen::Vector3d(left_offset_m, -0.5 * box.height_m, 0.0);
  const RigidTransform camera_from_object(ExpSo3(box.heading_rad * Eigen::Vector3d::UnitY()),
                                          center);
  return {BodyOf(label.track), camera_from_object.Inverse(),
          0.5 * Eigen::Vector3d(box.length_m, box.height_m, box.width_m)};
}

bool IsBody(const ObjectBox& label) { return label.track >= 0 && label.box3d.has_value(); }

// Whether the line segment from `from` to `to` intersects the box.
bool Meets(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& low,
           const Eigen::Vector3d& high) {
  double enter = 0.0;
  double leave = 1.0;
  for (int i = 0; i < 3; ++i) {
    const double step = to[i] - from[i];
    if (step == 0.0) {
      if (from[i] < low[i] || from[i] > high[i]) return false;
      continue;
    }
    const double a = (low[i] - from[i]) / step;
    const double b = (high[i] - from[i]) / step;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

// Tolerances for a point on a box. The point's disparity may be wrong, which moves it along its
// ray, and so may be the sides of the box.
struct Slack {
  double disparity_px;
  double side_m;
  double bottom_m;  // negative: points just above the road belong to the road
};
constexpr Slack kOnBody = {0.5, 0.1, -0.15};
constexpr Slack kNearBody = {1.5, 0.4, 0.1};

bool IsAt(const LabelBox& box, const StereoCamera& camera, const Eigen::Vector3d& p_in_camera,
          const Slack& slack) {
  // Limits how many times farther away than measured a point may be, as an error of its disparity
  // may move it to infinity.
  constexpr double kFarthest = 10.0;
  const double disparity_px = camera.fx * camera.baseline_m / p_in_camera.z();
  const double nearer = disparity_px / (disparity_px + slack.disparity_px);
  const double farther =
      disparity_px > slack.disparity_px
          ? std::min(kFarthest, disparity_px / (disparity_px - slack.disparity_px))
          : kFarthest;
  Eigen::Vector3d high = box.half_m.array() + slack.side_m;
  const Eigen::Vector3d low = -high;
  high.y() = box.half_m.y() + slack.bottom_m;
  return Meets(box.object_from_camera * Eigen::Vector3d(nearer * p_in_camera),
               box.object_from_camera * Eigen::Vector3d(farther * p_in_camera), low, high);
}

class LabelBodyTruth final : public BodyTruthReader {
 public:
  explicit LabelBodyTruth(const Sequence& sequence);

  const ObjectTruth& objects() const override { return truth_; }

  int BodyOfTrack(int track) const override {
    return track < 0 || FindBody(truth_, BodyOf(track)) == nullptr ? -1 : BodyOf(track);
  }

  LandmarkTruth Find(int frame, const Eigen::Vector2d& left_px,
                     const Eigen::Vector3d& p_in_camera) override;

 private:
  void AddLabel(const ObjectBox& label, const Sequence& sequence);
  bool IsInDontCare(std::size_t frame, const Eigen::Vector2d& left_px) const;

  StereoCamera camera_;
  ObjectTruth truth_;
  std::map<int, TruthBody> bodies_;                 // only used while reading
  std::vector<std::vector<LabelBox>> boxes_;        // [frame]
  std::vector<std::vector<ObjectBox>> dont_cares_;  // [frame]
};

void LabelBodyTruth::AddLabel(const ObjectBox& label, const Sequence& sequence) {
  const auto frame = static_cast<std::size_t>(label.frame - sequence.first_frame);
  if (!IsBody(label)) {
    dont_cares_.at(frame).push_back(label);
    return;
  }
  if (label.track >= std::numeric_limits<std::int16_t>::max()) {
    ThrowError("labels", StrCat("track ", label.track), "a number below 32767");
  }
  const LabelBox box = MakeBox(label, sequence.left_offset_m);
  boxes_.at(frame).push_back(box);
  TruthBody& body = bodies_[box.body];
  if (body.id == 0) {
    body.id = box.body;
    body.name = StrCat("track ", label.track);
    body.category = label.type;
    body.frames.resize(truth_.frame_count());
  }
  body.diagonal_m = std::max(body.diagonal_m, 2.0 * box.half_m.norm());
  const auto& world_from_camera = truth_.world_from_camera[frame];
  if (!world_from_camera) return;
  if (body.frames[frame]) {
    ThrowError("labels", StrCat("two boxes of track ", label.track, " in frame ", label.frame),
               "one");
  }
  const bool visible = label.occlusion >= 0 && label.occlusion <= kMaxOcclusion &&
                       label.bottom_px - label.top_px >= kMinHeight_px;
  body.frames[frame] = BodyFrame{*world_from_camera * box.object_from_camera.Inverse(), visible};
}

LabelBodyTruth::LabelBodyTruth(const Sequence& sequence)
    : camera_(sequence.camera), truth_(TruthWithoutBodies(sequence)) {
  truth_.contract.truth = reports::TruthSource::kLabels;
  truth_.contract.camera_truth = EnumOf<reports::TruthSource>(sequence.groundtruth);
  truth_.contract.visible = reports::Visibility{
      reports::VisibleBy::kLabel, static_cast<int>(std::lround(kMinHeight_px)), kMaxOcclusion};
  truth_.mover_travel_m = kOutdoorTravel_m;
  truth_.movers_alone_move = true;
  boxes_.resize(truth_.frame_count());
  dont_cares_.resize(truth_.frame_count());
  for (const ObjectBox& label : sequence.labels) AddLabel(label, sequence);
  for (auto& [id, body] : bodies_) truth_.bodies.push_back(std::move(body));
  bodies_.clear();
  FinishTruth(truth_);
}

LandmarkTruth LabelBodyTruth::Find(int frame, const Eigen::Vector2d& left_px,
                                   const Eigen::Vector3d& p_in_camera) {
  const std::size_t k = CheckedFrame(truth_, frame);
  if (!left_px.allFinite() || !p_in_camera.allFinite() || !(p_in_camera.z() > 0.0)) return {};
  const LabelBox* on = nullptr;
  bool near = false;
  for (const LabelBox& box : boxes_[k]) {
    if (IsAt(box, camera_, p_in_camera, kOnBody)) {
      if (on != nullptr) return {};  // on two bodies
      on = &box;
    } else if (IsAt(box, camera_, p_in_camera, kNearBody)) {
      near = true;
    }
  }
  if (on != nullptr) {
    const Eigen::Vector3d p_in_object = on->object_from_camera * p_in_camera;
    return TruthOnBody(truth_, on->body, frame,
                       p_in_object.cwiseMax(-on->half_m).cwiseMin(on->half_m));
  }
  if (near || IsInDontCare(k, left_px)) return {};
  return {0, PointMotion::kStill};
}

bool LabelBodyTruth::IsInDontCare(std::size_t frame, const Eigen::Vector2d& left_px) const {
  // These boxes are in pixels of image_02, which beyond 10 m differ by at most this much from those
  // of image_00.
  constexpr double kShift_px = 5.0;
  const auto& boxes = dont_cares_[frame];
  return std::any_of(boxes.begin(), boxes.end(), [&](const ObjectBox& box) {
    return left_px.x() >= box.left_px - kShift_px && left_px.x() <= box.right_px + kShift_px &&
           left_px.y() >= box.top_px - kShift_px && left_px.y() <= box.bottom_px + kShift_px;
  });
}

}  // namespace

std::unique_ptr<BodyTruthReader> ReadLabelBodyTruth(const Sequence& sequence) {
  const auto& poses = sequence.groundtruth_world_from_camera;
  const bool has_camera =
      std::any_of(poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); });
  const bool has_bodies = std::any_of(sequence.labels.begin(), sequence.labels.end(), IsBody);
  if (!has_camera || !has_bodies) return nullptr;
  return std::make_unique<LabelBodyTruth>(sequence);
}

}  // namespace cvo
