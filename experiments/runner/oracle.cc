// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/oracle.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "core/association/box_association.h"
#include "core/base/error.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/scene_truth.h"

namespace cvo {
namespace {

// Returns boxes around the visible parts of bodies, as detectors draw them.
TrueBoxes SceneBoxes(const Sequence& sequence, const std::filesystem::path& table) {
  TrueBoxes boxes(sequence.images.size());
  const auto bodies = ReadSceneBodies(table, sequence.total_frames);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const SceneBody& body : bodies[i + static_cast<std::size_t>(sequence.first_frame)]) {
      if (!body.visible_box) continue;
      const ImageBox& box = *body.visible_box;
      boxes[i].push_back({body.id, {box.left_px, box.top_px, box.right_px, box.bottom_px}});
    }
  }
  return boxes;
}

TrueBoxes LabelBoxes(const Sequence& sequence, const BodyTruthReader& truth) {
  TrueBoxes boxes(sequence.images.size());
  for (const ObjectBox& label : sequence.labels) {
    const int body = truth.BodyOfTrack(label.track);
    if (body < 0) continue;
    boxes.at(static_cast<std::size_t>(label.frame - sequence.first_frame))
        .push_back({body, {label.left_px, label.top_px, label.right_px, label.bottom_px}});
  }
  return boxes;
}

void RequireBodies(const char* name, const BodyTruthReader* truth) {
  if (truth != nullptr) return;
  ThrowError("option --oracle",
             StrCat("\"", name, "\", but the sequence has no ground truth of bodies"),
             "a rendered scene, or labels with 3D boxes and ground truth of the camera");
}

}  // namespace

TrueBoxes BoxesOfBodies(const Sequence& sequence, const BodyTruthReader& truth) {
  const std::filesystem::path table = sequence.folder / "objects.csv";
  return std::filesystem::is_regular_file(table) ? SceneBoxes(sequence, table)
                                                 : LabelBoxes(sequence, truth);
}

std::vector<std::string> OracleSwitches::Names() const {
  std::vector<std::string> names;
  if (boxes) names.emplace_back("boxes");
  if (labels) names.emplace_back("labels");
  if (camera) names.emplace_back("camera");
  return names;
}

OracleSwitches ParseOracle(const std::string& text) {
  OracleSwitches switches;
  if (text == "none") return switches;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    if (name == "boxes") {
      switches.boxes = true;
    } else if (name == "labels") {
      switches.labels = true;
    } else if (name == "camera") {
      switches.camera = true;
    } else {
      ThrowError("option --oracle",
                 Quoted(name) + DidYouMean(name, {"boxes", "labels", "camera", "none"}),
                 "boxes, labels or camera, with commas between, or none");
    }
    begin = end + 1;
  }
  return switches;
}

std::vector<BodyId> BodiesOfDetections(const std::vector<Detection>& detections,
                                       const std::vector<std::pair<int, ImageBox>>& true_boxes) {
  constexpr double kMinOverlap = 0.5;
  Eigen::MatrixXd cost(detections.size(), true_boxes.size());
  for (std::size_t i = 0; i < detections.size(); ++i) {
    for (std::size_t k = 0; k < true_boxes.size(); ++k) {
      const double overlap = IntersectionOverUnion(detections[i].box, true_boxes[k].second);
      cost(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          overlap >= kMinOverlap ? 1.0 - overlap : std::numeric_limits<double>::infinity();
    }
  }
  std::vector<BodyId> bodies;
  for (const int column : Assign(cost)) {
    bodies.push_back(column < 0 ? BodyId()
                                : BodyId{true_boxes[static_cast<std::size_t>(column)].first});
  }
  return bodies;
}

std::vector<LandmarkTruth> TruthOfFeatures(int frame, const std::vector<StereoFeature>& features,
                                           const StereoCamera& camera, BodyTruthReader& truth) {
  std::vector<LandmarkTruth> bodies;
  bodies.reserve(features.size());
  for (const StereoFeature& feature : features) {
    const auto p_in_camera = camera.BackProject(feature.z_px);
    bodies.push_back(p_in_camera ? truth.Find(frame, feature.z_px.head<2>(), *p_in_camera)
                                 : LandmarkTruth{});
  }
  return bodies;
}

Oracle::Oracle(const Sequence& sequence, const OracleSwitches& switches,
               const BodyTruthReader* truth)
    : switches_(switches) {
  if (switches.labels) RequireBodies("labels", truth);
  if (switches.boxes) {
    RequireBodies("boxes", truth);
    boxes_ = BoxesOfBodies(sequence, *truth);
  }
  if (!switches.camera) return;
  const auto& world_from_camera = sequence.groundtruth_world_from_camera;
  if (world_from_camera.empty() || !world_from_camera.front()) {
    ThrowError("option --oracle",
               "\"camera\", but the sequence has no ground truth of the camera in its first frame",
               "ground truth of the camera from the first frame on");
  }
  const RigidTransform first_from_world = world_from_camera.front()->Inverse();
  for (const auto& pose : world_from_camera) {
    first_from_camera_.push_back(pose ? std::optional(first_from_world * *pose) : std::nullopt);
  }
}

void Oracle::Give(int frame_index, const std::vector<LandmarkTruth>& feature_truth,
                  StereoFrame& frame) const {
  const auto i = static_cast<std::size_t>(frame_index);
  if (switches_.boxes) {
    frame.given.detection_body = BodiesOfDetections(frame.detections, boxes_.at(i));
  }
  if (switches_.labels) {
    Require(feature_truth.size() == frame.features.size(), "Oracle: truth for every feature");
    for (const LandmarkTruth& truth : feature_truth) {
      frame.given.feature_body.push_back(BodyId{truth.body});
    }
  }
  if (switches_.camera) frame.given.world_from_camera = first_from_camera_.at(i);
}

}  // namespace cvo
