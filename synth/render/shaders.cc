// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/render/gl.h"

namespace cvo::synth {

const char* const kColourVertexShader = R"glsl(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec2 vertex_uv;
layout(location = 0) uniform mat4 clip_from_body;
layout(location = 1) uniform mat4 shadow_from_body;
layout(location = 2) uniform vec3 eye;
out vec3 normal;
out vec3 to_eye;
out vec3 shadow_position;
out vec2 uv;
invariant gl_Position;
void main() {
  gl_Position = clip_from_body * vec4(position, 1.0);
  normal = vertex_normal;
  to_eye = eye - position;
  shadow_position = (shadow_from_body * vec4(position, 1.0)).xyz;
  uv = vertex_uv;
}
)glsl";

// Surfaces are two-sided: the normal is turned to the visible side. That side is found from the
// triangle itself, because a smooth normal near a silhouette may point away from the viewer.
// Shadows are looked up slightly off the surface (further at grazing light) and fade out at the
// border of the map.
const char* const kColourFragmentShader = R"glsl(#version 450 core
in vec3 normal;
in vec3 to_eye;
in vec3 shadow_position;
in vec2 uv;
layout(location = 1) uniform mat4 shadow_from_body;
layout(location = 3) uniform vec3 light;
layout(location = 4) uniform vec3 up;
layout(location = 5) uniform float normal_offset;
layout(location = 6) uniform float gloss;
layout(location = 7) uniform float directional;
layout(location = 8) uniform float ambient;
layout(binding = 0) uniform sampler2D surface;
layout(binding = 1) uniform sampler2DShadow shadow_map;
layout(location = 0) out vec4 colour;

float Lit(vec3 n, float facing) {
  vec3 offset = n * (normal_offset * (2.0 - facing));
  vec3 at = shadow_position + mat3(shadow_from_body) * offset;
  const float step = 0.75 / 2048.0;
  float lit = texture(shadow_map, at + vec3(-step, -step, 0.0)) +
              texture(shadow_map, at + vec3(step, -step, 0.0)) +
              texture(shadow_map, at + vec3(-step, step, 0.0)) +
              texture(shadow_map, at + vec3(step, step, 0.0));
  vec2 from_middle = abs(2.0 * at.xy - 1.0);
  float fade = clamp(10.0 * max(from_middle.x, from_middle.y) - 9.0, 0.0, 1.0);
  return mix(0.25 * lit, 1.0, fade);
}

void main() {
  vec3 view = normalize(to_eye);
  vec3 n = normalize(normal);
  vec3 face = cross(dFdx(to_eye), dFdy(to_eye));
  if (dot(face, n) * dot(face, view) < 0.0) n = -n;
  float facing = clamp(dot(n, light), 0.0, 1.0);
  float direct = facing > 0.0 ? directional * Lit(n, facing) : 0.0;
  float around = ambient * (5.0 / 6.0 + dot(n, up) / 6.0);
  float shine = clamp(dot(n, normalize(view + light)), 0.0, 1.0);
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  vec3 rgb = texture(surface, uv).rgb * (around + direct * facing) + gloss * direct * shine;
  rgb = clamp(rgb, 0.0, 1.0);
  colour = vec4(rgb, dot(rgb, vec3(0.299, 0.587, 0.114)));
}
)glsl";

// Draws at depth 0, which is at infinity.
const char* const kSkyVertexShader = R"glsl(#version 450 core
layout(location = 11) uniform mat4 world_from_ndc;
out vec3 direction;
void main() {
  vec2 ndc = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(ndc, 0.0, 1.0);
  direction = mat3(world_from_ndc) * vec3(ndc, 1.0);
}
)glsl";

const char* const kSkyFragmentShader = R"glsl(#version 450 core
in vec3 direction;
layout(location = 10) uniform vec3 sky;
layout(location = 0) out vec4 colour;
void main() {
  float height = clamp(normalize(direction).z, 0.0, 1.0);
  vec3 rgb = mix(mix(sky, vec3(1.0), 0.3), 0.85 * sky, sqrt(height));
  rgb = clamp(rgb, 0.0, 1.0);
  colour = vec4(rgb, dot(rgb, vec3(0.299, 0.587, 0.114)));
}
)glsl";

const char* const kPositionVertexShader = R"glsl(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 0) uniform mat4 clip_from_body;
invariant gl_Position;
void main() { gl_Position = clip_from_body * vec4(position, 1.0); }
)glsl";

const char* const kGroundTruthFragmentShader = R"glsl(#version 450 core
layout(location = 9) uniform uint body;
layout(location = 0) out float depth;
layout(location = 1) out uint instance;
void main() {
  depth = 1.0 / gl_FragCoord.w;
  instance = body;
}
)glsl";

const char* const kEmptyFragmentShader = R"glsl(#version 450 core
void main() {}
)glsl";

}  // namespace cvo::synth
