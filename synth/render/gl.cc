// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/render/gl.h"

#include <GL/osmesa.h>

#include "core/base/error.h"
#include "core/files/images/shared_library.h"

namespace cvo::synth {
namespace {

template <typename Function>
void Load(Function& function, const char* name) {
  static const auto find =
      FindFunction<decltype(OSMesaGetProcAddress)>(kOsMesa, "OSMesaGetProcAddress");
  function = reinterpret_cast<Function>(find(name));
  if (function == nullptr) ThrowError("OSMesa", StrCat("no function ", name), "OpenGL 4.5");
}

void LoadObjects(Gl& gl) {
  Load(gl.CreateBuffers, "glCreateBuffers");
  Load(gl.NamedBufferStorage, "glNamedBufferStorage");
  Load(gl.CreateVertexArrays, "glCreateVertexArrays");
  Load(gl.VertexArrayVertexBuffer, "glVertexArrayVertexBuffer");
  Load(gl.VertexArrayElementBuffer, "glVertexArrayElementBuffer");
  Load(gl.VertexArrayAttribFormat, "glVertexArrayAttribFormat");
  Load(gl.VertexArrayAttribBinding, "glVertexArrayAttribBinding");
  Load(gl.EnableVertexArrayAttrib, "glEnableVertexArrayAttrib");
  Load(gl.BindVertexArray, "glBindVertexArray");
  Load(gl.CreateTextures, "glCreateTextures");
  Load(gl.TextureStorage2D, "glTextureStorage2D");
  Load(gl.TextureSubImage2D, "glTextureSubImage2D");
  Load(gl.GenerateTextureMipmap, "glGenerateTextureMipmap");
  Load(gl.TextureParameteri, "glTextureParameteri");
  Load(gl.TextureParameterf, "glTextureParameterf");
  Load(gl.TextureParameterfv, "glTextureParameterfv");
  Load(gl.BindTextureUnit, "glBindTextureUnit");
  Load(gl.CreateRenderbuffers, "glCreateRenderbuffers");
  Load(gl.NamedRenderbufferStorageMultisample, "glNamedRenderbufferStorageMultisample");
  Load(gl.CreateFramebuffers, "glCreateFramebuffers");
  Load(gl.NamedFramebufferRenderbuffer, "glNamedFramebufferRenderbuffer");
  Load(gl.NamedFramebufferTexture, "glNamedFramebufferTexture");
  Load(gl.NamedFramebufferDrawBuffers, "glNamedFramebufferDrawBuffers");
  Load(gl.NamedFramebufferReadBuffer, "glNamedFramebufferReadBuffer");
  Load(gl.CheckNamedFramebufferStatus, "glCheckNamedFramebufferStatus");
  Load(gl.BindFramebuffer, "glBindFramebuffer");
  Load(gl.CreateQueries, "glCreateQueries");
}

void LoadPrograms(Gl& gl) {
  Load(gl.CreateShader, "glCreateShader");
  Load(gl.ShaderSource, "glShaderSource");
  Load(gl.CompileShader, "glCompileShader");
  Load(gl.GetShaderiv, "glGetShaderiv");
  Load(gl.GetShaderInfoLog, "glGetShaderInfoLog");
  Load(gl.CreateProgram, "glCreateProgram");
  Load(gl.AttachShader, "glAttachShader");
  Load(gl.LinkProgram, "glLinkProgram");
  Load(gl.GetProgramiv, "glGetProgramiv");
  Load(gl.GetProgramInfoLog, "glGetProgramInfoLog");
  Load(gl.UseProgram, "glUseProgram");
  Load(gl.Uniform1f, "glUniform1f");
  Load(gl.Uniform1ui, "glUniform1ui");
  Load(gl.Uniform3fv, "glUniform3fv");
  Load(gl.UniformMatrix4fv, "glUniformMatrix4fv");
}

void LoadStateAndWork(Gl& gl) {
  Load(gl.GetString, "glGetString");
  Load(gl.GetError, "glGetError");
  Load(gl.GetIntegerv, "glGetIntegerv");
  Load(gl.Enable, "glEnable");
  Load(gl.Disable, "glDisable");
  Load(gl.Viewport, "glViewport");
  Load(gl.DepthFunc, "glDepthFunc");
  Load(gl.ClipControl, "glClipControl");
  Load(gl.CullFace, "glCullFace");
  Load(gl.StencilFunc, "glStencilFunc");
  Load(gl.StencilOp, "glStencilOp");
  Load(gl.PixelStorei, "glPixelStorei");
  Load(gl.ClearNamedFramebufferfv, "glClearNamedFramebufferfv");
  Load(gl.ClearNamedFramebufferiv, "glClearNamedFramebufferiv");
  Load(gl.ClearNamedFramebufferuiv, "glClearNamedFramebufferuiv");
  Load(gl.DrawElements, "glDrawElements");
  Load(gl.DrawArrays, "glDrawArrays");
  Load(gl.BeginQuery, "glBeginQuery");
  Load(gl.EndQuery, "glEndQuery");
  Load(gl.GetQueryObjectuiv, "glGetQueryObjectuiv");
  Load(gl.BlitNamedFramebuffer, "glBlitNamedFramebuffer");
  Load(gl.ReadPixels, "glReadPixels");
}

}  // namespace

Gl LoadGl() {
  Gl gl = {};
  LoadObjects(gl);
  LoadPrograms(gl);
  LoadStateAndWork(gl);
  return gl;
}

void CheckGl(const Gl& gl, const char* where) {
  const GLenum error = gl.GetError();
  if (error == GL_NO_ERROR) return;
  ThrowError(where, error == GL_OUT_OF_MEMORY ? "out of memory" : StrCat("OpenGL error ", error),
             "no OpenGL error");
}

}  // namespace cvo::synth
