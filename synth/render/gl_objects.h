// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "synth/render/gl.h"
#include "synth/render/view_geometry.h"

namespace cvo::synth {

// Meshes and textures in OpenGL objects, which end with the context.
struct GlMesh {
  GLuint vertex_array = 0;
  GLsizei indices = 0;
  Sphere sphere;  // in the body's frame
  bool two_sided = true;
};

// Throws Error for indices outside the vertices.
GlMesh UploadMesh(const Gl& gl, const Mesh& mesh);
// Throws Error if it is not CV_8UC3 with sides that are powers of two.
GLuint UploadTexture(const Gl& gl, const cv::Mat& texture);

// Throws Error with the compiler's words.
GLuint CompileProgram(const Gl& gl, const char* vertex_shader, const char* fragment_shader);

// What is drawn to. Colour is multi-sampled and then resolved; ground truth has one sample in the
// middle of each pixel.
struct Targets {
  GLuint shadow = 0;
  GLuint shadow_map = 0;
  GLuint samples[2] = {};  // colour, left and right
  GLuint colour[2] = {};
  GLuint ground_truth = 0;  // depth in metres and instances
  GLuint silhouette = 0;    // stencil alone
};

Targets MakeTargets(const Gl& gl, int width_px, int height_px, int shadow_side_px);

}  // namespace cvo::synth
