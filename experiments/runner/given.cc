// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/given.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <utility>

#include "core/association/box_association.h"
#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/object_boxes.h"
#include "experiments/datasets/formats/scene_truth.h"

namespace cvo {

namespace {

std::string Lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool Contains(const std::vector<std::string>& classes, const std::string& type) {
  return std::any_of(classes.begin(), classes.end(),
                     [&](const std::string& name) { return Lower(name) == Lower(type); });
}

// Moves a box by the disparity of what it shows. A box without depth stays where it is, like that
// of something far away. An edge at the image border is not an edge of the body, and stays too, so
// that the box still counts as truncated.
ImageBox MoveBox(const ObjectBox& box, const BoxCamera& camera,
                 const std::vector<StereoFeature>& features, DetectionCounts& counts) {
  const ImageBox drawn = {box.left_px, box.top_px, box.right_px, box.bottom_px};
  if (camera.offset_m == 0.0) return drawn;
  const double depth_m = DepthInBox(box, camera, features);
  if (depth_m == 0.0) {
    ++counts.without_depth;
    return drawn;
  }
  const ObjectBox moved = ShiftBox(box, camera.offset_m, camera.left.fx, depth_m);
  constexpr double kAtBorder_px = 2.0;  // detectors end boxes a pixel or two before the border
  const double last_u_px = camera.left.width_px - 1;
  return {drawn.left_px <= kAtBorder_px ? drawn.left_px : moved.left_px, moved.top_px,
          drawn.right_px >= last_u_px - kAtBorder_px ? drawn.right_px : moved.right_px,
          moved.bottom_px};
}

}  // namespace

std::vector<std::string> RigidClasses() { return {kRigidClasses.begin(), kRigidClasses.end()}; }

std::vector<std::string> KnownClasses() {
  std::vector<std::string> names = RigidClasses();
  for (const char* other : {"Pedestrian", "Person_sitting", "Cyclist", "Misc", "Person", "Bicycle",
                            "Motorcycle", "DontCare"}) {
    names.emplace_back(other);
  }
  return names;
}

std::vector<std::string> ParseClasses(const std::string& text) {
  std::vector<std::string> classes = AtCommas(text);
  for (const std::string& name : classes) {
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
    });
    if (!name.empty() && plain) continue;
    ThrowError("option --classes", Quoted(text), "names with commas between, as Car,Van");
  }
  return classes;
}

void CheckClasses(const std::vector<std::string>& classes, const std::vector<ObjectBox>& boxes) {
  std::vector<std::string> known = KnownClasses();
  for (const ObjectBox& box : boxes) AddOnce(box.type, known);
  for (const std::string& name : classes) {
    const std::string meant = DidYouMean(name, known);
    if (meant.empty() || Contains(known, name)) continue;
    ThrowError("option --classes", Quoted(name) + meant, "classes of the detections");
  }
}

double DepthInBox(const ObjectBox& box, const BoxCamera& camera,
                  const std::vector<StereoFeature>& features) {
  constexpr std::size_t kMinDepths = 3;
  constexpr double kModeWidth = 1.15;     // farthest to nearest depth: a car 5 m long at 30 m
  constexpr double kDenseFraction = 0.5;  // fraction of the densest mode; less is clutter in front
  std::vector<double> depths_m;
  for (const StereoFeature& feature : features) {
    const double disparity_px = camera.left.Disparity(feature.z_px);
    if (disparity_px <= 0.0) continue;
    const double drawn_u_px =
        feature.z_px[0] + camera.offset_m / camera.left.baseline_m * disparity_px;
    const ImageBox drawn = {box.left_px, box.top_px, box.right_px, box.bottom_px};
    if (!drawn.Contains(drawn_u_px, feature.z_px[1])) continue;
    depths_m.push_back(camera.left.fx * camera.left.baseline_m / disparity_px);
  }
  if (depths_m.size() < kMinDepths) return 0.0;
  std::sort(depths_m.begin(), depths_m.end());
  const auto end_of_mode = [&](std::size_t first) {
    return static_cast<std::size_t>(
        std::upper_bound(depths_m.begin(), depths_m.end(), kModeWidth * depths_m[first]) -
        depths_m.begin());
  };
  std::size_t densest = 0;
  for (std::size_t i = 0; i < depths_m.size(); ++i) densest = std::max(densest, end_of_mode(i) - i);
  std::size_t first = 0;
  while (static_cast<double>(end_of_mode(first) - first) <
         kDenseFraction * static_cast<double>(densest)) {
    ++first;
  }
  return depths_m[(first + end_of_mode(first) - 1) / 2];
}

std::vector<Detection> DetectionsOfFrame(const std::vector<ObjectBox>& boxes,
                                         const BoxCamera& camera,
                                         const std::vector<StereoFeature>& features,
                                         const std::vector<std::string>& classes,
                                         DetectionCounts& counts) {
  std::vector<Detection> detections;
  for (const ObjectBox& box : boxes) {
    if (!Contains(classes, box.type)) {
      ++counts.other_classes[box.type];
      continue;
    }
    const auto clipped = ClipToImage(MoveBox(box, camera, features, counts), camera.left);
    if (!clipped) {
      ++counts.outside;
      continue;
    }
    ++counts.given;
    detections.push_back({*clipped, box.type, box.score.value_or(1.0)});
  }
  return detections;
}

std::vector<std::vector<ObjectBox>> DetectionsByFrame(const Sequence& sequence) {
  std::vector<std::vector<ObjectBox>> frames(sequence.images.size());
  for (const ObjectBox& box : sequence.detections) {
    frames.at(static_cast<std::size_t>(box.frame - sequence.first_frame)).push_back(box);
  }
  return frames;
}

std::vector<std::vector<cv::Rect2d>> BoxesByFrame(const Sequence& sequence) {
  std::vector<std::vector<cv::Rect2d>> frames;
  for (const std::vector<ObjectBox>& drawn : DetectionsByFrame(sequence)) {
    std::vector<cv::Rect2d>& boxes = frames.emplace_back();
    for (const ObjectBox& box : drawn) {
      boxes.emplace_back(box.left_px, box.top_px, box.right_px - box.left_px,
                         box.bottom_px - box.top_px);
    }
  }
  return frames;
}

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

OracleSwitches OracleOf(const std::vector<std::string>& names) {
  OracleSwitches switches;
  for (const std::string& name : names) {
    bool* const known = name == "boxes"    ? &switches.boxes
                        : name == "labels" ? &switches.labels
                        : name == "camera" ? &switches.camera
                                           : nullptr;
    if (known == nullptr) {
      ThrowError("option --oracle",
                 Quoted(name) + DidYouMean(name, {"boxes", "labels", "camera", "none"}),
                 "boxes, labels or camera, with commas between, or none");
    }
    *known = true;
  }
  return switches;
}

OracleSwitches ParseOracle(const std::string& text) {
  return text == "none" ? OracleSwitches() : OracleOf(AtCommas(text));
}

std::vector<std::string> AtCommas(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
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
