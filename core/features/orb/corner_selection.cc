// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/orb/corner_selection.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace cvo {

namespace {

constexpr double kGrowth = 0.1;  // of the size of a box, on each side and per frame

cv::Rect2d Grown(const cv::Rect2d& box, int frames) {
  const double x = kGrowth * frames * box.width;
  const double y = kGrowth * frames * box.height;
  return {box.x - x, box.y - y, box.width + 2.0 * x, box.height + 2.0 * y};
}

bool HasCenterOf(const cv::Rect2d& box, const CornerRegion& region) {
  return region.box.contains({box.x + 0.5 * box.width, box.y + 0.5 * box.height});
}

}  // namespace

std::vector<CornerRegion> LeftRegions(RecentBoxes boxes, const OrbOptions& orb) {
  std::vector<CornerRegion> regions;
  const int frames = std::min(kReserveFrames, static_cast<int>(boxes.size()));
  for (int age = 0; age < frames; ++age) {
    const std::size_t newer = regions.size();
    for (const cv::Rect2d& box : boxes[boxes.size() - 1 - static_cast<std::size_t>(age)]) {
      const bool is_seen_again =
          std::any_of(regions.begin(), regions.begin() + static_cast<std::ptrdiff_t>(newer),
                      [&](const CornerRegion& region) { return HasCenterOf(box, region); });
      if (!is_seen_again) regions.push_back({Grown(box, age), age == 0 ? orb.box_features : 0});
    }
  }
  return regions;
}

std::vector<CornerRegion> RightRegions(std::vector<CornerRegion> regions,
                                       const StereoMatchOptions& stereo,
                                       const StereoCamera& camera) {
  const double max_disparity_px = camera.fx / stereo.min_depth_baselines;
  for (CornerRegion& region : regions) {
    cv::Rect2d& box = region.box;
    const double left_px = std::max(0.0, box.x - max_disparity_px);
    const cv::Rect2d seen(left_px, box.y, box.x + box.width - left_px, box.height);
    const double widening = seen.width / std::max(1.0, box.width);
    const double corners = std::clamp(region.corners * stereo.right_features * widening, 0.0,
                                      static_cast<double>(OrbOptions::kMaxFeatures));
    region = {seen, static_cast<int>(std::lround(corners))};
  }
  return regions;
}

namespace {

constexpr double kMaxShift_px = 1.0;

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
  if (move.cwiseAbs().maxCoeff() > kMaxShift_px) return Eigen::Vector2d::Zero();
  return move;
}

namespace {

constexpr double kExcess = 1.05;  // accepted count over quota; the weakest are then dropped
constexpr int kMaxTrials = 12;

// Sorts the corners, strongest first. Equally strong ones keep their order. Scores are 0 ... 255.
std::vector<Corner> SortByScore(const std::vector<Corner>& corners) {
  std::array<int, 257> begin{};  // where the corners with score 255 - i begin
  for (const Corner& corner : corners) ++begin[256 - corner.score];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  std::vector<Corner> sorted(corners.size());
  for (const Corner& corner : corners) sorted[begin[255 - corner.score]++] = corner;
  return sorted;
}

using Word = std::uint64_t;
constexpr int kWordBits = 64;
static_assert(std::endian::native == std::endian::little, "pixel x is bit x % 8 of byte x / 8");

// Masks of the pixels nearer to the centre than `distance`, one bit each, in rows of whole words;
// one for each place of the first column in its byte.
struct Disc {
  explicit Disc(double distance)
      : reach(static_cast<int>(std::ceil(distance)) - 1), words((2 * reach + 7) / kWordBits + 1) {
    for (int shift = 0; shift < 8; ++shift) {
      masks[shift].assign(static_cast<std::size_t>((2 * reach + 1) * words), 0);
    }
    for (int y = -reach; y <= reach; ++y) {
      const int half = static_cast<int>(std::ceil(std::sqrt(distance * distance - y * y))) - 1;
      for (int shift = 0; shift < 8; ++shift) {
        Set(reach - half + shift, reach + half + shift, &masks[shift][(y + reach) * words]);
      }
    }
  }

  // Sets the bits from `first` to `last`.
  static void Set(int first, int last, Word* row) {
    for (; first <= last; first = (first / kWordBits + 1) * kWordBits) {
      const int count = std::min(last - first + 1, kWordBits - first % kWordBits);
      row[first / kWordBits] |= ~Word{0} >> (kWordBits - count) << first % kWordBits;
    }
  }

  int reach;
  int words;  // per row
  std::array<std::vector<Word>, 8> masks;
};

// Selects corners that are at least a distance apart, strongest first. A bitmap marks the pixels
// covered by the discs around the corners selected so far.
class EvenSelector {
 public:
  explicit EvenSelector(const std::vector<Corner>& strongest_first) : corners_(strongest_first) {
    int x1 = x0_ = corners_[0].x;
    int y1 = y0_ = corners_[0].y;
    for (const Corner& corner : corners_) {
      x0_ = std::min(x0_, corner.x);
      x1 = std::max(x1, corner.x);
      y0_ = std::min(y0_, corner.y);
      y1 = std::max(y1, corner.y);
    }
    width_ = x1 - x0_ + 1;
    height_ = y1 - y0_ + 1;
  }

  int width() const { return width_; }
  int height() const { return height_; }

  // Stops at `limit` corners.
  std::vector<Corner> Spread(double distance, int limit) {
    const Disc disc(distance);
    // Large enough that no disc is clipped, and rows that end with a whole word.
    stride_ = (width_ + 2 * disc.reach) / 8 + 1 + static_cast<int>(sizeof(Word));
    covered_.assign(static_cast<std::size_t>(stride_) * (height_ + 2 * disc.reach), 0);
    std::vector<Corner> chosen;
    for (const Corner& corner : corners_) {
      if (static_cast<int>(chosen.size()) >= limit) break;
      const int x = corner.x - x0_ + disc.reach;
      if ((Row(corner.y - y0_ + disc.reach)[x / 8] >> (x % 8) & 1U) != 0) continue;
      chosen.push_back(corner);
      Cover(corner.x - x0_, corner.y - y0_, disc);
    }
    return chosen;
  }

 private:
  std::uint8_t* Row(int y) { return &covered_[static_cast<std::size_t>(y) * stride_]; }

  // (x, y) is the position of the first column and row of the disc.
  void Cover(int x, int y, const Disc& disc) {
    const Word* part = disc.masks[x % 8].data();
    std::uint8_t* row = Row(y) + x / 8;
    for (int i = 0; i <= 2 * disc.reach; ++i, row += stride_) {
      for (int word = 0; word < disc.words; ++word, ++part) {
        Word covered;
        std::memcpy(&covered, row + word * sizeof(Word), sizeof(Word));
        covered |= *part;
        std::memcpy(row + word * sizeof(Word), &covered, sizeof(Word));
      }
    }
  }

  const std::vector<Corner>& corners_;
  int x0_, y0_, width_, height_;
  int stride_ = 0;  // bytes per row
  std::vector<std::uint8_t> covered_;
};

}  // namespace

std::vector<Corner> SelectEvenly(const std::vector<Corner>& corners, int quota) {
  if (quota <= 0) return {};
  if (static_cast<int>(corners.size()) <= quota) return corners;
  const std::vector<Corner> sorted = SortByScore(corners);
  EvenSelector selector(sorted);
  const int enough = static_cast<int>(quota * kExcess) + 1;
  double low = 1.0;  // keeps all corners, as no two share a pixel
  double high = std::hypot(selector.width(), selector.height());
  double distance = std::sqrt(static_cast<double>(selector.width()) * selector.height() / quota);
  std::vector<Corner> selected = sorted;
  for (int trial = 0; trial < kMaxTrials; ++trial) {
    if (!(distance > low && distance < high)) distance = std::sqrt(low * high);
    std::vector<Corner> spread = selector.Spread(distance, 2 * quota);
    const int count = static_cast<int>(spread.size());
    (count < quota ? high : low) = distance;
    // The number of corners falls with the square of the distance.
    distance *= std::sqrt(count / (0.5 * (quota + enough)));
    if (count < quota) continue;
    selected = std::move(spread);
    if (count <= enough) break;
  }
  selected.resize(static_cast<std::size_t>(quota));
  std::sort(selected.begin(), selected.end(), InReadingOrder);
  return selected;
}

}  // namespace cvo
