// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "synth/scene/world.h"

namespace cvo::synth {

// Poses of the camera and of all bodies at one instant.
struct View {
  RigidTransform world_from_left;
  std::vector<RigidTransform> world_from_body;  // [id - 1]
};

// Images of one view. Pixel centres are at integers, row 0 is at the top.
struct Rendering {
  cv::Mat left;       // CV_8UC4: red, green, blue, luma; anti-aliased
  cv::Mat right;      // as left, from the right camera
  cv::Mat depth;      // CV_32FC1: z in the left camera at the pixel centre, m; 0: no surface
  cv::Mat instances;  // CV_16UC1: body id at the pixel centre in the left image; 0: background
  std::vector<int> alone_px;  // [id - 1]: pixels the body would cover if nothing occluded it
};

// The rendering software, which is part of the identity of a render.
struct RendererVersion {
  std::string gl;        // "4.5 (Core Profile) Mesa 22.3.6"
  std::string renderer;  // "llvmpipe (LLVM 15.0.6, 256 bits)"
};

// Renders a world with OpenGL in software (OSMesa). The output has the same bytes for any number of
// threads; the notes in renderer.cc say on which processors. A renderer may only be used by the
// thread that created it.
class Renderer {
 public:
  // Throws Error if this build has no OSMesa or a context cannot be created. `threads` is the
  // number of rasteriser threads of the whole process; the first renderer determines it.
  Renderer(const World& world, int threads);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  Rendering Draw(const View& view);
  // Renders the two images only, for the sub-frames of motion blur.
  void DrawImages(const View& view, cv::Mat& left, cv::Mat& right);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Throws Error like the constructor of Renderer.
RendererVersion FindRendererVersion();

// Return the luma of an image of Rendering as CV_8UC1, or its colour as CV_8UC3 in OpenCV's order
// (BGR).
cv::Mat LumaOf(const cv::Mat& image);
cv::Mat ColourOf(const cv::Mat& image);

}  // namespace cvo::synth
