// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "synth/render/renderer.h"
#include "synth/scene/world.h"

namespace cvo::synth {

// In pixels, pixel centres at integers: a box around one pixel (u, v) has all four sides on it.
struct PixelBox {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
};

// One body in one frame. Transforms are in the scene's world.
struct BodyTruth {
  int id = 0;
  MotionState state;
  int visible_px = 0;                   // in the mask
  int alone_px = 0;                     // if nothing hid it
  double visible_fraction = 0.0;        // visible_px / alone_px; 0 out of view
  double truncation = 1.0;              // part of its projected box that is outside the image
  std::optional<PixelBox> visible_box;  // around the mask
  std::optional<PixelBox> amodal_box;   // around the whole body's projection, within the image
};

struct FrameTruth {
  int frame = 0;  // of the scene
  double time_s = 0.0;
  RigidTransform world_from_left;
  std::vector<BodyTruth> bodies;  // [id - 1], all of the scene
};

FrameTruth ComputeTruth(const World& world, int frame, const Rendering& rendering);

}  // namespace cvo::synth
