// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What `clustervo synth check` lets pass, each with its reason.

namespace cvo::limits {

// Images against depth and poses. A half-pixel slip is 0.5 px, one per cent of depth at 20 px of
// disparity 0.2 px; interpolation and noise stay below 0.02 px.
constexpr double kShift_px = 0.05;
// Of one frame to the next, where shadows that move over the background count too. All frames
// together would not see one faulty pose, whose two steps cancel.
constexpr double kFrameShift_px = 0.1;
// Fewer pixels cannot tell such a shift from noise.
constexpr int kMinShiftPixels = 2000;
// Standard deviation above which the shift of a small or plain body says nothing.
constexpr double kMaxShiftSigma_px = 0.01;
// Residuals over the noise of a difference of two images: interpolated edges add to the noise. The
// grey levels added are those of interpolation, without which a scene free of noise would fail.
constexpr double kMedianResidual_sigmas = 2.0;
constexpr double kTailResidual_sigmas = 6.0;
constexpr double kInterpolation_grey = 1.5;
constexpr double kTailInterpolation_grey = 9.0;
// The light stays where it is while a body turns: a ball that rolls at 0.8 m/s changes its shade by
// some grey levels from frame to frame. A rotation that is wrong leaves 20 and more.
constexpr double kShading_grey = 6.0;
// Depth moved from a frame to the next one against that one's depth, as disparity. Exact on planes
// but for 32-bit rounding.
constexpr double kDepthMotion_px = 0.01;
// Quantisation of KITTI's flow is 1/128 px either way; depth is rounded to 32 bits.
constexpr double kFlow_px = 1.0 / 64.0;

// Points of a mask against the body's box: tessellation stays inside; depth buffers quantise.
constexpr double kBoxTolerance_m = 0.02;
constexpr double kBoxTolerancePerDepth = 5e-4;
constexpr double kHull_px = 1.0;

// Text files repeat each other with at least this many decimals.
constexpr double kBoxText_px = 0.01;
constexpr double kLabelText_m = 1e-3;
constexpr double kLabelText_rad = 1e-3;
constexpr double kFractionText = 1e-6;
// KITTI's labels allow a rotation about the camera's y axis only; bodies beyond this tilt have
// labels that can only be near.
constexpr double kMaxTilt_rad = 0.1;

constexpr double kBaseline_m = 1e-6;
constexpr double kBaselineRotation_rad = 1e-6;
// Velocities against central differences of poses, whose own error is jerk dt^2 / 6: 2 mm/s for a
// block that swings once in 2 s at 30 Hz.
constexpr double kVelocity_mps = 0.05;
constexpr double kAngularVelocity_radps = 0.1;
constexpr double kVelocityShare = 0.02;

// The half-pixel error is 0.5 px; the corner finder itself is good to 0.034 px, 0.002 px on
// average.
constexpr double kTargetCorner_px = 0.05;
constexpr double kMinTargetCorners = 50;

// What the front end must find: the estimators are tuned for such numbers. Of 2000 corners spread
// evenly over 640x480 about 1200 find a partner, one per 260 px: a mover needs more texture than
// its surroundings.
constexpr double kMatches = 600;
constexpr double kFramesWithMatches = 0.95;
constexpr int kMinMoverPixels = 2400;
constexpr double kPixelsPerMatch = 200;
constexpr double kMinUnoccludedFraction = 0.9;
// Of the descriptors, at the finest level.
constexpr int kDescriptorBorder_px = 16;
// The ring of the corner detector and one pixel more.
constexpr int kCornerRadius_px = 4;
// Fewer matches in a box say nothing about what they are on.
constexpr int kMinBoxMatches = 10;
// Median over all matches; the spread of single matches is 0.1 to 0.3 px.
constexpr double kMatchDisparityBias_px = 0.1;
constexpr double kMatchDisparity_px = 0.3;

}  // namespace cvo::limits
