// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/base/error.h"
#include "experiments/scene_check/checks.h"
#include "experiments/scene_check/limits.h"
#include "experiments/scene_check/reprojection.h"

namespace cvo {
namespace {

// The pixels of a body in one frame.
struct Mask {
  int pixels = 0;
  TruthBox box = {1e9, 1e9, -1e9, -1e9};
  double outside_box_m = 0.0;    // largest distance outside the 3D box, less that allowed by depth
  double outside_hull_px = 0.0;  // largest distance outside the hull of the projected 3D box
};

// Returns the convex hull of a projected box as lines with inward normals, n . p + c >= 0. Empty if
// a corner is behind the camera.
std::optional<std::vector<Eigen::Vector3d>> ProjectHull(const StereoCamera& camera,
                                                        const RigidTransform& camera_from_object,
                                                        const Eigen::Vector3d& size_m) {
  std::vector<cv::Point2f> corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    const auto z_px = camera.Project(camera_from_object * sign.cwiseProduct(size_m));
    if (!z_px) return std::nullopt;
    corners.emplace_back(static_cast<float>((*z_px)[0]), static_cast<float>((*z_px)[1]));
  }
  std::vector<cv::Point2f> hull;
  cv::convexHull(corners, hull);
  cv::Point2f centre(0.0F, 0.0F);
  for (const cv::Point2f& corner : hull) centre += corner / static_cast<float>(hull.size());
  std::vector<Eigen::Vector3d> lines;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const cv::Point2f a = hull[i], b = hull[(i + 1) % hull.size()];
    Eigen::Vector2d normal(a.y - b.y, b.x - a.x);
    if (normal.norm() < 1e-6) continue;
    normal.normalize();
    double c = -normal.dot(Eigen::Vector2d(a.x, a.y));
    const double at_centre = normal.dot(Eigen::Vector2d(centre.x, centre.y)) + c;
    const double sign = at_centre < 0.0 ? -1.0 : 1.0;
    lines.emplace_back(sign * normal.x(), sign * normal.y(), sign * c);
  }
  return lines;
}

// What the pixels of a body are checked against.
struct Shape {
  RigidTransform object_from_camera;
  Eigen::Vector3d half_size_m;
  std::optional<std::vector<Eigen::Vector3d>> hull;
};

struct FrameMasks {
  std::vector<Mask> masks;  // [id - 1]
  int strangers = 0;        // pixels whose id is that of no body
};

void AddPixel(const StereoCamera& camera, const cv::Mat& depth, int u, int v, const Shape& shape,
              Mask& mask) {
  ++mask.pixels;
  mask.box.left_px = std::min<double>(mask.box.left_px, u);
  mask.box.right_px = std::max<double>(mask.box.right_px, u);
  mask.box.top_px = std::min<double>(mask.box.top_px, v);
  mask.box.bottom_px = std::max<double>(mask.box.bottom_px, v);
  if (shape.hull) {
    for (const Eigen::Vector3d& line : *shape.hull) {
      mask.outside_hull_px =
          std::max(mask.outside_hull_px, -(line.x() * u + line.y() * v + line.z()));
    }
  }
  const double z_m = depth.at<float>(v, u);
  if (!(z_m > 0.0)) {
    mask.outside_box_m = std::numeric_limits<double>::infinity();
    return;
  }
  const Eigen::Vector3d p_in_object = shape.object_from_camera * PointAt(camera, depth, u, v);
  const double outside_m = (p_in_object.cwiseAbs() - shape.half_size_m).maxCoeff();
  mask.outside_box_m =
      std::max(mask.outside_box_m, outside_m - limits::kBoxTolerancePerDepth * z_m);
}

FrameMasks MeasureMasks(const SceneFolder& scene, int frame) {
  const auto index = static_cast<std::size_t>(frame);
  const StereoCamera& camera = scene.sequence.camera;
  const cv::Mat depth = scene.Depth(frame);
  const cv::Mat instances = scene.Instances(frame);
  const RigidTransform camera_from_world = scene.world_from_left[index].Inverse();
  std::vector<Shape> shapes;
  for (const SceneBody& body : scene.bodies[index]) {
    const RigidTransform camera_from_object = camera_from_world * body.world_from_object;
    shapes.push_back({camera_from_object.Inverse(), 0.5 * body.size_m,
                      ProjectHull(camera, camera_from_object, body.size_m)});
  }
  FrameMasks result;
  result.masks.resize(shapes.size());
  for (int v = 0; v < instances.rows; ++v) {
    const auto* row = instances.ptr<std::uint16_t>(v);
    for (int u = 0; u < instances.cols; ++u) {
      if (row[u] == 0) continue;
      const std::size_t body = row[u] - 1U;
      if (body >= shapes.size()) {
        ++result.strangers;
      } else {
        AddPixel(camera, depth, u, v, shapes[body], result.masks[body]);
      }
    }
  }
  return result;
}

double BoxDifference_px(const TruthBox& a, const TruthBox& b) {
  return std::max({std::abs(a.left_px - b.left_px), std::abs(a.top_px - b.top_px),
                   std::abs(a.right_px - b.right_px), std::abs(a.bottom_px - b.bottom_px)});
}

// Returns how far the visible box extends beyond the amodal one, px.
double OutOfAmodal_px(const SceneBody& body) {
  if (!body.visible_box || !body.amodal_box) return body.visible_box ? 1e9 : 0.0;
  return std::max({body.amodal_box->left_px - body.visible_box->left_px,
                   body.amodal_box->top_px - body.visible_box->top_px,
                   body.visible_box->right_px - body.amodal_box->right_px,
                   body.visible_box->bottom_px - body.amodal_box->bottom_px, 0.0});
}

struct MaskWorst {
  Worst box3d, hull, pixels, box, amodal, fraction;

  void Add(const SceneBody& body, const Mask& mask, const std::string& place) {
    pixels.Add(std::abs(body.visible_px - mask.pixels), place);
    box3d.Add(mask.outside_box_m, place);
    hull.Add(mask.outside_hull_px, place);
    amodal.Add(OutOfAmodal_px(body), place);
    const double fraction_found =
        body.alone_px > 0 ? static_cast<double>(body.visible_px) / body.alone_px : 0.0;
    fraction.Add(std::abs(fraction_found - body.visible_fraction), place);
    if (mask.pixels > 0 && body.visible_box) {
      box.Add(BoxDifference_px(mask.box, *body.visible_box), place);
    }
  }
};

}  // namespace

std::vector<SceneCheck> CheckMasks(const SceneFolder& scene, TaskPool& pool) {
  const std::vector<FrameMasks> results = ForAll<FrameMasks>(
      scene.frame_count(), pool, [&](int frame) { return MeasureMasks(scene, frame); });
  MaskWorst worst;
  Worst strangers;
  for (std::size_t i = 0; i < results.size(); ++i) {
    strangers.Add(results[i].strangers, StrCat("frame ", i));
    for (std::size_t body = 0; body < results[i].masks.size(); ++body) {
      const SceneBody& truth = scene.bodies[i][body];
      worst.Add(truth, results[i].masks[body], StrCat(truth.name, ", frame ", i));
    }
  }
  return {strangers.AtMost("mask_unknown_ids", "px", 0.0),
          worst.pixels.AtMost("mask_visible_px", "px", 0.0),
          worst.box.AtMost("mask_visible_box", "px", limits::kFractionText),
          worst.fraction.AtMost("visible_fraction", "1", limits::kFractionText),
          worst.amodal.AtMost("visible_out_of_amodal_box", "px", limits::kHull_px),
          worst.hull.AtMost("mask_out_of_box_hull", "px", limits::kHull_px),
          worst.box3d.AtMost("mask_point_out_of_box", "m", limits::kBoxTolerance_m)};
}

}  // namespace cvo
