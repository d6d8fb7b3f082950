// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Replaces renderer.cc in a build without OSMesa. Everything else builds and works.
#include "core/base/error.h"
#include "synth/render/renderer.h"

namespace cvo::synth {
namespace {

[[noreturn]] void ThrowMissing() {
  ThrowError("synthetic scenes", "no OSMesa in this build",
             "libosmesa6-dev installed and -DCVO_OSMESA=ON when configuring");
}

}  // namespace

struct Renderer::State {};

Renderer::Renderer(const World&, int) { ThrowMissing(); }
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Rendering Renderer::Draw(const View&) { ThrowMissing(); }
void Renderer::DrawImages(const View&, cv::Mat&, cv::Mat&) { ThrowMissing(); }
RendererVersion FindRendererVersion() { ThrowMissing(); }

}  // namespace cvo::synth
