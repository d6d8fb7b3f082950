// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/render/renderer.h"

#include "synth/render/gl_context.h"
#include "synth/render/passes.h"

// What is guaranteed. The same bytes from run to run, for any number of threads of the rasteriser
// and on any processor with AVX, with the same Mesa and LLVM: Mesa is held to AVX and to vectors of
// 256 bits, and gallivm divides and takes roots with IEEE instructions. Not guaranteed: the same
// bytes with another version of Mesa or LLVM, without AVX (a clear error) or on other
// architectures. GL_RENDERER shows the width but not the instruction set: a process that made a
// context of its own before, with other settings, is not noticed.
namespace cvo::synth {

struct Renderer::State {
  Passes passes;
};

Renderer::Renderer(const World& world, int threads) : state_(new State{Passes(world, threads)}) {}
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
