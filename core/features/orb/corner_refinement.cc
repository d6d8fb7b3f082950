// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb/corner_refinement.h"

#include <cmath>
#include <cstdint>

namespace cvo {
namespace {

constexpr double kMaxMove_px = 1.0;

// Scores of three adjacent lines (columns or rows), each smoothed along the line by (1 2 1) / 4.
// This amounts to a least-squares fit with weights that fall off towards the corners.
struct Profile {
  double before, middle, after;

  double Slope() const { return 0.5 * (after - before); }
  double Curvature() const { return before + after - 2.0 * middle; }
};

double Smooth(double before, double middle, double after) {
  return 0.25 * (before + 2.0 * middle + after);
}

}  // namespace

Eigen::Vector2d RefineCorner(const cv::Mat& scores, int x, int y) {
  double s[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) s[i][j] = scores.at<std::uint8_t>(y - 1 + i, x - 1 + j);
  }
  const Profile columns{Smooth(s[0][0], s[1][0], s[2][0]), Smooth(s[0][1], s[1][1], s[2][1]),
                        Smooth(s[0][2], s[1][2], s[2][2])};
  const Profile rows{Smooth(s[0][0], s[0][1], s[0][2]), Smooth(s[1][0], s[1][1], s[1][2]),
                     Smooth(s[2][0], s[2][1], s[2][2])};
  const double mixed = 0.25 * (s[2][2] - s[2][0] - s[0][2] + s[0][0]);
  const double determinant = columns.Curvature() * rows.Curvature() - mixed * mixed;
  if (!(determinant > 0.0) || columns.Curvature() >= 0.0) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d move =
      Eigen::Vector2d(mixed * rows.Slope() - rows.Curvature() * columns.Slope(),
                      mixed * columns.Slope() - columns.Curvature() * rows.Slope()) /
      determinant;
  if (move.cwiseAbs().maxCoeff() > kMaxMove_px) return Eigen::Vector2d::Zero();
  return move;
}

}  // namespace cvo
