// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "synth/render/gl.h"
#include "synth/render/renderer.h"

namespace cvo::synth {

// An OpenGL 4.5 core context drawn by llvmpipe with vectors of 256 bits. Whatever OpenGL objects it
// holds end with it. Current in the calling thread once constructed.
class GlContext {
 public:
  // Throws Error where there is no such context. `threads` as in Renderer.
  explicit GlContext(int threads);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  // Other contexts may have been current meanwhile.
  void MakeCurrent();
  const Gl& gl() const { return gl_; }
  RendererVersion Version() const;

 private:
  struct OsMesa;
  std::unique_ptr<OsMesa> os_mesa_;
  Gl gl_ = {};
};

}  // namespace cvo::synth
