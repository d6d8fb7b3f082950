// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shared by the readers of true bodies and ReadBodyTruth; not for use elsewhere.

#include <memory>
#include <string>

#include "experiments/datasets/body_truth.h"

namespace cvo {

// Reads the bodies of a rendered scene.
BodyTracks ReadSceneBodyTracks(const Sequence& sequence);
std::unique_ptr<BodyTruthReader> MakeTrackBodyTruth(const Sequence& sequence, BodyTracks tracks);
std::unique_ptr<BodyTruthReader> ReadLabelBodyTruth(const Sequence& sequence);

constexpr double kIndoorTravel_m = 0.2;
constexpr double kOutdoorTravel_m = 2.0;

// Whether `category` is one of KITTI's traffic categories.
bool IsTraffic(const std::string& category);

// Returns the timestamps and camera poses of the sequence, without any bodies.
ObjectTruth TruthWithoutBodies(const Sequence& sequence);

// Returns the truth of a landmark on body `id`, given its point in the body's frame, clamped to the
// body's box. Unknown if the frame has no pose of the body.
LandmarkTruth TruthOnBody(const ObjectTruth& truth, int id, int frame,
                          const Eigen::Vector3d& p_in_object);

// Returns the frame as an index. Throws Error if the truth does not have this frame.
std::size_t CheckedFrame(const ObjectTruth& truth, int frame);

}  // namespace cvo
