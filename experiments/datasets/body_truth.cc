// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Bodies with known poses, and with a mask, labelled pixels or neither.

#include "experiments/datasets/body_truth.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <opencv2/core.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json_record.h"
#include "experiments/datasets/formats/scene_truth.h"

namespace cvo {
namespace {

// Corners lie up to this far from the edge that causes them, on either side of it.
constexpr int kEdge_px = 2;
// A pixel shows what the labelled pixels within this distance show, if they agree.
constexpr double kNearLabel_px = 3.0;

ObjectTruth TruthOf(const Sequence& sequence, const BodyTracks& tracks) {
  ObjectTruth truth = TruthWithoutBodies(sequence);
  truth.contract.truth = tracks.truth;
  truth.contract.visible = tracks.visible;
  truth.mover_travel_m = tracks.mover_travel_m;
  truth.tells_pixels = tracks.mask || !tracks.pixels.empty();
  const auto first = static_cast<std::ptrdiff_t>(sequence.first_frame);
  for (const BodyTrack& track : tracks.bodies) {
    if (track.id > std::numeric_limits<std::int16_t>::max()) {
      ThrowError(sequence.folder.string(), StrCat("body ", track.id), "ids of at most 32767");
    }
    const auto begin = track.frames.begin() + first;
    TruthBody body;
    body.id = track.id;
    body.name = track.name;
    body.category = track.category;
    body.diagonal_m = track.size_m.norm();
    body.frames = {begin, begin + static_cast<std::ptrdiff_t>(truth.frame_count())};
    truth.bodies.push_back(std::move(body));
  }
  FinishTruth(truth);
  return truth;
}

// Returns -1 outside the image and near the edge of a mask.
int BodyAt(const cv::Mat& mask, const Eigen::Vector2d& left_px) {
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
int BodyAt(const std::vector<LabelledPixel>& pixels, const Eigen::Vector2d& left_px) {
  int body = -1;
  for (const LabelledPixel& pixel : pixels) {
    if (!((pixel.at_px - left_px).norm() <= kNearLabel_px)) continue;
    if (body >= 0 && body != pixel.body) return -1;
    body = pixel.body;
  }
  return body;
}

class TrackBodyTruth final : public BodyTruthReader {
 public:
  TrackBodyTruth(const Sequence& sequence, BodyTracks tracks)
      : truth_(TruthOf(sequence, tracks)), tracks_(std::move(tracks)) {}

  const ObjectTruth& objects() const override { return truth_; }

  int BodyOfTrack(int track) const override {
    for (const BodyTrack& body : tracks_.bodies) {
      if (track >= 0 && body.track == track) return body.id;
    }
    return -1;
  }

  LandmarkTruth Find(int frame, const Eigen::Vector2d& left_px,
                     const Eigen::Vector3d& p_in_camera) override {
    const std::size_t k = CheckedFrame(truth_, frame);
    const int id = Look(frame, left_px);
    if (id <= 0) return {static_cast<std::int16_t>(id), PointMotion::kStill};
    const TruthBody* body = FindBody(truth_, id);
    if (body == nullptr || !body->frames[k] || !truth_.world_from_camera[k]) return {};
    const RigidTransform object_from_camera =
        body->frames[k]->world_from_object.Inverse() * *truth_.world_from_camera[k];
    // A wrong match puts the point far from the body, where a rotation would move it by a large
    // distance.
    const Eigen::Vector3d half_m = HalfSize_m(id);
    const Eigen::Vector3d p_in_object =
        (object_from_camera * p_in_camera).cwiseMax(-half_m).cwiseMin(half_m);
    return TruthOnBody(truth_, id, frame, p_in_object);
  }

 private:
  int Look(int frame, const Eigen::Vector2d& left_px) {
    const int in_folder = truth_.first_frame + frame;
    if (tracks_.mask) {
      if (frame != mask_frame_) mask_ = tracks_.mask(in_folder);
      mask_frame_ = frame;
      return BodyAt(mask_, left_px);
    }
    if (tracks_.pixels.empty()) return -1;
    return BodyAt(tracks_.pixels.at(static_cast<std::size_t>(in_folder)), left_px);
  }

  Eigen::Vector3d HalfSize_m(int id) const {
    return 0.5 * FindBy(tracks_.bodies, &BodyTrack::id, id)->size_m;
  }

  ObjectTruth truth_;
  BodyTracks tracks_;
  cv::Mat mask_;
  int mask_frame_ = -1;
};

// How the rendered right camera differs from the calibration, as the scene's manifest tells.
struct RightCameraError {
  double shift_px = 0.0;                 // of the principal point
  std::array<double, 3> rotation_deg{};  // about its x, y, z axes
  double focal = 0.0;                    // relative

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("shift_px", self.shift_px);
    archive.Field("rotation_deg", self.rotation_deg);
    archive.Field("focal", self.focal);
  }
};

RightCameraError ReadRightCameraError(const std::filesystem::path& manifest) {
  const Json json = ReadJson(manifest);
  if (!json.is_object() || !json.contains("rig_error")) return {};
  return FromJson<RightCameraError>(json.at("rig_error"), manifest.string() + ", rig_error");
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

bool IsTraffic(const std::string& category) {
  constexpr std::array<std::string_view, 8> kTraffic = {
      "Car", "Van", "Truck", "Tram", "Pedestrian", "Person", "Person_sitting", "Cyclist"};
  return std::find(kTraffic.begin(), kTraffic.end(), category) != kTraffic.end();
}

ObjectTruth TruthWithoutBodies(const Sequence& sequence) {
  ObjectTruth truth;
  truth.first_frame = sequence.first_frame;
  truth.timestamps_ns = sequence.timestamps_ns;
  truth.world_from_camera = sequence.groundtruth_world_from_camera;
  return truth;
}

LandmarkTruth TruthOnBody(const ObjectTruth& truth, int id, int frame,
                          const Eigen::Vector3d& p_in_object) {
  const TruthBody* body = FindBody(truth, id);
  if (body == nullptr || !body->frames[CheckedFrame(truth, frame)]) return {};
  return {static_cast<std::int16_t>(id), MotionOfPoint(truth, *body, frame, p_in_object)};
}

std::size_t CheckedFrame(const ObjectTruth& truth, int frame) {
  if (frame < 0 || static_cast<std::size_t>(frame) >= truth.frame_count()) {
    ThrowError("truth of a landmark", StrCat("frame ", frame),
               StrCat("one of the ", truth.frame_count(), " frames of the sequence"));
  }
  return static_cast<std::size_t>(frame);
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
  tracks.truth = reports::TruthSource::kScene;
  tracks.visible = {reports::VisibleBy::kMask, kMinVisible_px,
                    static_cast<int>(std::lround(100.0 * kMinVisibleFraction))};
  tracks.mover_travel_m = kIndoorTravel_m;
  for (std::size_t i = 0; i < rows.front().size(); ++i) {
    const SceneBody& first = rows.front()[i];
    if (IsTraffic(first.category)) tracks.mover_travel_m = kOutdoorTravel_m;
    BodyTrack body{first.id, first.id, first.name, first.category, first.size_m, {}};
    for (const std::vector<SceneBody>& frame : rows) {
      const SceneBody& now = frame[i];
      const bool visible =
          now.visible_px >= kMinVisible_px && now.visible_fraction >= kMinVisibleFraction;
      body.frames.push_back(BodyFrame{now.world_from_object, visible});
    }
    tracks.bodies.push_back(std::move(body));
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
  return std::make_unique<TrackBodyTruth>(sequence, std::move(tracks));
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
