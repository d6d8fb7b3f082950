// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/render/gl_context.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdlib>
#include <string_view>

#include "core/base/error.h"
#include "core/files/images/shared_library.h"

namespace cvo::synth {
namespace {

// Drawing goes to framebuffer objects. OSMesa's own buffer is never used.
constexpr int kUnusedSide_px = 4;

void SetVariable(const char* name, const std::string& value) {
  const char* old = std::getenv(name);
  if (old == nullptr || old != value) setenv(name, value.c_str(), 1);
}

// Sets the variables that Mesa reads when the process makes its first context. AVX and 256 bits
// give the same bytes on most processors. Compiled shaders must not be cached in the user's home
// folder.
void ConfigureMesa(int threads) {
  SetVariable("LP_NATIVE_VECTOR_WIDTH", "256");
  SetVariable("GALLIUM_OVERRIDE_CPU_CAPS", "avx");
  SetVariable("GALLIUM_DRIVER", "llvmpipe");
  SetVariable("MESA_SHADER_CACHE_DISABLE", "true");
  if (std::getenv("LP_NUM_THREADS") == nullptr) SetVariable("LP_NUM_THREADS", StrCat(threads));
}

std::string Text(const GLubyte* text) {
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

void CheckRenderer(const std::string& renderer) {
  const std::string_view text = renderer;
  if (text.starts_with("llvmpipe") && text.find("256 bits") != text.npos) return;
  ThrowError("OSMesa", renderer, "llvmpipe with 256-bit vectors (a processor with AVX)");
}

}  // namespace

// The library is loaded with the first context.
struct GlContext::OsMesa {
  decltype(OSMesaCreateContextAttribs)* create =
      FindFunction<decltype(OSMesaCreateContextAttribs)>(kOsMesa, "OSMesaCreateContextAttribs");
  decltype(OSMesaMakeCurrent)* make_current =
      FindFunction<decltype(OSMesaMakeCurrent)>(kOsMesa, "OSMesaMakeCurrent");
  decltype(OSMesaDestroyContext)* destroy =
      FindFunction<decltype(OSMesaDestroyContext)>(kOsMesa, "OSMesaDestroyContext");
  OSMesaContext context = nullptr;
  std::array<GLubyte, 4 * kUnusedSide_px* kUnusedSide_px> unused = {};

  ~OsMesa() {
    if (context == nullptr) return;
    make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    destroy(context);
  }
};

GlContext::GlContext(int threads) : os_mesa_(std::make_unique<OsMesa>()) {
  ConfigureMesa(threads);
  const std::array<int, 9> attributes = {OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         4,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         5,
                                         0};
  os_mesa_->context = os_mesa_->create(attributes.data(), nullptr);
  if (os_mesa_->context == nullptr) ThrowError("OSMesa", "no context", "an OpenGL 4.5 core one");
  MakeCurrent();
  gl_ = LoadGl();
  CheckRenderer(Text(gl_.GetString(GL_RENDERER)));
}

GlContext::~GlContext() = default;

void GlContext::MakeCurrent() {
  if (!os_mesa_->make_current(os_mesa_->context, os_mesa_->unused.data(), GL_UNSIGNED_BYTE,
                              kUnusedSide_px, kUnusedSide_px)) {
    ThrowError("OSMesa", "a context that cannot be made current", "one that can");
  }
}

RendererVersion GlContext::Version() const {
  return {Text(gl_.GetString(GL_VERSION)), Text(gl_.GetString(GL_RENDERER))};
}

}  // namespace cvo::synth
