// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "synth/render/renderer.h"
#include "synth/scene/world.h"

namespace cvo::synth {

// A box in pixels, with pixel centres at integers: all four sides of the box around a single pixel
// (u, v) pass through its centre.
struct PixelBox {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
};

// Ground truth of one body in one frame. Transforms are in the scene's world.
struct BodyTruth {
  int id = 0;
  MotionState state;
  int visible_px = 0;                   // pixels in the mask
  int alone_px = 0;                     // pixels if nothing occluded it
  double visible_fraction = 0.0;        // visible_px / alone_px; 0 if out of view
  double truncation = 1.0;              // fraction of its projected box outside the image
  std::optional<PixelBox> visible_box;  // around the mask
  std::optional<PixelBox> amodal_box;   // around the projection of the whole body, within the image
};

struct FrameTruth {
  int frame = 0;  // in the scene
  double time_s = 0.0;
  RigidTransform world_from_left;
  std::vector<BodyTruth> bodies;  // [id - 1], all bodies of the scene
};

FrameTruth ComputeTruth(const World& world, int frame, const Rendering& rendering);

}  // namespace cvo::synth
