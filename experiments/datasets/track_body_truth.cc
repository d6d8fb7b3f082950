// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// Bodies with known poses, and with a mask, labelled pixels or neither.

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/datasets/body_truth_parts.h"

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

}  // namespace

std::unique_ptr<BodyTruthReader> MakeTrackBodyTruth(const Sequence& sequence, BodyTracks tracks) {
  return std::make_unique<TrackBodyTruth>(sequence, std::move(tracks));
}

}  // namespace cvo
