// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "synth/render/gl.h"
#include "synth/render/renderer.h"

namespace cvo::synth {

// An OpenGL 4.5 core context of llvmpipe with 256-bit vectors. Its OpenGL objects are freed with
// it. The constructor makes it current in the calling thread.
class GlContext {
 public:
  // Throws Error if such a context cannot be created. `threads` as in Renderer.
  explicit GlContext(int threads);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  // To be called where another context may have become current.
  void MakeCurrent();
  const Gl& gl() const { return gl_; }
  RendererVersion Version() const;

 private:
  struct OsMesa;
  std::unique_ptr<OsMesa> os_mesa_;
  Gl gl_ = {};
};

}  // namespace cvo::synth
