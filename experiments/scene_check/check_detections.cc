// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "experiments/datasets/formats/object_boxes.h"
#include "experiments/scene_check/checks.h"
#include "experiments/scene_check/limits.h"

namespace cvo {
namespace {

// The bodies in view, which are those with a visible box: [frame].
using VisibleBoxes = std::vector<std::vector<const SceneBody*>>;

VisibleBoxes FindVisible(const SceneFolder& scene) {
  VisibleBoxes visible;
  for (const std::vector<SceneBody>& bodies : scene.bodies) {
    visible.emplace_back();
    for (const SceneBody& body : bodies) {
      if (body.visible_box) visible.back().push_back(&body);
    }
  }
  return visible;
}

std::vector<std::vector<ObjectBox>> ByFrame(const std::vector<ObjectBox>& boxes, int frames) {
  std::vector<std::vector<ObjectBox>> by_frame(static_cast<std::size_t>(frames));
  for (const ObjectBox& box : boxes) by_frame[static_cast<std::size_t>(box.frame)].push_back(box);
  return by_frame;
}

// Intersection over union in pixels: a box around one pixel has an area of 1.
double Overlap(const TruthBox& a, const ObjectBox& b) {
  const auto area = [](double left, double top, double right, double bottom) {
    return std::max(0.0, right - left + 1.0) * std::max(0.0, bottom - top + 1.0);
  };
  const double both = area(std::max(a.left_px, b.left_px), std::max(a.top_px, b.top_px),
                           std::min(a.right_px, b.right_px), std::min(a.bottom_px, b.bottom_px));
  const double either = area(a.left_px, a.top_px, a.right_px, a.bottom_px) +
                        area(b.left_px, b.top_px, b.right_px, b.bottom_px) - both;
  return either > 0.0 ? both / either : 0.0;
}

bool IsSameBox(const SceneBody& body, const ObjectBox& box) {
  const TruthBox& visible = *body.visible_box;
  return body.category == box.type &&
         std::abs(visible.left_px - box.left_px) <= limits::kBoxText_px &&
         std::abs(visible.top_px - box.top_px) <= limits::kBoxText_px &&
         std::abs(visible.right_px - box.right_px) <= limits::kBoxText_px &&
         std::abs(visible.bottom_px - box.bottom_px) <= limits::kBoxText_px;
}

// Counts rows that are no body's visible box, and bodies in view without a row. A wrong row in
// place of a right one counts once.
SceneCheck CheckOracle(const VisibleBoxes& visible,
                       const std::vector<std::vector<ObjectBox>>& boxes) {
  int wrong = 0;
  std::string first;
  for (std::size_t frame = 0; frame < visible.size(); ++frame) {
    std::vector<ObjectBox> left = boxes[frame];
    std::size_t absent = 0;
    for (const SceneBody* body : visible[frame]) {
      const auto found = std::find_if(left.begin(), left.end(),
                                      [&](const ObjectBox& box) { return IsSameBox(*body, box); });
      if (found == left.end()) {
        ++absent;
      } else {
        left.erase(found);
      }
    }
    const std::size_t faults = std::max(absent, left.size());
    if (faults > 0 && wrong == 0) first = StrCat("frame ", frame);
    wrong += static_cast<int>(faults);
  }
  return {"oracle_boxes_wrong", static_cast<double>(wrong), "boxes", Bound::kAtMost, 0.0, first};
}

// Bodies with fewer visible pixels do not count for recall: no detector finds them.
constexpr int kMinPixels = 400;

// Matches boxes to bodies greedily within each frame, by an overlap of at least one half, whatever
// their class.
std::vector<SceneCheck> Describe(const std::string& level, const VisibleBoxes& visible,
                                 const std::vector<std::vector<ObjectBox>>& boxes) {
  constexpr double kFound = 0.5;
  double bodies = 0.0, found = 0.0, overlap_sum = 0.0, surplus = 0.0;
  for (std::size_t frame = 0; frame < visible.size(); ++frame) {
    std::vector<ObjectBox> left = boxes[frame];
    for (const SceneBody* body : visible[frame]) {
      const auto best =
          std::max_element(left.begin(), left.end(), [&](const ObjectBox& a, const ObjectBox& b) {
            return Overlap(*body->visible_box, a) < Overlap(*body->visible_box, b);
          });
      const double overlap = best == left.end() ? 0.0 : Overlap(*body->visible_box, *best);
      const bool hit = overlap >= kFound;
      if (hit) left.erase(best);
      if (body->visible_px < kMinPixels) continue;
      bodies += 1.0;
      if (!hit) continue;
      found += 1.0;
      overlap_sum += overlap;
    }
    surplus += static_cast<double>(left.size());
  }
  const auto note = [&](const char* name, double figure, const char* unit) {
    return SceneCheck{"detections_" + level + "_" + name, figure, unit, Bound::kNone, 0.0, ""};
  };
  return {note("recall", bodies > 0.0 ? found / bodies : 0.0, "1"),
          note("overlap", found > 0.0 ? overlap_sum / found : 0.0, "IoU"),
          note("surplus", surplus / static_cast<double>(visible.size()), "boxes/frame")};
}

}  // namespace

std::vector<SceneCheck> CheckDetections(const SceneFolder& scene, TaskPool&) {
  const VisibleBoxes visible = FindVisible(scene);
  std::set<std::filesystem::path> files;  // one per level that the scene was written with
  for (const auto& entry : std::filesystem::directory_iterator(scene.path / "detections")) {
    files.insert(entry.path());
  }
  std::vector<SceneCheck> checks;
  for (const std::filesystem::path& file : files) {
    const auto boxes = ByFrame(ReadDetections(file, scene.frame_count()), scene.frame_count());
    if (file.stem() == "oracle") checks.push_back(CheckOracle(visible, boxes));
    for (SceneCheck& check : Describe(file.stem(), visible, boxes)) {
      checks.push_back(std::move(check));
    }
  }
  return checks;
}

}  // namespace cvo
