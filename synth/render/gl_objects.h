// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "synth/render/gl.h"
#include "synth/render/view_geometry.h"

namespace cvo::synth {

// A mesh in OpenGL objects. Like all OpenGL objects below, they are freed with the context.
struct GlMesh {
  GLuint vertex_array = 0;
  GLsizei indices = 0;
  Sphere sphere;  // bounding sphere in the body's frame
  bool two_sided = true;
};

// Throws Error unless the indices are triples of valid vertex indices.
GlMesh UploadMesh(const Gl& gl, const Mesh& mesh);
// Throws Error unless the texture is CV_8UC3 and its sides are powers of two.
GLuint UploadTexture(const Gl& gl, const cv::Mat& texture);

// Throws Error with the compiler's message.
GLuint CompileProgram(const Gl& gl, const char* vertex_shader, const char* fragment_shader);

// The framebuffers to draw to, and the texture `shadow_map`. Colour is multisampled and then
// resolved; ground truth has one sample per pixel, at its centre.
struct Targets {
  GLuint shadow = 0;
  GLuint shadow_map = 0;
  GLuint samples[2] = {};  // multisampled colour, left and right
  GLuint colour[2] = {};
  GLuint ground_truth = 0;  // depth in metres, and instances
  GLuint silhouette = 0;    // stencil only
};

Targets MakeTargets(const Gl& gl, int width_px, int height_px, int shadow_side_px);

}  // namespace cvo::synth
