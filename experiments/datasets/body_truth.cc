// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/body_truth.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/error.h"
#include "experiments/datasets/body_truth_parts.h"

namespace cvo {

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

}  // namespace cvo
