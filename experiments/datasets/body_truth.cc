// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include "experiments/datasets/body_truth.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <opencv2/core.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json_record.h"
#include "experiments/datasets/formats/scene_truth.h"

namespace cvo {
namespace {

// Returns the truth with the frames of the sequence.
ObjectTruth WithFrames(const Sequence& sequence, ObjectTruth truth) {
  truth.first_frame = sequence.first_frame;
  truth.timestamps_ns = sequence.timestamps_ns;
  truth.world_from_camera = sequence.groundtruth_world_from_camera;
  return truth;
}

// Bodies with known poses, and with a mask, labelled pixels or neither.

// Corners lie up to this far from the edge that causes them, on either side of it.
constexpr int kEdge_px = 2;
// A pixel shows what the labelled pixels within this distance show, if they agree.
constexpr double kNearLabel_px = 3.0;

// Returns -1 outside the image and near the edge of a mask.
int BodyInMask(const cv::Mat& mask, const Eigen::Vector2d& left_px) {
  if (!left_px.allFinite() || left_px.cwiseAbs().maxCoeff() > 1e6) return -1;
  const int u = static_cast<int>(std::lround(left_px.x()));
  const int v = static_cast<int>(std::lround(left_px.y()));
  if (u < 0 || v < 0 || u >= mask.cols || v >= mask.rows) return -1;
  const std::uint16_t id = mask.at<std::uint16_t>(v, u);
  for (int y = std::max(0, v - kEdge_px); y <= std::min(mask.rows - 1, v + kEdge_px); ++y) {
    for (int x = std::max(0, u - kEdge_px); x <= std::min(mask.cols - 1, u + kEdge_px); ++x) {
      if (mask.at<std::uint16_t>(y, x) != id) return -1;
    }
  }
  return id;
}

// Returns -1 if no labelled pixel is near, or if two are of different bodies.
int BodyNear(const std::vector<LabelledPixel>& pixels, const Eigen::Vector2d& left_px) {
  int body = -1;
  for (const LabelledPixel& pixel : pixels) {
    if (!((pixel.at_px - left_px).norm() <= kNearLabel_px)) continue;
    if (body >= 0 && body != pixel.body) return -1;
    body = pixel.body;
  }
  return body;
}

class TrackLook {
 public:
  explicit TrackLook(BodyTracks tracks)
      : mask_of_(std::move(tracks.mask)), pixels_(std::move(tracks.pixels)) {}

  SeenBody operator()(const ObjectTruth& truth, std::size_t frame, const Eigen::Vector2d& left_px,
                      const Eigen::Vector3d& p_in_camera) {
    SeenBody seen{BodyAt(truth.first_frame + static_cast<int>(frame), left_px), {}};
    const TruthBody* body = FindBody(truth, seen.body);
    if (seen.body <= 0 || body == nullptr) return seen;
    if (!body->frames[frame] || !truth.world_from_camera[frame]) return {};
    const RigidTransform object_from_camera =
        body->frames[frame]->world_from_object.Inverse() * *truth.world_from_camera[frame];
    // A wrong match puts the point far from the body, where a rotation would move it by a large
    // distance.
    const Eigen::Vector3d half_m = 0.5 * body->size_m;
    seen.p_in_object = (object_from_camera * p_in_camera).cwiseMax(-half_m).cwiseMin(half_m);
    return seen;
  }

 private:
  int BodyAt(int frame, const Eigen::Vector2d& left_px) {
    if (mask_of_) {
      if (frame != mask_frame_) mask_ = mask_of_(frame);
      mask_frame_ = frame;
      return BodyInMask(mask_, left_px);
    }
    return pixels_.empty() ? -1 : BodyNear(pixels_.at(static_cast<std::size_t>(frame)), left_px);
  }

  std::function<cv::Mat(int frame)> mask_of_;
  std::vector<std::vector<LabelledPixel>> pixels_;
  cv::Mat mask_;
  int mask_frame_ = -1;
};

// Bodies from KITTI tracking labels. A body's frame has its origin at the centre of its box, x
// along its length, y down, z along its width.

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

// Finds the box that holds a point.
struct LabelLook {
  StereoCamera camera;
  std::vector<std::vector<LabelBox>> boxes;        // [frame]
  std::vector<std::vector<ObjectBox>> dont_cares;  // [frame]

  SeenBody operator()(const ObjectTruth&, std::size_t frame, const Eigen::Vector2d& left_px,
                      const Eigen::Vector3d& p_in_camera) const {
    if (!left_px.allFinite() || !p_in_camera.allFinite() || !(p_in_camera.z() > 0.0)) return {};
    const LabelBox* on = nullptr;
    bool near = false;
    for (const LabelBox& box : boxes[frame]) {
      if (IsAt(box, camera, p_in_camera, kOnBody)) {
        if (on != nullptr) return {};  // on two bodies
        on = &box;
      } else if (IsAt(box, camera, p_in_camera, kNearBody)) {
        near = true;
      }
    }
    if (on != nullptr) {
      const Eigen::Vector3d p_in_object = on->object_from_camera * p_in_camera;
      return {on->body, p_in_object.cwiseMax(-on->half_m).cwiseMin(on->half_m)};
    }
    if (near || IsInDontCare(frame, left_px)) return {};
    return {0, {}};
  }

  bool IsInDontCare(std::size_t frame, const Eigen::Vector2d& left_px) const {
    // These boxes are in pixels of image_02, which beyond 10 m differ by at most this much from
    // those of image_00.
    constexpr double kShift_px = 5.0;
    return std::any_of(
        dont_cares[frame].begin(), dont_cares[frame].end(), [&](const ObjectBox& box) {
          return left_px.x() >= box.left_px - kShift_px &&
                 left_px.x() <= box.right_px + kShift_px && left_px.y() >= box.top_px - kShift_px &&
                 left_px.y() <= box.bottom_px + kShift_px;
        });
  }
};

// Adds the body of a label in one frame, of the sequence.
void AddBox(const ObjectBox& label, const LabelBox& box, std::size_t frame,
            const ObjectTruth& truth, TruthBody& body) {
  if (body.id == 0) {
    body.id = box.body;
    body.track = label.track;
    body.name = StrCat("track ", label.track);
    body.category = label.type;
    body.frames.resize(truth.frame_count());
  }
  if (2.0 * box.half_m.norm() > body.size_m.norm()) body.size_m = 2.0 * box.half_m;
  const auto& world_from_camera = truth.world_from_camera[frame];
  if (!world_from_camera) return;
  const bool visible = label.occlusion >= 0 && label.occlusion <= kMaxOcclusion &&
                       label.bottom_px - label.top_px >= kMinHeight_px;
  body.frames[frame] = BodyFrame{*world_from_camera * box.object_from_camera.Inverse(), visible};
}

// Returns nullptr unless there are boxes of bodies and poses of the camera.
std::unique_ptr<BodyTruthReader> ReadLabelBodyTruth(const Sequence& sequence) {
  const auto& poses = sequence.groundtruth_world_from_camera;
  const bool has_camera =
      std::any_of(poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); });
  const bool has_bodies = std::any_of(sequence.labels.begin(), sequence.labels.end(), IsBody);
  if (!has_camera || !has_bodies) return nullptr;
  ObjectTruth truth = WithFrames(sequence, {});
  truth.contract.truth = reports::TruthSource::kLabels;
  truth.contract.camera_truth = EnumOf<reports::TruthSource>(sequence.groundtruth);
  truth.contract.visible = reports::Visibility{
      reports::VisibleBy::kLabel, static_cast<int>(std::lround(kMinHeight_px)), kMaxOcclusion};
  truth.mover_travel_m = kOutdoorTravel_m;
  truth.movers_alone_move = true;
  LabelLook look{sequence.camera, {}, {}};
  look.boxes.resize(truth.frame_count());
  look.dont_cares.resize(truth.frame_count());
  std::map<int, TruthBody> bodies;
  for (const ObjectBox& label : sequence.labels) {
    const auto frame = static_cast<std::size_t>(label.frame - sequence.first_frame);
    if (!IsBody(label)) {
      look.dont_cares.at(frame).push_back(label);
      continue;
    }
    look.boxes.at(frame).push_back(MakeBox(label, sequence.left_offset_m));
    const LabelBox& box = look.boxes[frame].back();
    AddBox(label, box, frame, truth, bodies[box.body]);
  }
  for (auto& [id, body] : bodies) truth.bodies.push_back(std::move(body));
  return std::make_unique<BodyTruthReader>(std::move(truth), std::move(look));
}

// Whether `category` is one of KITTI's traffic categories.
bool IsTraffic(const std::string& category) {
  constexpr std::array<std::string_view, 8> kTraffic = {
      "Car", "Van", "Truck", "Tram", "Pedestrian", "Person", "Person_sitting", "Cyclist"};
  return std::find(kTraffic.begin(), kTraffic.end(), category) != kTraffic.end();
}

// Returns how much further right a far point of the left image is in the right one than in a
// perfect pair, px.
double RightShiftOf(const RightCameraError& error, const StereoCamera& camera, double u, double v) {
  const Eigen::Vector3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
  const Eigen::Vector3d turn =
      Eigen::Vector3d(error.rotation_deg.data()) * std::numbers::pi / 180.0;
  const Eigen::Vector3d in_right = ExpSo3(turn).conjugate() * ray;
  const double u_right = camera.fx * (1.0 + error.focal) * in_right.x() / in_right.z() + camera.cx;
  return u_right + error.shift_px - u;
}

}  // namespace

BodyTruthReader::BodyTruthReader(ObjectTruth objects, Look look)
    : objects_(std::move(objects)), look_(std::move(look)) {
  for (const TruthBody& body : objects_.bodies) {
    if (body.id <= std::numeric_limits<std::int16_t>::max()) continue;
    ThrowError("ground truth", StrCat("body ", body.id), "ids of at most 32767");
  }
  FinishTruth(objects_);
}

int BodyTruthReader::BodyOfTrack(int track) const {
  const TruthBody* body = track < 0 ? nullptr : FindBy(objects_.bodies, &TruthBody::track, track);
  return body == nullptr ? -1 : body->id;
}

LandmarkTruth BodyTruthReader::Find(int frame, const Eigen::Vector2d& left_px,
                                    const Eigen::Vector3d& p_in_camera) {
  if (frame < 0 || static_cast<std::size_t>(frame) >= objects_.frame_count()) {
    ThrowError("truth of a landmark", StrCat("frame ", frame),
               StrCat("one of the ", objects_.frame_count(), " frames of the sequence"));
  }
  const auto k = static_cast<std::size_t>(frame);
  const SeenBody seen = look_(objects_, k, left_px, p_in_camera);
  const auto id = static_cast<std::int16_t>(seen.body);
  if (seen.body <= 0) return {id, PointMotion::kStill};
  const TruthBody* body = FindBody(objects_, seen.body);
  if (body == nullptr || !body->frames[k]) return {};
  return {id, MotionOfPoint(objects_, *body, frame, seen.p_in_object)};
}

std::unique_ptr<BodyTruthReader> ReadBodyTruth(const Sequence& sequence) {
  if (std::filesystem::is_regular_file(sequence.folder / "objects.csv")) {
    return MakeTrackBodyTruth(sequence, ReadSceneBodyTracks(sequence));
  }
  if (sequence.bodies) return MakeTrackBodyTruth(sequence, *sequence.bodies);
  return ReadLabelBodyTruth(sequence);
}

BodyTracks ReadSceneBodyTracks(const Sequence& sequence) {
  constexpr int kMinVisible_px = 400;
  constexpr double kMinVisibleFraction = 0.3;
  const auto rows = ReadSceneBodies(sequence.folder / "objects.csv", sequence.total_frames);
  BodyTracks tracks;
  tracks.objects.contract.truth = reports::TruthSource::kScene;
  tracks.objects.contract.visible =
      reports::Visibility{reports::VisibleBy::kMask, kMinVisible_px,
                          static_cast<int>(std::lround(100.0 * kMinVisibleFraction))};
  tracks.objects.mover_travel_m = kIndoorTravel_m;
  for (std::size_t i = 0; i < rows.front().size(); ++i) {
    const SceneBody& first = rows.front()[i];
    if (IsTraffic(first.category)) tracks.objects.mover_travel_m = kOutdoorTravel_m;
    TruthBody body{first.id, first.id, first.name, first.category, first.size_m, {}};
    for (const std::vector<SceneBody>& frame : rows) {
      const SceneBody& now = frame[i];
      const bool visible =
          now.visible_px >= kMinVisible_px && now.visible_fraction >= kMinVisibleFraction;
      body.frames.push_back(BodyFrame{now.world_from_object, visible});
    }
    tracks.objects.bodies.push_back(std::move(body));
  }
  tracks.mask = [folder = sequence.folder / "instance_0",
                 size_px =
                     cv::Size(sequence.camera.width_px, sequence.camera.height_px)](int frame) {
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "%06d.png", frame);
    return ReadInstances(folder / name.data(), size_px);
  };
  return tracks;
}

std::unique_ptr<BodyTruthReader> MakeTrackBodyTruth(const Sequence& sequence, BodyTracks tracks) {
  ObjectTruth truth = WithFrames(sequence, std::move(tracks.objects));
  truth.tells_pixels = tracks.mask || !tracks.pixels.empty();
  for (TruthBody& body : truth.bodies) {
    const auto begin = body.frames.begin() + sequence.first_frame;
    body.frames = {begin, begin + static_cast<std::ptrdiff_t>(truth.frame_count())};
  }
  return std::make_unique<BodyTruthReader>(std::move(truth), TrackLook(std::move(tracks)));
}

std::optional<Vector6d> TrueRightField(const Sequence& sequence) {
  constexpr int kSteps = 20;
  const std::filesystem::path manifest = sequence.folder / "manifest.json";
  if (!std::filesystem::is_regular_file(manifest) ||
      !std::filesystem::is_regular_file(sequence.folder / "objects.csv") ||
      !PerturbationToJson(sequence.perturbation).empty()) {
    return std::nullopt;
  }
  const RightCameraError error = ReadRightCameraError(manifest);
  const StereoCamera& camera = sequence.camera;
  Matrix6d information = Matrix6d::Zero();
  Vector6d weighted = Vector6d::Zero();
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double u = static_cast<double>(i) / kSteps * (camera.width_px - 1);
      const double v = static_cast<double>(j) / kSteps * (camera.height_px - 1);
      const Vector6d basis = camera.BasisAt(u, v).value;
      information += basis * basis.transpose();
      weighted += basis * (RightShiftOf(error, camera, u, v) - camera.right_shift_px);
    }
  }
  return information.llt().solve(weighted);
}

}  // namespace cvo
