// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Guaranteed and tested: the same bytes from run to run, with the same Mesa and LLVM on the same
// processor. Mesa is restricted to AVX and 256-bit vectors so that other processors with AVX should
// give these bytes as well, which has not been tested. Not guaranteed: another version of Mesa or
// LLVM, or another architecture. Without AVX, Error is thrown. GL_RENDERER shows the vector width
// but not the instruction set, so it goes unnoticed if the process has already made a context with
// other settings.
#include "synth/render/renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/base/error.h"
#include "synth/render/gl.h"

namespace cvo::synth {
namespace {

constexpr int kStencilValues = 255;

void CheckWorld(const World& world) {
  world.rig.Check();
  const auto is_index = [](int i, std::size_t size) {
    return i >= 0 && static_cast<std::size_t>(i) < size;
  };
  for (const Drawable& drawable : world.drawables) {
    Require(is_index(drawable.mesh, world.meshes.size()) &&
                is_index(drawable.texture, world.textures.size()) &&
                is_index(drawable.body, world.bodies.size() + 1),
            "drawable: its mesh, texture and body are in the world");
  }
}

}  // namespace

enum Eye { kLeft, kRight };

// The passes over a world that make up a rendering.
class Passes {
 public:
  explicit Passes(const World& world)
      : gl_(context_.gl()), rig_(world.rig), rig_error_(world.rig_error), light_(world.light) {
    CheckWorld(world);
    for (const Mesh& mesh : world.meshes) meshes_.push_back(UploadMesh(gl_, mesh));
    for (const cv::Mat& texture : world.textures) textures_.push_back(UploadTexture(gl_, texture));
    for (const Drawable& drawable : world.drawables) {
      if (meshes_[static_cast<std::size_t>(drawable.mesh)].indices > 0) {
        drawables_.push_back(drawable);
      }
    }
    queries_.resize(world.bodies.size());
    if (!queries_.empty()) {
      gl_.CreateQueries(GL_SAMPLES_PASSED, static_cast<GLsizei>(queries_.size()), queries_.data());
    }
    gl_.CreateVertexArrays(1, &sky_vertices_);
    colour_program_ = CompileProgram(gl_, kColourVertexShader, kColourFragmentShader);
    sky_program_ = CompileProgram(gl_, kSkyVertexShader, kSkyFragmentShader);
    ground_truth_program_ = CompileProgram(gl_, kPositionVertexShader, kGroundTruthFragmentShader);
    position_program_ = CompileProgram(gl_, kPositionVertexShader, kEmptyFragmentShader);
    targets_ = MakeTargets(gl_, rig_.width_px, rig_.height_px, kShadowSide_px);
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    CheckGl(gl_, "preparing to render");
  }

  // Draws both images.
  void DrawImages(const View& view) {
    Begin(view);
    DrawShadows();
    DrawColour(kLeft);
    DrawColour(kRight);
  }

  void Begin(const View& view) {
    Require(view.world_from_body.size() == queries_.size(), "view: one pose for each body");
    context_.MakeCurrent();
    world_from_left_ = view.world_from_left;
    const Eigen::Matrix4d left_from_world = world_from_left_.Inverse().Matrix();
    clip_from_world_[kLeft] = ClipFromLeft(rig_) * left_from_world;
    clip_from_world_[kRight] = ClipFromRight(rig_, rig_error_) * left_from_world;
    const Eigen::Vector3d camera_in_world = world_from_left_.translation();
    shadow_clip_from_world_ = ShadowClipFromWorld(light_, camera_in_world, kShadowSide_px);
    Eigen::Matrix4d map_from_clip = Eigen::Matrix4d::Identity();
    map_from_clip.topLeftCorner<2, 2>() *= 0.5;
    map_from_clip.topRightCorner<2, 1>().setConstant(0.5);
    shadow_map_from_world_ = map_from_clip * shadow_clip_from_world_;

    placed_.clear();
    for (const Drawable& drawable : drawables_) {
      const GlMesh& mesh = meshes_[static_cast<std::size_t>(drawable.mesh)];
      RigidTransform world_from_body;
      if (drawable.body > 0) {
        world_from_body = view.world_from_body[static_cast<std::size_t>(drawable.body - 1)];
      }
      const Eigen::Vector3d from_camera = world_from_body * mesh.sphere.centre - camera_in_world;
      placed_.push_back(
          {&drawable, &mesh, world_from_body.Matrix(), from_camera.norm() + mesh.sphere.radius});
    }
    std::stable_sort(placed_.begin(), placed_.end(),
                     [](const Placed& a, const Placed& b) { return a.farthest_m < b.farthest_m; });
  }

  void DrawShadows() {
    UseTarget(targets_.shadow, kShadowSide_px, kShadowSide_px);
    gl_.CullFace(GL_BACK);
    gl_.UseProgram(position_program_);
    for (const Placed& placed : placed_) {
      const Eigen::Matrix4d clip_from_body = shadow_clip_from_world_ * placed.world_from_body;
      if (!placed.drawable->casts_shadow || !MayBeVisible(clip_from_body, placed.mesh->sphere)) {
        continue;
      }
      SetMatrix(uniform::kClipFromBody, clip_from_body);
      DrawMesh(*placed.mesh);
    }
  }

  // After DrawShadows.
  void DrawColour(Eye eye) {
    const GLuint target = targets_.samples[eye];
    UseTarget(target, rig_.width_px, rig_.height_px);
    gl_.UseProgram(colour_program_);
    gl_.Uniform1f(uniform::kDirectional, static_cast<float>(light_.directional));
    gl_.Uniform1f(uniform::kAmbient, static_cast<float>(light_.ambient));
    gl_.Uniform1f(uniform::kNormalOffset,
                  static_cast<float>(2.0 * light_.shadow_range_m / kShadowSide_px));
    gl_.BindTextureUnit(kShadowUnit, targets_.shadow_map);
    for (const Placed& placed : placed_) {
      const Eigen::Matrix4d clip_from_body = clip_from_world_[eye] * placed.world_from_body;
      if (!MayBeVisible(clip_from_body, placed.mesh->sphere)) continue;
      SetMatrix(uniform::kClipFromBody, clip_from_body);
      SetLighting(placed, eye);
      gl_.BindTextureUnit(kSurfaceUnit,
                          textures_[static_cast<std::size_t>(placed.drawable->texture)]);
      DrawMesh(*placed.mesh);
    }
    DrawSky(eye);
    gl_.BlitNamedFramebuffer(target, targets_.colour[eye], 0, 0, rig_.width_px, rig_.height_px, 0,
                             0, rig_.width_px, rig_.height_px, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }

  void DrawGroundTruth() {
    UseTarget(targets_.ground_truth, rig_.width_px, rig_.height_px);
    const float nothing[4] = {};
    const GLuint background[4] = {};
    gl_.ClearNamedFramebufferfv(targets_.ground_truth, GL_COLOR, 0, nothing);
    gl_.ClearNamedFramebufferuiv(targets_.ground_truth, GL_COLOR, 1, background);
    gl_.UseProgram(ground_truth_program_);
    for (const Placed& placed : placed_) {
      const Eigen::Matrix4d clip_from_body = clip_from_world_[kLeft] * placed.world_from_body;
      if (!MayBeVisible(clip_from_body, placed.mesh->sphere)) continue;
      SetMatrix(uniform::kClipFromBody, clip_from_body);
      gl_.Uniform1ui(uniform::kBody, static_cast<GLuint>(placed.drawable->body));
      DrawMesh(*placed.mesh);
    }
  }

  // Each body marks its pixels in the stencil buffer with its own value, so that a pixel counts
  // once however many triangles of the body cover it.
  void DrawSilhouettes() {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, targets_.silhouette);
    gl_.Viewport(0, 0, rig_.width_px, rig_.height_px);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Enable(GL_STENCIL_TEST);
    gl_.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl_.UseProgram(position_program_);
    query_is_set_.assign(queries_.size(), false);
    int value = kStencilValues;
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      for (const Placed& placed : placed_) {
        if (static_cast<std::size_t>(placed.drawable->body) != i + 1) continue;
        const Eigen::Matrix4d clip_from_body = clip_from_world_[kLeft] * placed.world_from_body;
        if (!MayBeVisible(clip_from_body, placed.mesh->sphere)) continue;
        if (!query_is_set_[i]) {
          if (value == kStencilValues) {
            value = 0;
            gl_.ClearNamedFramebufferiv(targets_.silhouette, GL_STENCIL, 0, &value);
          }
          gl_.StencilFunc(GL_NOTEQUAL, ++value, 0xff);
          gl_.BeginQuery(GL_SAMPLES_PASSED, queries_[i]);
          query_is_set_[i] = true;
        }
        SetMatrix(uniform::kClipFromBody, clip_from_body);
        DrawMesh(*placed.mesh);
      }
      if (query_is_set_[i]) gl_.EndQuery(GL_SAMPLES_PASSED);
    }
  }

  cv::Mat ReadColour(Eye eye) {
    return Read(targets_.colour[eye], GL_COLOR_ATTACHMENT0, GL_RGBA, GL_UNSIGNED_BYTE, CV_8UC4);
  }

  cv::Mat ReadDepth() {
    return Read(targets_.ground_truth, GL_COLOR_ATTACHMENT0, GL_RED, GL_FLOAT, CV_32FC1);
  }

  cv::Mat ReadInstances() {
    return Read(targets_.ground_truth, GL_COLOR_ATTACHMENT1, GL_RED_INTEGER, GL_UNSIGNED_SHORT,
                CV_16UC1);
  }

  std::vector<int> ReadAlone() {
    std::vector<int> alone_px(queries_.size(), 0);
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      GLuint pixels = 0;
      if (query_is_set_[i]) gl_.GetQueryObjectuiv(queries_[i], GL_QUERY_RESULT, &pixels);
      alone_px[i] = static_cast<int>(pixels);
    }
    return alone_px;
  }

  // Throws Error if an OpenGL call has failed.
  void Check() { CheckGl(gl_, "rendering"); }

 private:
  // A drawable with its pose in the current view.
  struct Placed {
    const Drawable* drawable;
    const GlMesh* mesh;
    Eigen::Matrix4d world_from_body;
    double farthest_m;  // upper bound of its distance from the camera
  };

  void SetMatrix(int location, const Eigen::Matrix4d& matrix) {
    const Eigen::Matrix4f values = matrix.cast<float>();
    gl_.UniformMatrix4fv(location, 1, GL_FALSE, values.data());
  }

  void SetVector(int location, const Eigen::Vector3d& vector) {
    const Eigen::Vector3f values = vector.cast<float>();
    gl_.Uniform3fv(location, 1, values.data());
  }

  void SetLighting(const Placed& placed, Eye eye) {
    const Eigen::Matrix3d body_from_world =
        placed.world_from_body.topLeftCorner<3, 3>().transpose();
    const Eigen::Vector3d eye_in_left(eye == kLeft ? 0.0 : rig_.baseline_m, 0.0, 0.0);
    const Eigen::Vector3d body_in_world = placed.world_from_body.topRightCorner<3, 1>();
    SetMatrix(uniform::kShadowFromBody, shadow_map_from_world_ * placed.world_from_body);
    SetVector(uniform::kEyeInBody,
              body_from_world * (world_from_left_ * eye_in_left - body_in_world));
    SetVector(uniform::kLightInBody, body_from_world * -light_.direction.normalized());
    SetVector(uniform::kUpInBody, body_from_world.col(2));
    gl_.Uniform1f(uniform::kGloss, placed.drawable->gloss);
  }

  // Clears depth, if the framebuffer has any, to infinity.
  void UseTarget(GLuint framebuffer, int width_px, int height_px) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl_.Viewport(0, 0, width_px, height_px);
    gl_.Disable(GL_STENCIL_TEST);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GREATER);
    gl_.CullFace(GL_FRONT);  // rows go down, so counter-clockwise triangles become clockwise
    const float far = 0.0F;
    gl_.ClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &far);
  }

  // Culls back faces that cannot be seen. They would cost as much as front faces, because with
  // multisampling the rasteriser also shades hidden pixels.
  void DrawMesh(const GlMesh& mesh) {
    mesh.two_sided ? gl_.Disable(GL_CULL_FACE) : gl_.Enable(GL_CULL_FACE);
    gl_.BindVertexArray(mesh.vertex_array);
    gl_.DrawElements(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_INT, nullptr);
  }

  void DrawSky(Eye eye) {
    const Eigen::Matrix4d clip_from_left =
        eye == kLeft ? ClipFromLeft(rig_) : ClipFromRight(rig_, rig_error_);
    Eigen::Matrix3d ndc_from_left;
    ndc_from_left << clip_from_left.topLeftCorner<2, 3>(), clip_from_left.block<1, 3>(3, 0);
    Eigen::Matrix4d world_from_ndc = Eigen::Matrix4d::Identity();
    world_from_ndc.topLeftCorner<3, 3>() =
        world_from_left_.RotationMatrix() * ndc_from_left.inverse();
    gl_.DepthFunc(GL_GEQUAL);
    gl_.UseProgram(sky_program_);
    SetMatrix(uniform::kWorldFromNdc, world_from_ndc);
    SetVector(uniform::kSky, light_.sky_rgb);
    gl_.Disable(GL_CULL_FACE);
    gl_.BindVertexArray(sky_vertices_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  }

  cv::Mat Read(GLuint framebuffer, GLenum attachment, GLenum format, GLenum gl_type, int type) {
    cv::Mat image(rig_.height_px, rig_.width_px, type);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl_.NamedFramebufferReadBuffer(framebuffer, attachment);
    gl_.ReadPixels(0, 0, image.cols, image.rows, format, gl_type, image.data);
    return image;
  }

  GlContext context_;
  const Gl& gl_;
  StereoCamera rig_;
  RigError rig_error_;
  Light light_;
  std::vector<Drawable> drawables_;
  std::vector<GlMesh> meshes_;
  std::vector<GLuint> textures_;
  std::vector<GLuint> queries_;     // [id - 1]
  std::vector<bool> query_is_set_;  // [id - 1], in the current view
  GLuint sky_vertices_ = 0;
  GLuint colour_program_ = 0;
  GLuint sky_program_ = 0;
  GLuint ground_truth_program_ = 0;
  GLuint position_program_ = 0;
  Targets targets_;

  RigidTransform world_from_left_;
  Eigen::Matrix4d clip_from_world_[2];
  Eigen::Matrix4d shadow_clip_from_world_;
  Eigen::Matrix4d shadow_map_from_world_;
  std::vector<Placed> placed_;  // sorted from near to far
};

struct Renderer::State {
  Passes passes;
  StereoCamera rig;
  std::vector<Body> bodies;
};

Renderer::Renderer(const World& world)
    : state_(new State{Passes(world), world.rig, world.bodies}) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Rendering Renderer::Draw(const View& view) {
  Passes& passes = state_->passes;
  passes.DrawImages(view);
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
  passes.DrawImages(view);
  left = passes.ReadColour(kLeft);
  right = passes.ReadColour(kRight);
  passes.Check();
}

RendererVersion FindRendererVersion() { return GlContext().Version(); }

}  // namespace cvo::synth
