// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "core/association/assignment.h"
#include "experiments/metrics/tracking/tracking_scores.h"

namespace cvo {
namespace {

constexpr std::size_t kLimits = 19;
double Limit(std::size_t index) { return 0.05 + 0.05 * static_cast<double>(index); }

struct IdentityCounts {
  Eigen::VectorXd truth;  // number of frames that have the identity
  Eigen::VectorXd estimate;
};

IdentityCounts CountIdentities(const TrackedSequence& sequence) {
  IdentityCounts counts = {Eigen::VectorXd::Zero(sequence.truth_count),
                           Eigen::VectorXd::Zero(sequence.estimate_count)};
  for (const TrackedFrame& frame : sequence.frames) {
    for (const int id : frame.truth) counts.truth[id] += 1.0;
    for (const int id : frame.estimate) counts.estimate[id] += 1.0;
  }
  return counts;
}

// Agreement of whole tracks, a soft Jaccard index: the pair's share of the similarity in each
// frame, summed over frames, divided by the lengths of both tracks minus that sum.
Eigen::MatrixXd TrackAlignment(const TrackedSequence& sequence, const IdentityCounts& counts) {
  Eigen::MatrixXd shared = Eigen::MatrixXd::Zero(sequence.truth_count, sequence.estimate_count);
  for (const TrackedFrame& frame : sequence.frames) {
    const Eigen::VectorXd of_truth = frame.similarity.rowwise().sum();
    const Eigen::RowVectorXd of_estimate = frame.similarity.colwise().sum();
    for (std::size_t i = 0; i < frame.truth.size(); ++i) {
      for (std::size_t j = 0; j < frame.estimate.size(); ++j) {
        const double similarity = frame.similarity(i, j);
        const double all = of_truth[i] + of_estimate[j] - similarity;
        if (all > kSimilaritySlack) shared(frame.truth[i], frame.estimate[j]) += similarity / all;
      }
    }
  }
  for (Eigen::Index i = 0; i < shared.rows(); ++i) {
    for (Eigen::Index j = 0; j < shared.cols(); ++j) {
      shared(i, j) /= counts.truth[i] + counts.estimate[j] - shared(i, j);
    }
  }
  return shared;
}

// Counts at one similarity threshold.
struct LimitCounts {
  double matches = 0.0;
  double missed = 0.0;
  double false_boxes = 0.0;
  double similarity = 0.0;   // sum over matches
  Eigen::MatrixXd together;  // number of matches per true and reported identity
};

void AddFrame(const TrackedFrame& frame, const Eigen::MatrixXd& alignment,
              std::array<LimitCounts, kLimits>& limits) {
  Eigen::MatrixXd cost(frame.truth.size(), frame.estimate.size());
  for (std::size_t i = 0; i < frame.truth.size(); ++i) {
    for (std::size_t j = 0; j < frame.estimate.size(); ++j) {
      cost(i, j) = -alignment(frame.truth[i], frame.estimate[j]) * frame.similarity(i, j);
    }
  }
  const std::vector<int> columns = Assign(cost);
  for (std::size_t k = 0; k < kLimits; ++k) {
    double matches = 0.0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i] < 0) continue;
      const auto j = static_cast<std::size_t>(columns[i]);
      if (frame.similarity(i, j) < Limit(k) - kSimilaritySlack) continue;
      matches += 1.0;
      limits[k].similarity += frame.similarity(i, j);
      limits[k].together(frame.truth[i], frame.estimate[j]) += 1.0;
    }
    limits[k].matches += matches;
    limits[k].missed += static_cast<double>(frame.truth.size()) - matches;
    limits[k].false_boxes += static_cast<double>(frame.estimate.size()) - matches;
  }
}

double AssociationAccuracy(const LimitCounts& limit, const IdentityCounts& counts) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < limit.together.rows(); ++i) {
    for (Eigen::Index j = 0; j < limit.together.cols(); ++j) {
      const double n = limit.together(i, j);
      sum += n * n / std::max(1.0, counts.truth[i] + counts.estimate[j] - n);
    }
  }
  return sum / std::max(1.0, limit.matches);
}

}  // namespace

HotaScores EvaluateHota(const TrackedSequence& sequence) {
  const IdentityCounts counts = CountIdentities(sequence);
  const Eigen::MatrixXd alignment = TrackAlignment(sequence, counts);
  std::array<LimitCounts, kLimits> limits;
  for (LimitCounts& limit : limits) {
    limit.together = Eigen::MatrixXd::Zero(sequence.truth_count, sequence.estimate_count);
  }
  for (const TrackedFrame& frame : sequence.frames) AddFrame(frame, alignment, limits);
  HotaScores scores;
  for (const LimitCounts& limit : limits) {
    constexpr double kNothing = 1e-10;  // localisation is perfect if nothing is matched
    const double det_a =
        limit.matches / std::max(1.0, limit.matches + limit.missed + limit.false_boxes);
    const double ass_a = AssociationAccuracy(limit, counts);
    scores.det_a += det_a / kLimits;
    scores.ass_a += ass_a / kLimits;
    scores.hota += std::sqrt(det_a * ass_a) / kLimits;
    scores.loc_a +=
        std::max(kNothing, limit.similarity) / std::max(kNothing, limit.matches) / kLimits;
  }
  return scores;
}

}  // namespace cvo
