// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// The bodies of a rendered scene, from objects.csv and the masks in instance_0.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "experiments/datasets/body_truth_parts.h"
#include "experiments/datasets/scene_truth.h"

namespace cvo {
namespace {

constexpr int kMinVisible_px = 400;
constexpr double kMinVisibleFraction = 0.3;
// Corners lie up to this far from the edge they stem from, on either side of it.
constexpr int kEdge_px = 2;

ObjectTruth MakeTruth(const Sequence& sequence, const std::vector<std::vector<SceneBody>>& bodies) {
  ObjectTruth truth = TruthWithoutBodies(sequence);
  truth.contract.truth = reports::TruthSource::kScene;
  truth.contract.visible =
      reports::Visibility{reports::VisibleBy::kMask, kMinVisible_px,
                          static_cast<int>(std::lround(100.0 * kMinVisibleFraction))};
  truth.mover_travel_m = kIndoorTravel_m;
  for (std::size_t i = 0; i < bodies.front().size(); ++i) {
    const SceneBody& first = bodies.front()[i];
    if (IsTraffic(first.category)) truth.mover_travel_m = kOutdoorTravel_m;
    TruthBody body;
    body.id = first.id;
    body.name = first.name;
    body.category = first.category;
    body.diagonal_m = first.size_m.norm();
    for (std::size_t k = 0; k < truth.frame_count(); ++k) {
      const SceneBody& now = bodies[k + static_cast<std::size_t>(sequence.first_frame)][i];
      const bool visible =
          now.visible_px >= kMinVisible_px && now.visible_fraction >= kMinVisibleFraction;
      body.frames.push_back(BodyFrame{now.world_from_object, visible});
    }
    truth.bodies.push_back(std::move(body));
  }
  FinishTruth(truth);
  return truth;
}

class SceneBodyTruth final : public BodyTruthReader {
 public:
  SceneBodyTruth(const Sequence& sequence, const std::vector<std::vector<SceneBody>>& bodies)
      : masks_(sequence.folder / "instance_0"),
        size_px_(sequence.camera.width_px, sequence.camera.height_px),
        truth_(MakeTruth(sequence, bodies)) {
    for (const SceneBody& body : bodies.front()) half_sizes_m_.push_back(0.5 * body.size_m);
  }

  const ObjectTruth& objects() const override { return truth_; }

  int BodyOfTrack(int track) const override {
    return FindBody(truth_, track) == nullptr ? -1 : track;
  }

  LandmarkTruth Find(int frame, const Eigen::Vector2d& left_px,
                     const Eigen::Vector3d& p_in_camera) override {
    const std::size_t k = CheckedFrame(truth_, frame);
    LoadMask(frame);
    const int id = BodyAt(left_px);
    if (id <= 0) return {static_cast<std::int16_t>(id), PointMotion::kStill};
    const TruthBody* body = FindBody(truth_, id);
    if (body == nullptr || !truth_.world_from_camera[k]) return {};
    const RigidTransform object_from_camera =
        body->frames[k]->world_from_object.Inverse() * *truth_.world_from_camera[k];
    // A wrong match puts the point far from the body, where a turn would move it far.
    const Eigen::Vector3d half_m = half_sizes_m_[static_cast<std::size_t>(id) - 1];
    const Eigen::Vector3d p_in_object =
        (object_from_camera * p_in_camera).cwiseMax(-half_m).cwiseMin(half_m);
    return TruthOnBody(truth_, id, frame, p_in_object);
  }

 private:
  void LoadMask(int frame) {
    if (frame == mask_frame_) return;
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "%06d.png", truth_.first_frame + frame);
    mask_ = ReadInstances(masks_ / name.data(), size_px_);
    mask_frame_ = frame;
  }

  // -1 outside the image and near the edge of a mask.
  int BodyAt(const Eigen::Vector2d& left_px) const {
    if (!left_px.allFinite() || left_px.cwiseAbs().maxCoeff() > 1e6) return -1;
    const int u = static_cast<int>(std::lround(left_px.x()));
    const int v = static_cast<int>(std::lround(left_px.y()));
    if (u < 0 || v < 0 || u >= mask_.cols || v >= mask_.rows) return -1;
    const std::uint16_t id = mask_.at<std::uint16_t>(v, u);
    for (int y = std::max(0, v - kEdge_px); y <= std::min(mask_.rows - 1, v + kEdge_px); ++y) {
      for (int x = std::max(0, u - kEdge_px); x <= std::min(mask_.cols - 1, u + kEdge_px); ++x) {
        if (mask_.at<std::uint16_t>(y, x) != id) return -1;
      }
    }
    return id;
  }

  std::filesystem::path masks_;
  cv::Size size_px_;
  ObjectTruth truth_;
  std::vector<Eigen::Vector3d> half_sizes_m_;  // [id - 1]
  cv::Mat mask_;
  int mask_frame_ = -1;
};

}  // namespace

std::unique_ptr<BodyTruthReader> ReadSceneBodyTruth(const Sequence& sequence) {
  const std::filesystem::path path = sequence.folder / "objects.csv";
  const auto bodies = ReadSceneBodies(path, sequence.total_frames);
  if (bodies.front().size() > static_cast<std::size_t>(std::numeric_limits<std::int16_t>::max())) {
    ThrowError(path.string(), StrCat(bodies.front().size(), " bodies"), "at most 32767");
  }
  return std::make_unique<SceneBodyTruth>(sequence, bodies);
}

}  // namespace cvo
