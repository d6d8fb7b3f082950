// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/truth/truth.h"

#include <algorithm>

#include "core/base/error.h"
#include "synth/truth/projected_box.h"

namespace cvo::synth {
namespace {

// Finds the pixel counts and boxes of all bodies in one pass over the mask.
void AddMasks(const cv::Mat& instances, std::vector<BodyTruth>& bodies) {
  for (int v = 0; v < instances.rows; ++v) {
    const auto* row = instances.ptr<std::uint16_t>(v);
    for (int u = 0; u < instances.cols; ++u) {
      if (row[u] == 0) continue;
      Require(row[u] <= bodies.size(), "ComputeTruth: an instance mask names an unknown body");
      BodyTruth& body = bodies[row[u] - 1U];
      ++body.visible_px;
      if (!body.visible_box) {
        body.visible_box = PixelBox{double(u), double(v), double(u), double(v)};
      }
      body.visible_box->left = std::min(body.visible_box->left, double(u));
      body.visible_box->right = std::max(body.visible_box->right, double(u));
      body.visible_box->bottom = v;
    }
  }
}

void AddAmodalBox(const World& world, const RigidTransform& left_from_world, BodyTruth& body) {
  ProjectedBox projection(world.rig);
  const RigidTransform left_from_body = left_from_world * body.state.world_from_body;
  for (const Drawable& drawable : world.drawables) {
    if (drawable.body != body.id) continue;
    projection.Add(world.meshes.at(static_cast<std::size_t>(drawable.mesh)), left_from_body);
  }
  if (!projection.box()) return;
  body.amodal_box = ClipToImage(*projection.box(), world.rig.width_px, world.rig.height_px);
  const double whole_px2 = Area_px2(*projection.box());
  if (!body.amodal_box || !(whole_px2 > 0.0)) return;
  body.truncation = std::clamp(1.0 - Area_px2(*body.amodal_box) / whole_px2, 0.0, 1.0);
}

}  // namespace

FrameTruth ComputeTruth(const World& world, int frame, const Rendering& rendering) {
  Require(rendering.instances.type() == CV_16UC1, "ComputeTruth: the mask must be 16 bits");
  Require(rendering.alone_px.size() == world.bodies.size(),
          "ComputeTruth: alone_px must have one number for each body");
  FrameTruth truth;
  truth.frame = frame;
  truth.time_s = world.Time_s(frame);
  truth.world_from_left = world.camera->At(truth.time_s).world_from_body;
  for (const Body& body : world.bodies) {
    BodyTruth& added = truth.bodies.emplace_back();
    added.id = body.id;
    added.state = body.motion->At(truth.time_s);
    added.alone_px = rendering.alone_px[truth.bodies.size() - 1];
  }
  AddMasks(rendering.instances, truth.bodies);
  const RigidTransform left_from_world = truth.world_from_left.Inverse();
  for (BodyTruth& body : truth.bodies) {
    // Drawn alone, a body may gain or lose a pixel at its rim compared with the whole scene.
    body.alone_px = std::max(body.alone_px, body.visible_px);
    if (body.alone_px > 0) body.visible_fraction = double(body.visible_px) / body.alone_px;
    AddAmodalBox(world, left_from_world, body);
  }
  return truth;
}

}  // namespace cvo::synth
