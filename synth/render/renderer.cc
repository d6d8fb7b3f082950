// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/render/renderer.h"

#include "synth/render/edge_depth.h"
#include "synth/render/gl_context.h"
#include "synth/render/passes.h"

// Guaranteed and tested: the same bytes from run to run and for any number of rasteriser threads,
// with the same Mesa and LLVM on the same processor. Mesa is restricted to AVX and 256-bit vectors
// so that other processors with AVX should give these bytes as well, which has not been tested. Not
// guaranteed: another version of Mesa or LLVM, or another architecture. Without AVX, Error is
// thrown. GL_RENDERER shows the vector width but not the instruction set, so it goes unnoticed if
// the process has already made a context with other settings.
namespace cvo::synth {

struct Renderer::State {
  Passes passes;
  StereoCamera rig;
  std::vector<Body> bodies;
};

Renderer::Renderer(const World& world, int threads)
    : state_(new State{Passes(world, threads), world.rig, world.bodies}) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Rendering Renderer::Draw(const View& view) {
  Passes& passes = state_->passes;
  passes.Begin(view);
  passes.DrawShadows();
  passes.DrawColour(kLeft);
  passes.DrawColour(kRight);
  passes.DrawGroundTruth();
  passes.DrawSilhouettes();
  Rendering rendering;
  rendering.left = passes.ReadColour(kLeft);
  rendering.right = passes.ReadColour(kRight);
  rendering.depth = passes.ReadDepth();
  rendering.instances = passes.ReadInstances();
  rendering.alone_px = passes.ReadAlone();
  passes.Check();
  CorrectEdgeDepth(state_->rig, state_->bodies, view, rendering);
  return rendering;
}

void Renderer::DrawImages(const View& view, cv::Mat& left, cv::Mat& right) {
  Passes& passes = state_->passes;
  passes.Begin(view);
  passes.DrawShadows();
  passes.DrawColour(kLeft);
  passes.DrawColour(kRight);
  left = passes.ReadColour(kLeft);
  right = passes.ReadColour(kRight);
  passes.Check();
}

RendererVersion FindRendererVersion() { return GlContext(1).Version(); }

}  // namespace cvo::synth
