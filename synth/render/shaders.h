// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cvo::synth {

// GLSL. All lighting is in the body's frame, where normals need no rotation. Positions go through
// the same expression in every program, so that all passes cover the same pixels.
extern const char* const kColourVertexShader;
extern const char* const kColourFragmentShader;
extern const char* const kSkyVertexShader;
extern const char* const kSkyFragmentShader;
extern const char* const kPositionVertexShader;
extern const char* const kGroundTruthFragmentShader;
extern const char* const kEmptyFragmentShader;

// Locations of uniforms in these programs.
namespace uniform {
inline constexpr int kClipFromBody = 0;
inline constexpr int kShadowFromBody = 1;  // to [0, 1]^3 of the shadow map
inline constexpr int kEyeInBody = 2;
inline constexpr int kLightInBody = 3;  // towards the light, unit length
inline constexpr int kUpInBody = 4;
inline constexpr int kNormalOffset = 5;  // of where the shadow is looked up, m
inline constexpr int kGloss = 6;
inline constexpr int kDirectional = 7;
inline constexpr int kAmbient = 8;
inline constexpr int kBody = 9;
inline constexpr int kSky = 10;
inline constexpr int kWorldFromNdc = 11;  // a direction in world from (x, y, 1)
}  // namespace uniform

// Of the shadow map; the colour shader knows it too.
inline constexpr int kShadowSide_px = 2048;

// Texture units.
inline constexpr int kSurfaceUnit = 0;
inline constexpr int kShadowUnit = 1;

}  // namespace cvo::synth
