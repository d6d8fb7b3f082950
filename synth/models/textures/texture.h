// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <string>

#include "core/base/rng.h"

namespace cvo::synth {

struct Texture {
  cv::Mat image;                                     // CV_8UC3, RGB, sides are powers of two
  Eigen::Vector2d size_m = Eigen::Vector2d::Ones();  // of one repetition along u and v
};

// Makes one of MaterialNames() (synth/models/make_model.h). Throws Error for an unknown name.
Texture MakeTexture(const std::string& material, Rng& look);

// Makes six square views from the centre of a ball, in a grid of 4 x 2 and in the face order of
// AddBall.
Texture MakeBallTexture(Rng& look);
// Fraction of the side of a tile that its face covers. The pattern continues beyond the face for
// the sake of mipmaps.
constexpr double kBallTileFill = 0.9;

// Textures of small things, one picture each.
Texture MakeSolidTexture(const cv::Vec3f& rgb, Rng& look);
Texture MakeWindowViewTexture(Rng& look);
Texture MakeDoorTexture(Rng& look);
Texture MakeCarGlassTexture(Rng& look);
Texture MakeWheelTexture(Rng& look);
Texture MakePlateTexture(Rng& look);
// Spines of books in a grid of kBookColumns x kBookRows.
Texture MakeBooksTexture(Rng& look);
constexpr int kBookColumns = 16;
constexpr int kBookRows = 2;

}  // namespace cvo::synth
