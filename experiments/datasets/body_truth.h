// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>

#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_estimate.h"

namespace cvo {

// The bodies of a sequence: where they are, and which of them a pixel shows.
class BodyTruthReader {
 public:
  virtual ~BodyTruthReader() = default;

  virtual const ObjectTruth& objects() const = 0;

  // The body with this track id in labels and detections; -1: none.
  virtual int BodyOfTrack(int track) const = 0;

  // What is at a pixel of the left image and at the point (left camera, m) that stereo puts there.
  // Frames in increasing order are fast: one mask is in memory. Throws Error for a frame outside
  // the sequence or a mask that cannot be read.
  virtual LandmarkTruth Find(int frame, const Eigen::Vector2d& left_px,
                             const Eigen::Vector3d& p_in_camera) = 0;
};

// From objects.csv and the instance masks of a rendered scene, else from Sequence::bodies, else
// from labels with tracks and 3D boxes and the camera's truth; nullptr where the sequence has
// neither. Outdoors, where a mover travels 2 m: KITTI's sequences, and scenes with a body of one of
// KITTI's categories of traffic. Throws Error for files that contradict each other.
std::unique_ptr<BodyTruthReader> ReadBodyTruth(const Sequence& sequence);

}  // namespace cvo
