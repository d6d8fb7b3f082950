// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/render/gl.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace cvo::synth {
namespace {

void* OsMesaLibrary() {
  static const auto library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) ThrowError("OSMesa", dlerror(), "libOSMesa.so.8, installed");
  return library;
}

// Drawing goes to framebuffer objects. OSMesa's own buffer is never used.
constexpr int kUnusedSide_px = 4;

void SetVariable(const char* name, const std::string& value) {
  const char* old = std::getenv(name);
  if (old == nullptr || old != value) setenv(name, value.c_str(), 1);
}

// Sets the variables that Mesa reads when the process makes its first context. AVX and 256 bits
// give the same bytes on most processors. Compiled shaders must not be cached in the user's home
// folder. No rasteriser threads: one of Mesa 22.3's may unlock the mutex of a fence that another
// thread has freed already, which overwrites four bytes of the heap.
void ConfigureMesa() {
  SetVariable("LP_NATIVE_VECTOR_WIDTH", "256");
  SetVariable("GALLIUM_OVERRIDE_CPU_CAPS", "avx");
  SetVariable("GALLIUM_DRIVER", "llvmpipe");
  SetVariable("MESA_SHADER_CACHE_DISABLE", "true");
  SetVariable("LP_NUM_THREADS", "0");
}

std::string Text(const GLubyte* text) {
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

void CheckRenderer(const std::string& renderer) {
  const std::string_view text = renderer;
  if (text.starts_with("llvmpipe") && text.find("256 bits") != text.npos) return;
  ThrowError("OSMesa", renderer, "llvmpipe with 256-bit vectors (a processor with AVX)");
}

constexpr int kSamples = 4;

GLuint MakeBuffer(const Gl& gl, const void* data, std::size_t bytes) {
  GLuint buffer = 0;
  gl.CreateBuffers(1, &buffer);
  gl.NamedBufferStorage(buffer, static_cast<GLsizeiptr>(bytes), data, 0);
  return buffer;
}

void AddAttribute(const Gl& gl, GLuint vertex_array, GLuint index, int numbers,
                  std::size_t offset) {
  gl.VertexArrayAttribFormat(vertex_array, index, numbers, GL_FLOAT, GL_FALSE,
                             static_cast<GLuint>(offset));
  gl.VertexArrayAttribBinding(vertex_array, index, 0);
  gl.EnableVertexArrayAttrib(vertex_array, index);
}

GLuint CompileShader(const Gl& gl, GLenum type, const char* source) {
  const GLuint shader = gl.CreateShader(type);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint good = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_FALSE) {
    std::array<char, 1024> log = {};
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()) - 1, nullptr, log.data());
    ThrowError("OpenGL shader", log.data(), "one that compiles");
  }
  return shader;
}

GLuint MakeRenderbuffer(const Gl& gl, GLenum format, int samples, cv::Size size) {
  GLuint buffer = 0;
  gl.CreateRenderbuffers(1, &buffer);
  gl.NamedRenderbufferStorageMultisample(buffer, samples, format, size.width, size.height);
  return buffer;
}

struct Attachment {
  GLenum point;
  GLenum format;
};

GLuint MakeFramebuffer(const Gl& gl, cv::Size size, int samples,
                       const std::vector<Attachment>& attachments) {
  GLuint framebuffer = 0;
  gl.CreateFramebuffers(1, &framebuffer);
  std::vector<GLenum> colours;
  for (const auto& [point, format] : attachments) {
    gl.NamedFramebufferRenderbuffer(framebuffer, point, GL_RENDERBUFFER,
                                    MakeRenderbuffer(gl, format, samples, size));
    if (point != GL_DEPTH_ATTACHMENT && point != GL_STENCIL_ATTACHMENT) colours.push_back(point);
  }
  gl.NamedFramebufferDrawBuffers(framebuffer, static_cast<GLsizei>(colours.size()), colours.data());
  if (colours.empty()) gl.NamedFramebufferReadBuffer(framebuffer, GL_NONE);
  return framebuffer;
}

GLuint MakeShadowMap(const Gl& gl, int side_px) {
  GLuint map = 0;
  gl.CreateTextures(GL_TEXTURE_2D, 1, &map);
  gl.TextureStorage2D(map, 1, GL_DEPTH_COMPONENT32F, side_px, side_px);
  gl.TextureParameteri(map, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TextureParameteri(map, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TextureParameteri(map, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TextureParameteri(map, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.TextureParameteri(map, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl.TextureParameteri(map, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
  return map;
}

void CheckComplete(const Gl& gl, GLuint framebuffer, const char* name) {
  const GLenum status = gl.CheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    ThrowError(StrCat("frame buffer for ", name), StrCat("status ", status), "a complete one");
  }
}

// Returns the indices with every triangle counter-clockwise as seen from the side of its normals.
std::vector<std::uint32_t> OrientedIndices(const Mesh& mesh) {
  std::vector<std::uint32_t> indices = mesh.indices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Vertex& a = mesh.vertices[indices[i]];
    const Vertex& b = mesh.vertices[indices[i + 1]];
    const Vertex& c = mesh.vertices[indices[i + 2]];
    const Eigen::Vector3f face = (b.position - a.position).cross(c.position - a.position);
    if (face.dot(a.normal + b.normal + c.normal) < 0.0F) std::swap(indices[i + 1], indices[i + 2]);
  }
  return indices;
}

}  // namespace

// OSMesa's own loader knows OpenGL, but not the functions of OSMesa itself.
GlFunction::GlFunction(const char* name) {
  static const auto find = reinterpret_cast<decltype(&OSMesaGetProcAddress)>(
      dlsym(OsMesaLibrary(), "OSMesaGetProcAddress"));
  found_ = find == nullptr ? nullptr : find(name);
  if (found_ == nullptr) found_ = reinterpret_cast<OSMESAproc>(dlsym(OsMesaLibrary(), name));
  if (found_ == nullptr) ThrowError("OSMesa", StrCat("no function ", name), "OpenGL 4.5");
}

void CheckGl(const Gl& gl, const char* where) {
  const GLenum error = gl.GetError();
  if (error == GL_NO_ERROR) return;
  ThrowError(where, error == GL_OUT_OF_MEMORY ? "out of memory" : StrCat("OpenGL error ", error),
             "no OpenGL error");
}

// The library is loaded with the first context.
struct GlContext::OsMesa {
  decltype(&OSMesaCreateContextAttribs) create = GlFunction("OSMesaCreateContextAttribs");
  decltype(&OSMesaMakeCurrent) make_current = GlFunction("OSMesaMakeCurrent");
  decltype(&OSMesaDestroyContext) destroy = GlFunction("OSMesaDestroyContext");
  OSMesaContext context = nullptr;
  std::array<GLubyte, 4 * kUnusedSide_px* kUnusedSide_px> unused = {};

  ~OsMesa() {
    if (context == nullptr) return;
    make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    destroy(context);
  }
};

GlContext::GlContext() : os_mesa_(std::make_unique<OsMesa>()) {
  ConfigureMesa();
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
  gl_ = std::make_unique<const Gl>();
  CheckRenderer(Text(gl_->GetString(GL_RENDERER)));
}

GlContext::~GlContext() = default;

void GlContext::MakeCurrent() {
  if (!os_mesa_->make_current(os_mesa_->context, os_mesa_->unused.data(), GL_UNSIGNED_BYTE,
                              kUnusedSide_px, kUnusedSide_px)) {
    ThrowError("OSMesa", "a context that cannot be made current", "one that can");
  }
}

RendererVersion GlContext::Version() const {
  return {Text(gl_->GetString(GL_VERSION)), Text(gl_->GetString(GL_RENDERER))};
}

GlMesh UploadMesh(const Gl& gl, const Mesh& mesh) {
  const bool good = mesh.indices.size() % 3 == 0 &&
                    std::all_of(mesh.indices.begin(), mesh.indices.end(),
                                [&](std::uint32_t i) { return i < mesh.vertices.size(); });
  Require(good, "mesh: indices are triples of indices of its vertices");
  GlMesh uploaded;
  uploaded.indices = static_cast<GLsizei>(mesh.indices.size());
  uploaded.sphere = BoundingSphere(mesh);
  uploaded.two_sided = mesh.two_sided;
  if (mesh.indices.empty()) return uploaded;
  gl.CreateVertexArrays(1, &uploaded.vertex_array);
  const GLuint vertices =
      MakeBuffer(gl, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
  gl.VertexArrayVertexBuffer(uploaded.vertex_array, 0, vertices, 0, sizeof(Vertex));
  const std::vector<std::uint32_t> indices = OrientedIndices(mesh);
  gl.VertexArrayElementBuffer(
      uploaded.vertex_array,
      MakeBuffer(gl, indices.data(), indices.size() * sizeof(std::uint32_t)));
  AddAttribute(gl, uploaded.vertex_array, 0, 3, offsetof(Vertex, position));
  AddAttribute(gl, uploaded.vertex_array, 1, 3, offsetof(Vertex, normal));
  AddAttribute(gl, uploaded.vertex_array, 2, 2, offsetof(Vertex, uv));
  return uploaded;
}

GLuint UploadTexture(const Gl& gl, const cv::Mat& texture) {
  const auto is_power = [](int side) { return std::has_single_bit(static_cast<unsigned>(side)); };
  Require(texture.type() == CV_8UC3 && is_power(texture.cols) && is_power(texture.rows),
          "texture: CV_8UC3 with sides that are powers of two");
  const cv::Mat pixels = texture.isContinuous() ? texture : texture.clone();
  const int levels = std::bit_width(static_cast<unsigned>(std::max(pixels.cols, pixels.rows)));
  GLuint uploaded = 0;
  gl.CreateTextures(GL_TEXTURE_2D, 1, &uploaded);
  gl.TextureStorage2D(uploaded, levels, GL_RGB8, pixels.cols, pixels.rows);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TextureSubImage2D(uploaded, 0, 0, 0, pixels.cols, pixels.rows, GL_RGB, GL_UNSIGNED_BYTE,
                       pixels.data);
  gl.GenerateTextureMipmap(uploaded);
  gl.TextureParameteri(uploaded, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TextureParameteri(uploaded, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return uploaded;
}

GLuint CompileProgram(const Gl& gl, const char* vertex_shader, const char* fragment_shader) {
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, CompileShader(gl, GL_VERTEX_SHADER, vertex_shader));
  gl.AttachShader(program, CompileShader(gl, GL_FRAGMENT_SHADER, fragment_shader));
  gl.LinkProgram(program);
  GLint good = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &good);
  if (good == GL_FALSE) {
    std::array<char, 1024> log = {};
    gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()) - 1, nullptr, log.data());
    ThrowError("OpenGL program", log.data(), "one that links");
  }
  return program;
}

Targets MakeTargets(const Gl& gl, int width_px, int height_px, int shadow_side_px) {
  const cv::Size size(width_px, height_px);
  const Attachment depth = {GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F};
  const Attachment colour = {GL_COLOR_ATTACHMENT0, GL_RGBA8};
  Targets targets;
  targets.shadow_map = MakeShadowMap(gl, shadow_side_px);
  targets.shadow = MakeFramebuffer(gl, size, 0, {});
  gl.NamedFramebufferTexture(targets.shadow, GL_DEPTH_ATTACHMENT, targets.shadow_map, 0);
  for (int eye : {0, 1}) {
    targets.samples[eye] = MakeFramebuffer(gl, size, kSamples, {colour, depth});
    targets.colour[eye] = MakeFramebuffer(gl, size, 0, {colour});
    CheckComplete(gl, targets.samples[eye], "colour samples");
    CheckComplete(gl, targets.colour[eye], "colour");
  }
  targets.ground_truth = MakeFramebuffer(
      gl, size, 0, {{GL_COLOR_ATTACHMENT0, GL_R32F}, {GL_COLOR_ATTACHMENT1, GL_R16UI}, depth});
  targets.silhouette = MakeFramebuffer(gl, size, 0, {{GL_STENCIL_ATTACHMENT, GL_STENCIL_INDEX8}});
  CheckComplete(gl, targets.shadow, "shadows");
  CheckComplete(gl, targets.ground_truth, "depth and instances");
  CheckComplete(gl, targets.silhouette, "silhouettes");
  return targets;
}

}  // namespace cvo::synth
