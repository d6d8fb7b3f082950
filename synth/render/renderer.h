// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
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

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("gl", self.gl);
    archive.Field("renderer", self.renderer);
  }
};

// Renders a world with OpenGL in software (OSMesa). It draws in the calling thread, which must be
// the one that created it. The notes in renderer.cc say on which processors the output has the same
// bytes.
class Renderer {
 public:
  // Throws Error if this build has no OSMesa or a context cannot be created.
  explicit Renderer(const World& world);
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

// Corrects the depth of triangles seen edge-on. Such a triangle may cover the centre of a pixel
// only because the rasteriser rounds vertices to 1/256 px. Its depth there is extrapolated, with
// errors of up to some decimetres. On a body, these pixels give points outside the body's box. They
// take the depth of the neighbour on the same body that is closest in depth to the centre of the
// box. Bodies without a size are left unchanged.
void CorrectEdgeDepth(const StereoCamera& rig, const std::vector<Body>& bodies, const View& view,
                      Rendering& rendering);

// Clip coordinates (x, y, z, w) for a framebuffer whose row 0 is the top row of the image. As pixel
// centres are at integer (u, v), the window coordinates of a pixel are (u + 0.5, v + 0.5). Depth is
// kNear_m / z: 1 at the near plane and 0 at infinity, which keeps float depth precise far away.
inline constexpr double kNear_m = 0.05;
Eigen::Matrix4d ClipFromLeft(const StereoCamera& rig);
// For the right camera with its calibration error, from the left camera's frame.
Eigen::Matrix4d ClipFromRight(const StereoCamera& rig, const RigError& error);

// Orthographic projection along the light, centred on the camera. Depth increases towards the
// light. It moves in whole texels of a map with side `side_px`, so that shadow edges stay still
// when the camera moves.
Eigen::Matrix4d ShadowClipFromWorld(const Light& light, const Eigen::Vector3d& camera_in_world,
                                    int side_px);

struct Sphere {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

// Returns a sphere that contains all vertices, centred on their bounding box.
Sphere BoundingSphere(const Mesh& mesh);

// Returns false only if the sphere, given in the body's frame, is entirely outside the clip volume.
bool MayBeVisible(const Eigen::Matrix4d& clip_from_body, const Sphere& sphere);

}  // namespace cvo::synth
