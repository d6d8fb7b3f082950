// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "synth/scene/world.h"

namespace cvo::synth {

// Where the camera and the bodies are at one instant.
struct View {
  RigidTransform world_from_left;
  std::vector<RigidTransform> world_from_body;  // [id - 1]
};

// Pixel centres at integers, row 0 at the top.
struct Rendering {
  cv::Mat left;       // CV_8UC4: red, green, blue, luma; anti-aliased
  cv::Mat right;      // as left, from the right camera
  cv::Mat depth;      // CV_32FC1: z in the left camera at the pixel's centre, m; 0: no surface
  cv::Mat instances;  // CV_16UC1: body id at the pixel's centre in the left image, 0: background
  std::vector<int> alone_px;  // [id - 1]: pixels the body would cover if nothing hid it
};

// Which software draws: part of the identity of what was drawn.
struct RendererVersion {
  std::string gl;        // "4.5 (Core Profile) Mesa 22.3.6"
  std::string renderer;  // "llvmpipe (LLVM 15.0.6, 256 bits)"
};

// Draws a world with OpenGL in software (OSMesa). The same bytes for any number of threads; see
// the notes in renderer.cc on which processors. One renderer belongs to the thread that made it.
class Renderer {
 public:
  // Throws Error where this build has no OSMesa or no context can be made. `threads`: of the
  // rasteriser, for the whole process (the first renderer decides).
  Renderer(const World& world, int threads);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  Rendering Draw(const View& view);
  // The two images alone: what sub-frames of motion blur need.
  void DrawImages(const View& view, cv::Mat& left, cv::Mat& right);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Throws Error as the constructor does.
RendererVersion FindRendererVersion();

// One channel of the images above as CV_8UC1, or colour as CV_8UC3 in OpenCV's order (BGR).
cv::Mat LumaOf(const cv::Mat& image);
cv::Mat ColourOf(const cv::Mat& image);

}  // namespace cvo::synth
