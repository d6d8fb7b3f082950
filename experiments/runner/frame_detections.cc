// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/frame_detections.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "core/association/box_association.h"
#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/object_boxes.h"

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
  std::vector<std::string> classes;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    classes.push_back(text.substr(begin, end - begin));
    const bool plain = std::all_of(classes.back().begin(), classes.back().end(), [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
    });
    if (classes.back().empty() || !plain) {
      ThrowError("option --classes", Quoted(text), "names with commas between, as Car,Van");
    }
    begin = end + 1;
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

}  // namespace cvo
