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

// One of MaterialNames() (synth/models/make_model.h). Throws Error for another name.
Texture MakeTexture(const std::string& material, Rng& look);

// Six square views from a ball's centre in a grid of 4 x 2, in the order of AddBall.
Texture MakeBallTexture(Rng& look);
// The part of a tile that its face takes; the pattern goes on beyond it, for the sake of mip maps.
constexpr double kBallTileFill = 0.9;

// Small things with a picture each.
Texture MakeSolidTexture(const cv::Vec3f& rgb, Rng& look);
Texture MakeWindowViewTexture(Rng& look);
Texture MakeDoorTexture(Rng& look);
Texture MakeCarGlassTexture(Rng& look);
Texture MakeWheelTexture(Rng& look);
Texture MakePlateTexture(Rng& look);
// Backs of books in a grid of kBookColumns x kBookRows.
Texture MakeBooksTexture(Rng& look);
constexpr int kBookColumns = 16;
constexpr int kBookRows = 2;

}  // namespace cvo::synth
