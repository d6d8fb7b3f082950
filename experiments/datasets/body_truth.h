// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_matching.h"

namespace cvo {

// What a pixel shows: the id of a body and the point in the body's frame, clamped to its box. Body
// 0 is the static scene; -1: unknown.
struct SeenBody {
  int body = -1;
  Eigen::Vector3d p_in_object = Eigen::Vector3d::Zero();
};

// Ground truth of the bodies of a sequence: their poses, and which body a pixel shows.
class BodyTruthReader {
 public:
  // What a pixel of the left image shows, given the point (left camera, m) that stereo triangulates
  // there. `frame` counts from Sequence::first_frame.
  using Look =
      std::function<SeenBody(const ObjectTruth& objects, std::size_t frame,
                             const Eigen::Vector2d& left_px, const Eigen::Vector3d& p_in_camera)>;
  BodyTruthReader(ObjectTruth objects, Look look);

  const ObjectTruth& objects() const { return objects_; }

  // Returns the id of the body with this track id in labels and detections, or -1 if there is none.
  int BodyOfTrack(int track) const;

  // Returns the truth of what a pixel shows; unknown if the frame has no pose of the body. Frames
  // in increasing order are fast, as one mask is kept in memory. Throws Error for a frame outside
  // the sequence or a mask that cannot be read.
  LandmarkTruth Find(int frame, const Eigen::Vector2d& left_px, const Eigen::Vector3d& p_in_camera);

 private:
  ObjectTruth objects_;
  Look look_;
};

// Reads the ground truth of the bodies from objects.csv and the instance masks of a rendered scene,
// else from Sequence::bodies, else from labels with tracks and 3D boxes together with the camera's
// ground truth. Returns nullptr if the sequence has none of these. The distance beyond which a body
// is a mover is 2 m outdoors (for labels, and for scenes with a body of one of KITTI's traffic
// categories), 0.2 m in other scenes, and that of Sequence::bodies if they are used. Throws Error
// for files that contradict each other.
std::unique_ptr<BodyTruthReader> ReadBodyTruth(const Sequence& sequence);

// Reads the bodies of a rendered scene.
BodyTracks ReadSceneBodyTracks(const Sequence& sequence);
std::unique_ptr<BodyTruthReader> MakeTrackBodyTruth(const Sequence& sequence, BodyTracks tracks);

constexpr double kIndoorTravel_m = 0.2;
constexpr double kOutdoorTravel_m = 2.0;

// What StereoCamera::right_field_px should be found for a rendered scene: the best fit, over the
// whole image, to the disparity error that the scene's right camera gives points far away. The
// camera's right_shift_px, which is known, is not part of it. Empty if the sequence is not a
// rendered scene, or is perturbed.
std::optional<Vector6d> TrueRightField(const Sequence& sequence);

}  // namespace cvo
