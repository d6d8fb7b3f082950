// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/stereo_matcher.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/features/orb/orb.h"
#include "core/features/patch_alignment.h"

namespace cvo {

namespace {

// Maximum left-right disagreement, at the corner's scale (METHOD.md 2.2).
constexpr double kLeftRightTolerance_px = 1.0;
// Maximum row difference of a stereo match, at the corner's scale (METHOD.md 2.2).
constexpr double kRowTolerance_px = 2.0;
// Maximum row difference of a stereo match after global row alignment of the image pair (measured
// on KITTI).
constexpr double kMaxRowError_px = 1.5;
// Radius of the patch used for alignment (METHOD.md 2.2).
constexpr int kPatchRadius_px = 6;
// Search radius of the alignment around the matched corner (METHOD.md 2.2).
constexpr int kSearchRadius_px = 3;
// Minimum disparity of a point (METHOD.md 2.2).
constexpr double kMinDisparity_px = 0.1;

constexpr int kIterations = 2;
constexpr int kFirstIterations = 8;
constexpr int kWideIterations = 3;
constexpr double kWideFactor = 4.0;
constexpr double kPriorSigma_px = 1.0;     // of each coefficient of the polynomial
constexpr double kPriorSigmaSlope = 0.01;  // px per px of disparity: the slope of the baseline
constexpr double kCornerSigma_px = 0.4;

RowField::Vector Basis(const StereoCamera& camera, double u_px, double v_px, double disparity_px) {
  RowField::Vector basis;
  basis << camera.BasisAt(u_px, v_px).value, disparity_px;
  return basis;
}

}  // namespace

double RowSigma(double scale) { return kCornerSigma_px * scale; }

RowField::RowField() {
  information_ = Matrix::Identity() / (kPriorSigma_px * kPriorSigma_px);
  information_(6, 6) = 1.0 / (kPriorSigmaSlope * kPriorSigmaSlope);
}

void RowField::Add(const std::vector<RowOffset>& samples, const StereoCamera& camera) {
  std::vector<Vector> bases;
  bases.reserve(samples.size());
  for (const RowOffset& sample : samples) {
    bases.push_back(Basis(camera, sample.u_px, sample.v_px, sample.disparity_px));
  }
  // Iteratively reweighted least squares with Geman-McClure weights. The first iterations of the
  // first fit use a wider kernel, so that samples far from zero have an influence.
  Matrix information;
  Vector weighted;
  const int iterations = is_empty_ ? kFirstIterations : kIterations;
  for (int i = 0; i < iterations; ++i) {
    const double width = is_empty_ && i < kWideIterations ? kWideFactor : 1.0;
    information = information_;
    weighted = weighted_;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const RowOffset& sample = samples[k];
      const double error =
          (sample.offset_px - coefficients_.dot(bases[k])) / (width * sample.sigma_px);
      const double root = 1.0 / (1.0 + error * error);
      const double weight = root * root / (sample.sigma_px * sample.sigma_px);
      information.noalias() += weight * bases[k] * bases[k].transpose();
      weighted.noalias() += weight * sample.offset_px * bases[k];
    }
    coefficients_ = information.ldlt().solve(weighted);
  }
  information_ = information;
  weighted_ = weighted;
  is_empty_ = is_empty_ && samples.empty();
}

double RowField::At(const StereoCamera& camera, double u_px, double v_px,
                    double disparity_px) const {
  return coefficients_.dot(Basis(camera, u_px, v_px, disparity_px));
}

namespace {

constexpr int kNone = -1;
constexpr double kSurelyGoodSigma_px = 0.02;  // always accepted, even if the median is near zero

// Table of the corners of one octave by image row. Requires corners sorted by v.
class RowTable {
 public:
  struct Entry {
    float u_px;
    float v_px;
    int corner;
  };

  RowTable(const OrbImage& image, int octave) : first_(image.pyramid[0].rows + 1, 0) {
    for (std::size_t i = 0; i < image.keypoints.size(); ++i) {
      const OrbKeypoint& corner = image.keypoints[i];
      if (corner.octave != octave) continue;
      corners_.push_back({corner.u_px, corner.v_px, static_cast<int>(i)});
      ++first_[Row(corner.v_px) + 1];
    }
    for (std::size_t row = 1; row < first_.size(); ++row) first_[row] += first_[row - 1];
  }

  // Returns the corners in the rows from v_from to v_to.
  std::span<const Entry> Between(double v_from, double v_to) const {
    const int begin = first_[Row(v_from)];
    return std::span(corners_).subspan(begin, first_[Row(v_to) + 1] - begin);
  }

 private:
  int Row(double v) const {
    return std::clamp(static_cast<int>(std::floor(v)), 0, static_cast<int>(first_.size()) - 2);
  }
  std::vector<Entry> corners_;
  std::vector<int> first_;
};

// The right corner with the most similar descriptor to a left corner, and the distance at the next
// best place.
struct Choice {
  int right = kNone;
  int distance = 0;
  int second_distance = 0;
};

struct Candidate {
  int right;
  int distance;
};

class PairFinder {
 public:
  PairFinder(const OrbImage& left, const OrbImage& right, const StereoCamera& camera,
             const OrbOptions& orb, const StereoMatchOptions& options)
      : left_(left.keypoints),
        right_(right.keypoints),
        options_(options),
        max_disparity_(camera.fx / options.min_depth_baselines),
        best_left_(right.keypoints.size(), kNone),
        best_left_distance_(right.keypoints.size(), std::numeric_limits<int>::max()) {
    for (int octave = 0; octave < orb.levels; ++octave) {
      scales_.push_back(std::pow(orb.scale_factor, octave));
      rows_.emplace_back(right, octave);
    }
    for (std::size_t i = 0; i < left_.size(); ++i) choices_.push_back(Choose(static_cast<int>(i)));
  }

  // Returns the right corner of a left one, if each is the best match of the other and the match is
  // unique.
  std::optional<int> Find(int left) const {
    const Choice& choice = choices_[left];
    if (choice.right == kNone || choice.distance > options_.max_hamming) return std::nullopt;
    if (choice.distance > options_.uniqueness * choice.second_distance) return std::nullopt;
    if (choice.distance + options_.min_margin_bits > choice.second_distance) return std::nullopt;
    const OrbKeypoint& other = left_[best_left_[choice.right]];
    const double tolerance = kLeftRightTolerance_px * scales_[left_[left].octave];
    if (std::abs(other.u_px - left_[left].u_px) > tolerance) return std::nullopt;
    return choice.right;
  }

 private:
  Choice Choose(int left) {
    CollectCandidates(left);
    Choice choice;
    for (const Candidate& candidate : candidates_) {
      if (choice.right == kNone || candidate.distance < choice.distance) {
        choice.right = candidate.right;
        choice.distance = candidate.distance;
      }
    }
    if (choice.right == kNone) return choice;
    // The same corner detected at another octave is not a competing match.
    const double same_place = kSamePlace_px * scales_[left_[left].octave];
    choice.second_distance = 256;
    for (const Candidate& candidate : candidates_) {
      const double apart = std::abs(right_[candidate.right].u_px - right_[choice.right].u_px);
      if (apart > same_place) {
        choice.second_distance = std::min(choice.second_distance, candidate.distance);
      }
    }
    return choice;
  }

  void CollectCandidates(int left) {
    candidates_.clear();
    const int octave = left_[left].octave;
    const int last = std::min(octave + 1, static_cast<int>(rows_.size()) - 1);
    for (int other = std::max(octave - 1, 0); other <= last; ++other) CollectAt(left, other);
  }

  void CollectAt(int left, int octave) {
    const OrbKeypoint& corner = left_[left];
    const double tolerance = kRowTolerance_px * scales_[std::max(corner.octave, octave)];
    const double farthest_u = corner.u_px + kRowTolerance_px * scales_[corner.octave];
    const double nearest_u = corner.u_px - max_disparity_;
    const auto band = rows_[octave].Between(corner.v_px - tolerance, corner.v_px + tolerance);
    // Branch-free: most corners of the band are too far away along the row, which a branch per
    // corner would often mispredict.
    near_.resize(band.size());
    std::size_t count = 0;
    for (const RowTable::Entry& other : band) {
      near_[count] = other.corner;
      count += (other.u_px <= farthest_u) & (other.u_px >= nearest_u) &
               (std::abs(other.v_px - corner.v_px) <= tolerance);
    }
    for (const int i : std::span(near_).first(count)) {
      const int distance = HammingDistance(corner.descriptor, right_[i].descriptor);
      candidates_.push_back({i, distance});
      if (distance < best_left_distance_[i]) {
        best_left_distance_[i] = distance;
        best_left_[i] = left;
      }
    }
  }

  static constexpr double kSamePlace_px = 3.0;

  const std::vector<OrbKeypoint>& left_;
  const std::vector<OrbKeypoint>& right_;
  const StereoMatchOptions& options_;
  const double max_disparity_;
  std::vector<double> scales_;  // by octave
  std::vector<RowTable> rows_;  // right corners, by octave
  std::vector<int> best_left_;  // by right corner
  std::vector<int> best_left_distance_;
  std::vector<int> near_;              // candidate right corners of the current left corner
  std::vector<Candidate> candidates_;  // of the current left corner
  std::vector<Choice> choices_;        // by left corner
};

struct Pair {
  const OrbKeypoint* left;
  const OrbKeypoint* right;
};

double RowDifference(const Pair& pair) { return pair.right->v_px - pair.left->v_px; }

RowField FitRows(const std::vector<Pair>& pairs, const StereoCamera& camera, double scale_factor) {
  std::vector<RowOffset> samples;
  samples.reserve(pairs.size());
  for (const Pair& pair : pairs) {
    const OrbKeypoint& left = *pair.left;
    samples.push_back({left.u_px, left.v_px, left.u_px - pair.right->u_px, RowDifference(pair),
                       RowSigma(std::pow(scale_factor, left.octave))});
  }
  RowField rows;
  rows.Add(samples, camera);
  return rows;
}

StereoFeature FeatureOf(const OrbImage& image, const OrbKeypoint& corner, double u_right,
                        float disagreement_px) {
  StereoFeature feature;
  feature.z_px = {corner.u_px, corner.v_px, u_right};
  feature.octave = corner.octave;
  feature.angle_rad = corner.angle_rad;
  feature.response = corner.response;
  feature.is_reserve = corner.is_reserve;
  feature.disagreement_px = disagreement_px;
  feature.descriptor = corner.descriptor;
  feature.patch = PatchAround(image, corner);
  return feature;
}

// A left corner that was aligned with its partner in the right image.
struct AlignedCorner {
  Pair pair;
  double u_right;
  double sigma;            // of u_right, px of the level
  double disagreement_px;  // px of the level
};

std::optional<AlignedCorner> Align(const OrbImage& left, const OrbImage& right, const Pair& pair,
                                   double row_offset_px) {
  const OrbKeypoint& corner = *pair.left;
  const LevelCoordinates coordinates(left.pyramid, corner.octave);
  PatchQuery query;
  query.u_left = coordinates.LevelU(corner.u_px);
  query.v_left = coordinates.LevelV(corner.v_px);
  query.u_right = coordinates.LevelU(pair.right->u_px);
  query.v_right = coordinates.LevelV(corner.v_px + row_offset_px);
  query.patch_radius = kPatchRadius_px;
  query.search_radius = kSearchRadius_px;
  const std::optional<PatchMatch> match =
      AlignPatch(left.pyramid[corner.octave], right.pyramid[corner.octave], query);
  if (!match) return std::nullopt;
  const double u_right = coordinates.FullU(match->u_right);
  if (corner.u_px - u_right < kMinDisparity_px) return std::nullopt;
  return AlignedCorner{pair, u_right, match->sigma, match->disagreement};
}

// Drops corners whose disparity is far less certain than the median of all: their patches differ,
// as at the edge of an object, or have little structure along the row.
void DropUncertain(std::vector<AlignedCorner>& aligned, double max_sigma_medians) {
  if (aligned.empty()) return;
  std::vector<double> sigmas;
  for (const AlignedCorner& corner : aligned) sigmas.push_back(corner.sigma);
  const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
  std::nth_element(sigmas.begin(), middle, sigmas.end());
  const double max_sigma = std::max(max_sigma_medians * *middle, kSurelyGoodSigma_px);
  std::erase_if(aligned, [&](const AlignedCorner& corner) { return !(corner.sigma <= max_sigma); });
}

// Returns the features of the aligned corners and of all others in boxes, in the order of the
// corners of the image.
std::vector<StereoFeature> MakeFeatures(const OrbImage& left,
                                        const std::vector<AlignedCorner>& aligned,
                                        const std::vector<cv::Rect2d>& boxes) {
  std::vector<StereoFeature> features;
  features.reserve(aligned.size());
  auto next = aligned.begin();
  for (const OrbKeypoint& corner : left.keypoints) {
    if (next != aligned.end() && next->pair.left == &corner) {
      features.push_back(
          FeatureOf(left, corner, next->u_right, static_cast<float>(next->disagreement_px)));
      features.back().row_offset_px = static_cast<float>(RowDifference(next->pair));
      ++next;
      continue;
    }
    const bool is_boxed = std::any_of(boxes.begin(), boxes.end(), [&](const cv::Rect2d& box) {
      return box.contains({corner.u_px, corner.v_px});
    });
    if (is_boxed) features.push_back(FeatureOf(left, corner, corner.u_px, kNoDisparity_px));
  }
  return features;
}

}  // namespace

std::vector<StereoFeature> MatchStereo(const OrbImage& left, const OrbImage& right,
                                       const StereoCamera& camera, const OrbOptions& orb,
                                       const StereoMatchOptions& options,
                                       const std::vector<cv::Rect2d>& boxes) {
  options.Check();
  const PairFinder finder(left, right, camera, orb, options);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < left.keypoints.size(); ++i) {
    const std::optional<int> j = finder.Find(static_cast<int>(i));
    if (j) pairs.push_back({&left.keypoints[i], &right.keypoints[*j]});
  }
  const RowField rows = FitRows(pairs, camera, orb.scale_factor);
  std::vector<AlignedCorner> aligned;
  for (const Pair& pair : pairs) {
    const double offset =
        rows.At(camera, pair.left->u_px, pair.left->v_px, pair.left->u_px - pair.right->u_px);
    const double error = RowDifference(pair) - offset;
    const double scale = std::pow(orb.scale_factor, pair.left->octave);
    if (std::abs(error) > kMaxRowError_px * scale) continue;
    const double applied =
        std::clamp(offset, -options.max_row_correction_px, options.max_row_correction_px);
    const auto corner = Align(left, right, pair, applied);
    if (corner) aligned.push_back(*corner);
  }
  DropUncertain(aligned, options.max_sigma_medians);
  return MakeFeatures(left, aligned, boxes);
}

}  // namespace cvo
