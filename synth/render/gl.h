// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <GL/glcorearb.h>

#include <opencv2/core/mat.hpp>
#include <vector>

#include "synth/render/renderer.h"

namespace cvo::synth {

// Finds a function of OSMesa, which is loaded with the first one: most runs of the program draw
// nothing. Throws Error if the library or the function is missing.
class GlFunction {
 public:
  explicit GlFunction(const char* name);
  template <typename Function>
  operator Function*() const {
    return reinterpret_cast<Function*>(found_);
  }

 private:
  void (*found_)();
};

// The OpenGL 4.5 functions in use, named without their prefix, and valid in every context.
struct Gl {
  // objects
  PFNGLCREATEBUFFERSPROC CreateBuffers = GlFunction("glCreateBuffers");
  PFNGLNAMEDBUFFERSTORAGEPROC NamedBufferStorage = GlFunction("glNamedBufferStorage");
  PFNGLCREATEVERTEXARRAYSPROC CreateVertexArrays = GlFunction("glCreateVertexArrays");
  PFNGLVERTEXARRAYVERTEXBUFFERPROC VertexArrayVertexBuffer =
      GlFunction("glVertexArrayVertexBuffer");
  PFNGLVERTEXARRAYELEMENTBUFFERPROC VertexArrayElementBuffer =
      GlFunction("glVertexArrayElementBuffer");
  PFNGLVERTEXARRAYATTRIBFORMATPROC VertexArrayAttribFormat =
      GlFunction("glVertexArrayAttribFormat");
  PFNGLVERTEXARRAYATTRIBBINDINGPROC VertexArrayAttribBinding =
      GlFunction("glVertexArrayAttribBinding");
  PFNGLENABLEVERTEXARRAYATTRIBPROC EnableVertexArrayAttrib =
      GlFunction("glEnableVertexArrayAttrib");
  PFNGLBINDVERTEXARRAYPROC BindVertexArray = GlFunction("glBindVertexArray");
  PFNGLCREATETEXTURESPROC CreateTextures = GlFunction("glCreateTextures");
  PFNGLTEXTURESTORAGE2DPROC TextureStorage2D = GlFunction("glTextureStorage2D");
  PFNGLTEXTURESUBIMAGE2DPROC TextureSubImage2D = GlFunction("glTextureSubImage2D");
  PFNGLGENERATETEXTUREMIPMAPPROC GenerateTextureMipmap = GlFunction("glGenerateTextureMipmap");
  PFNGLTEXTUREPARAMETERIPROC TextureParameteri = GlFunction("glTextureParameteri");
  PFNGLTEXTUREPARAMETERFPROC TextureParameterf = GlFunction("glTextureParameterf");
  PFNGLTEXTUREPARAMETERFVPROC TextureParameterfv = GlFunction("glTextureParameterfv");
  PFNGLBINDTEXTUREUNITPROC BindTextureUnit = GlFunction("glBindTextureUnit");
  PFNGLCREATERENDERBUFFERSPROC CreateRenderbuffers = GlFunction("glCreateRenderbuffers");
  PFNGLNAMEDRENDERBUFFERSTORAGEMULTISAMPLEPROC NamedRenderbufferStorageMultisample =
      GlFunction("glNamedRenderbufferStorageMultisample");
  PFNGLCREATEFRAMEBUFFERSPROC CreateFramebuffers = GlFunction("glCreateFramebuffers");
  PFNGLNAMEDFRAMEBUFFERRENDERBUFFERPROC NamedFramebufferRenderbuffer =
      GlFunction("glNamedFramebufferRenderbuffer");
  PFNGLNAMEDFRAMEBUFFERTEXTUREPROC NamedFramebufferTexture =
      GlFunction("glNamedFramebufferTexture");
  PFNGLNAMEDFRAMEBUFFERDRAWBUFFERSPROC NamedFramebufferDrawBuffers =
      GlFunction("glNamedFramebufferDrawBuffers");
  PFNGLNAMEDFRAMEBUFFERREADBUFFERPROC NamedFramebufferReadBuffer =
      GlFunction("glNamedFramebufferReadBuffer");
  PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC CheckNamedFramebufferStatus =
      GlFunction("glCheckNamedFramebufferStatus");
  PFNGLBINDFRAMEBUFFERPROC BindFramebuffer = GlFunction("glBindFramebuffer");
  PFNGLCREATEQUERIESPROC CreateQueries = GlFunction("glCreateQueries");

  // programs
  PFNGLCREATESHADERPROC CreateShader = GlFunction("glCreateShader");
  PFNGLSHADERSOURCEPROC ShaderSource = GlFunction("glShaderSource");
  PFNGLCOMPILESHADERPROC CompileShader = GlFunction("glCompileShader");
  PFNGLGETSHADERIVPROC GetShaderiv = GlFunction("glGetShaderiv");
  PFNGLGETSHADERINFOLOGPROC GetShaderInfoLog = GlFunction("glGetShaderInfoLog");
  PFNGLCREATEPROGRAMPROC CreateProgram = GlFunction("glCreateProgram");
  PFNGLATTACHSHADERPROC AttachShader = GlFunction("glAttachShader");
  PFNGLLINKPROGRAMPROC LinkProgram = GlFunction("glLinkProgram");
  PFNGLGETPROGRAMIVPROC GetProgramiv = GlFunction("glGetProgramiv");
  PFNGLGETPROGRAMINFOLOGPROC GetProgramInfoLog = GlFunction("glGetProgramInfoLog");
  PFNGLUSEPROGRAMPROC UseProgram = GlFunction("glUseProgram");
  PFNGLUNIFORM1FPROC Uniform1f = GlFunction("glUniform1f");
  PFNGLUNIFORM1UIPROC Uniform1ui = GlFunction("glUniform1ui");
  PFNGLUNIFORM3FVPROC Uniform3fv = GlFunction("glUniform3fv");
  PFNGLUNIFORMMATRIX4FVPROC UniformMatrix4fv = GlFunction("glUniformMatrix4fv");

  // state
  PFNGLGETSTRINGPROC GetString = GlFunction("glGetString");
  PFNGLGETERRORPROC GetError = GlFunction("glGetError");
  PFNGLGETINTEGERVPROC GetIntegerv = GlFunction("glGetIntegerv");
  PFNGLENABLEPROC Enable = GlFunction("glEnable");
  PFNGLDISABLEPROC Disable = GlFunction("glDisable");
  PFNGLVIEWPORTPROC Viewport = GlFunction("glViewport");
  PFNGLDEPTHFUNCPROC DepthFunc = GlFunction("glDepthFunc");
  PFNGLCLIPCONTROLPROC ClipControl = GlFunction("glClipControl");
  PFNGLCULLFACEPROC CullFace = GlFunction("glCullFace");
  PFNGLSTENCILFUNCPROC StencilFunc = GlFunction("glStencilFunc");
  PFNGLSTENCILOPPROC StencilOp = GlFunction("glStencilOp");
  PFNGLPIXELSTOREIPROC PixelStorei = GlFunction("glPixelStorei");

  // work
  PFNGLCLEARNAMEDFRAMEBUFFERFVPROC ClearNamedFramebufferfv =
      GlFunction("glClearNamedFramebufferfv");
  PFNGLCLEARNAMEDFRAMEBUFFERIVPROC ClearNamedFramebufferiv =
      GlFunction("glClearNamedFramebufferiv");
  PFNGLCLEARNAMEDFRAMEBUFFERUIVPROC ClearNamedFramebufferuiv =
      GlFunction("glClearNamedFramebufferuiv");
  PFNGLDRAWELEMENTSPROC DrawElements = GlFunction("glDrawElements");
  PFNGLDRAWARRAYSPROC DrawArrays = GlFunction("glDrawArrays");
  PFNGLBEGINQUERYPROC BeginQuery = GlFunction("glBeginQuery");
  PFNGLENDQUERYPROC EndQuery = GlFunction("glEndQuery");
  PFNGLGETQUERYOBJECTUIVPROC GetQueryObjectuiv = GlFunction("glGetQueryObjectuiv");
  PFNGLBLITNAMEDFRAMEBUFFERPROC BlitNamedFramebuffer = GlFunction("glBlitNamedFramebuffer");
  PFNGLREADPIXELSPROC ReadPixels = GlFunction("glReadPixels");
};

// Throws Error if an OpenGL call has failed since the last check. `where` names the operation.
void CheckGl(const Gl& gl, const char* where);

// An OpenGL 4.5 core context of llvmpipe with 256-bit vectors. Its OpenGL objects are freed with
// it. The constructor makes it current in the calling thread.
class GlContext {
 public:
  // Throws Error if such a context cannot be created.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  // To be called where another context may have become current.
  void MakeCurrent();
  const Gl& gl() const { return *gl_; }
  RendererVersion Version() const;

 private:
  struct OsMesa;
  std::unique_ptr<OsMesa> os_mesa_;
  std::unique_ptr<const Gl> gl_;
};

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

// GLSL sources. Lighting is computed in the body's frame, where normals need no rotation. Every
// program computes positions with the same expression, so that all passes cover the same pixels.
extern const char* const kColourVertexShader;
extern const char* const kColourFragmentShader;
extern const char* const kSkyVertexShader;
extern const char* const kSkyFragmentShader;
extern const char* const kPositionVertexShader;
extern const char* const kGroundTruthFragmentShader;
extern const char* const kEmptyFragmentShader;

// Uniform locations in these programs.
namespace uniform {
inline constexpr int kClipFromBody = 0;
inline constexpr int kShadowFromBody = 1;  // to shadow map coordinates in [0, 1]^3
inline constexpr int kEyeInBody = 2;
inline constexpr int kLightInBody = 3;  // towards the light, unit length
inline constexpr int kUpInBody = 4;
inline constexpr int kNormalOffset = 5;  // of the shadow lookup along the normal, m
inline constexpr int kGloss = 6;
inline constexpr int kDirectional = 7;
inline constexpr int kAmbient = 8;
inline constexpr int kBody = 9;
inline constexpr int kSky = 10;
inline constexpr int kWorldFromNdc = 11;  // maps (x, y, 1) to a direction in world
}  // namespace uniform

// Side of the shadow map. kColourFragmentShader repeats this value.
inline constexpr int kShadowSide_px = 2048;

// Texture units.
inline constexpr int kSurfaceUnit = 0;
inline constexpr int kShadowUnit = 1;

}  // namespace cvo::synth
