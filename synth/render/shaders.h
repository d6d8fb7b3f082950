// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cvo::synth {

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
