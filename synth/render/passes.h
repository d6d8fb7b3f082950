// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "synth/render/gl_context.h"
#include "synth/render/gl_objects.h"
#include "synth/render/renderer.h"

namespace cvo::synth {

enum Eye { kLeft, kRight };

// The passes over a world that make up a rendering. Results are best read after all passes have
// been drawn: the rasteriser works on one pass while the next is prepared.
class Passes {
 public:
  Passes(const World& world, int threads);

  void Begin(const View& view);
  void DrawShadows();
  void DrawColour(Eye eye);  // after DrawShadows
  void DrawGroundTruth();
  void DrawSilhouettes();

  cv::Mat ReadColour(Eye eye);
  cv::Mat ReadDepth();
  cv::Mat ReadInstances();
  std::vector<int> ReadAlone();
  void Check();  // throws Error if an OpenGL call has failed

 private:
  // A drawable with its pose in the current view.
  struct Placed {
    const Drawable* drawable;
    const GlMesh* mesh;
    Eigen::Matrix4d world_from_body;
    double farthest_m;  // upper bound of its distance from the camera
  };

  void SetMatrix(int location, const Eigen::Matrix4d& matrix);
  void SetVector(int location, const Eigen::Vector3d& vector);
  void SetLighting(const Placed& placed, Eye eye);
  void UseTarget(GLuint framebuffer, int width_px, int height_px);
  void DrawMesh(const GlMesh& mesh);
  void DrawSky(Eye eye);
  cv::Mat Read(GLuint framebuffer, GLenum attachment, GLenum format, GLenum gl_type, int type);

  GlContext context_;
  const Gl& gl_;
  StereoCamera rig_;
  RigError rig_error_;
  Light light_;
  std::vector<Drawable> drawables_;
  std::vector<GlMesh> meshes_;
  std::vector<GLuint> textures_;
  std::vector<GLuint> queries_;     // [id - 1]
  std::vector<bool> query_is_set_;  // [id - 1], in the current view
  GLuint sky_vertices_ = 0;
  GLuint colour_program_ = 0;
  GLuint sky_program_ = 0;
  GLuint ground_truth_program_ = 0;
  GLuint position_program_ = 0;
  Targets targets_;

  RigidTransform world_from_left_;
  Eigen::Matrix4d clip_from_world_[2];
  Eigen::Matrix4d shadow_clip_from_world_;
  Eigen::Matrix4d shadow_map_from_world_;
  std::vector<Placed> placed_;  // sorted from near to far
};

}  // namespace cvo::synth
