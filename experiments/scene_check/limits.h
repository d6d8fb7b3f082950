// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The limits of `clustervo synth check`, each with its reason.

namespace cvo::limits {

// Images against depth and poses. A slip of half a pixel in the pixel-centre convention shows as
// 0.5 px, an error of one per cent of depth as 0.2 px at 20 px of disparity; interpolation and
// noise stay below 0.02 px.
constexpr double kShift_px = 0.05;
// For a single pair of consecutive frames, where shadows that move over the background count too.
// All frames together would hide a single wrong pose, as the errors of its two steps cancel.
constexpr double kFrameShift_px = 0.1;
// Fewer pixels cannot distinguish such a shift from noise.
constexpr int kMinShiftPixels = 2000;
// A shift with a larger standard deviation, as that of a small or plain body, is not evaluated.
constexpr double kMaxShiftSigma_px = 0.01;
// Residuals relative to the noise of the difference of two images; interpolated edges add to the
// noise. The grey levels are an allowance for interpolation, without which a scene free of noise
// would fail.
constexpr double kMedianResidual_sigmas = 2.0;
constexpr double kTailResidual_sigmas = 6.0;
constexpr double kInterpolation_grey = 1.5;
constexpr double kTailInterpolation_grey = 9.0;
// The light does not turn with a body: the shade of a ball that rolls at 0.8 m/s changes by some
// grey levels from frame to frame. A wrong rotation leaves residuals of 20 and more.
constexpr double kShading_grey = 6.0;
// Depth moved to the next frame, compared with that frame's depth, as disparity. Exact on planes
// except for 32-bit rounding.
constexpr double kDepthMotion_px = 0.01;
// KITTI's quantisation of flow causes errors of up to 1/128 px; depth is rounded to 32 bits.
constexpr double kFlow_px = 1.0 / 64.0;

// Points of a mask against the body's box: tessellated surfaces stay inside it, but depth buffers
// are quantised.
constexpr double kBoxTolerance_m = 0.02;
constexpr double kBoxTolerancePerDepth = 5e-4;
constexpr double kHull_px = 1.0;

// Values repeated in several text files agree to at least this precision.
constexpr double kBoxText_px = 0.01;
constexpr double kLabelText_m = 1e-3;
constexpr double kLabelText_rad = 1e-3;
constexpr double kLabelText_fraction = 1e-3;
constexpr double kFractionText = 1e-6;
// KITTI's labels only allow a rotation about the camera's y axis. The label of a body tilted by
// more than this can only be approximate.
constexpr double kMaxTilt_rad = 0.1;

constexpr double kBaseline_m = 1e-6;
constexpr double kBaselineRotation_rad = 1e-6;
// Velocities against central differences of poses, whose own error is jerk dt^2 / 6: 2 mm/s for a
// block that swings once in 2 s at 30 Hz.
constexpr double kVelocity_mps = 0.05;
constexpr double kAngularVelocity_radps = 0.1;
constexpr double kVelocityShare = 0.02;

// A slip of half a pixel in the pixel-centre convention would show as 0.5 px. The corner finder
// itself is accurate to 0.034 px, and to 0.002 px on average.
constexpr double kTargetCorner_px = 0.05;
constexpr double kMinTargetCorners = 50;

// What the front end must find, as the estimators are tuned for such numbers. Of 2000 corners
// spread evenly over 640x480 pixels about 1200 find a stereo match, one per 260 px. A mover needs
// more texture than its surroundings.
constexpr double kMatches = 600;
constexpr double kFramesWithMatches = 0.95;
constexpr int kMinMoverPixels = 2400;
constexpr double kPixelsPerMatch = 200;
constexpr double kMinUnoccludedFraction = 0.9;
// Reach of the descriptors at the finest pyramid level.
constexpr int kDescriptorBorder_px = 16;
// Radius of the corner detector's ring, plus one pixel.
constexpr int kCornerRadius_px = 4;
// Boxes with fewer matches are not evaluated.
constexpr int kMinBoxMatches = 10;
// For medians over all matches; single matches scatter by 0.1 to 0.3 px.
constexpr double kMatchDisparityBias_px = 0.1;
constexpr double kMatchDisparity_px = 0.3;

}  // namespace cvo::limits
