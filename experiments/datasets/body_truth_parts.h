// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the readers of true bodies share: between them and ReadBodyTruth, not for others.

#include <memory>
#include <string>

#include "experiments/datasets/body_truth.h"

namespace cvo {

// Of a rendered scene.
BodyTracks ReadSceneBodyTracks(const Sequence& sequence);
std::unique_ptr<BodyTruthReader> MakeTrackBodyTruth(const Sequence& sequence, BodyTracks tracks);
std::unique_ptr<BodyTruthReader> ReadLabelBodyTruth(const Sequence& sequence);

constexpr double kIndoorTravel_m = 0.2;
constexpr double kOutdoorTravel_m = 2.0;

// Whether it is one of KITTI's categories of traffic.
bool IsTraffic(const std::string& category);

// Times and camera of the sequence; no bodies yet.
ObjectTruth TruthWithoutBodies(const Sequence& sequence);

// What is true of a landmark on a body, its point within the body's box in the body's frame: not
// known where the frame has no pose of the body.
LandmarkTruth TruthOnBody(const ObjectTruth& truth, int id, int frame,
                          const Eigen::Vector3d& p_in_object);

// The frame as an index. Throws Error unless the truth has it.
std::size_t CheckedFrame(const ObjectTruth& truth, int frame);

}  // namespace cvo
