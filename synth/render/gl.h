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
  operator Function*() const {  // NOLINT: implicit, for the table below
    return reinterpret_cast<Function*>(found_);
  }

 private:
  void (*found_)();
};

#define CVO_GL(type, name) PFNGL##type##PROC name = GlFunction("gl" #name)

// The OpenGL 4.5 functions in use, named without their prefix, and valid in every context.
struct Gl {
  // objects
  CVO_GL(CREATEBUFFERS, CreateBuffers);
  CVO_GL(NAMEDBUFFERSTORAGE, NamedBufferStorage);
  CVO_GL(CREATEVERTEXARRAYS, CreateVertexArrays);
  CVO_GL(VERTEXARRAYVERTEXBUFFER, VertexArrayVertexBuffer);
  CVO_GL(VERTEXARRAYELEMENTBUFFER, VertexArrayElementBuffer);
  CVO_GL(VERTEXARRAYATTRIBFORMAT, VertexArrayAttribFormat);
  CVO_GL(VERTEXARRAYATTRIBBINDING, VertexArrayAttribBinding);
  CVO_GL(ENABLEVERTEXARRAYATTRIB, EnableVertexArrayAttrib);
  CVO_GL(BINDVERTEXARRAY, BindVertexArray);
  CVO_GL(CREATETEXTURES, CreateTextures);
  CVO_GL(TEXTURESTORAGE2D, TextureStorage2D);
  CVO_GL(TEXTURESUBIMAGE2D, TextureSubImage2D);
  CVO_GL(GENERATETEXTUREMIPMAP, GenerateTextureMipmap);
  CVO_GL(TEXTUREPARAMETERI, TextureParameteri);
  CVO_GL(TEXTUREPARAMETERF, TextureParameterf);
  CVO_GL(TEXTUREPARAMETERFV, TextureParameterfv);
  CVO_GL(BINDTEXTUREUNIT, BindTextureUnit);
  CVO_GL(CREATERENDERBUFFERS, CreateRenderbuffers);
  CVO_GL(NAMEDRENDERBUFFERSTORAGEMULTISAMPLE, NamedRenderbufferStorageMultisample);
  CVO_GL(CREATEFRAMEBUFFERS, CreateFramebuffers);
  CVO_GL(NAMEDFRAMEBUFFERRENDERBUFFER, NamedFramebufferRenderbuffer);
  CVO_GL(NAMEDFRAMEBUFFERTEXTURE, NamedFramebufferTexture);
  CVO_GL(NAMEDFRAMEBUFFERDRAWBUFFERS, NamedFramebufferDrawBuffers);
  CVO_GL(NAMEDFRAMEBUFFERREADBUFFER, NamedFramebufferReadBuffer);
  CVO_GL(CHECKNAMEDFRAMEBUFFERSTATUS, CheckNamedFramebufferStatus);
  CVO_GL(BINDFRAMEBUFFER, BindFramebuffer);
  CVO_GL(CREATEQUERIES, CreateQueries);

  // programs
  CVO_GL(CREATESHADER, CreateShader);
  CVO_GL(SHADERSOURCE, ShaderSource);
  CVO_GL(COMPILESHADER, CompileShader);
  CVO_GL(GETSHADERIV, GetShaderiv);
  CVO_GL(GETSHADERINFOLOG, GetShaderInfoLog);
  CVO_GL(CREATEPROGRAM, CreateProgram);
  CVO_GL(ATTACHSHADER, AttachShader);
  CVO_GL(LINKPROGRAM, LinkProgram);
  CVO_GL(GETPROGRAMIV, GetProgramiv);
  CVO_GL(GETPROGRAMINFOLOG, GetProgramInfoLog);
  CVO_GL(USEPROGRAM, UseProgram);
  CVO_GL(UNIFORM1F, Uniform1f);
  CVO_GL(UNIFORM1UI, Uniform1ui);
  CVO_GL(UNIFORM3FV, Uniform3fv);
  CVO_GL(UNIFORMMATRIX4FV, UniformMatrix4fv);

  // state
  CVO_GL(GETSTRING, GetString);
  CVO_GL(GETERROR, GetError);
  CVO_GL(GETINTEGERV, GetIntegerv);
  CVO_GL(ENABLE, Enable);
  CVO_GL(DISABLE, Disable);
  CVO_GL(VIEWPORT, Viewport);
  CVO_GL(DEPTHFUNC, DepthFunc);
  CVO_GL(CLIPCONTROL, ClipControl);
  CVO_GL(CULLFACE, CullFace);
  CVO_GL(STENCILFUNC, StencilFunc);
  CVO_GL(STENCILOP, StencilOp);
  CVO_GL(PIXELSTOREI, PixelStorei);

  // work
  CVO_GL(CLEARNAMEDFRAMEBUFFERFV, ClearNamedFramebufferfv);
  CVO_GL(CLEARNAMEDFRAMEBUFFERIV, ClearNamedFramebufferiv);
  CVO_GL(CLEARNAMEDFRAMEBUFFERUIV, ClearNamedFramebufferuiv);
  CVO_GL(DRAWELEMENTS, DrawElements);
  CVO_GL(DRAWARRAYS, DrawArrays);
  CVO_GL(BEGINQUERY, BeginQuery);
  CVO_GL(ENDQUERY, EndQuery);
  CVO_GL(GETQUERYOBJECTUIV, GetQueryObjectuiv);
  CVO_GL(BLITNAMEDFRAMEBUFFER, BlitNamedFramebuffer);
  CVO_GL(READPIXELS, ReadPixels);
};

#undef CVO_GL

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
