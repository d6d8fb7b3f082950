// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/boxes/tracking_scores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/association/box_association.h"
#include "core/base/error.h"
#include "experiments/metrics/boxes/average_precision.h"

namespace cvo {

namespace {

using Boxes = std::vector<const ObjectBox*>;

constexpr double kLeastSimilarity = 0.5;

bool Counts(const ObjectBox& label, const std::string& category) {
  constexpr int kMostOcclusion = 2;
  constexpr double kMostTruncation = kSimilaritySlack;
  return IsOfClass(label, category) && label.occlusion <= kMostOcclusion &&
         label.truncation <= kMostTruncation;
}

// Whether the boxes decide in 3D which of them count: `space` is, and the box is in no image.
bool CountsIn3d(const ObjectBox& detection, BoxSpace space) {
  return space == BoxSpace::kVolume && !detection.IsInImage();
}

// Matches reported boxes in the image. Returns, per reported box, the true box or nullptr.
Boxes MatchInImage(const Boxes& labels, const Boxes& detections, BoxSpace space) {
  Eigen::MatrixXd cost(labels.size(), detections.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < detections.size(); ++j) {
      const double overlap = IntersectionOverUnion(
          CountsIn3d(*detections[j], space) ? space : BoxSpace::kImage, *labels[i], *detections[j]);
      cost(i, j) = overlap < kLeastSimilarity - kSimilaritySlack ? 0.0 : -overlap;
    }
  }
  Boxes matched(detections.size(), nullptr);
  const std::vector<int> columns = Assign(cost);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] < 0 || !(-cost(i, columns[i]) > kSimilaritySlack)) continue;
    matched[static_cast<std::size_t>(columns[i])] = labels[i];
  }
  return matched;
}

bool IsForgiven(const ObjectBox& detection, const std::vector<ObjectBox>& labels, BoxSpace space) {
  constexpr double kLeastHeight_px = 25.0;
  if (CountsIn3d(detection, space)) return false;
  if (detection.bottom_px - detection.top_px <= kLeastHeight_px + kSimilaritySlack) return true;
  return std::any_of(labels.begin(), labels.end(), [&](const ObjectBox& label) {
    return IsDontCare(label) && ShareInside(detection, label) > kLeastSimilarity + kSimilaritySlack;
  });
}

Boxes CountedDetections(const ApFrame& frame, const std::string& category, BoxSpace space) {
  Boxes labels;
  for (const ObjectBox& label : frame.labels) {
    if (IsOfClass(label, category) || IsNeighbour(label, category)) labels.push_back(&label);
  }
  Boxes detections;
  for (const ObjectBox& box : frame.detections) {
    if (IsOfClass(box, category)) detections.push_back(&box);
  }
  const Boxes matched = MatchInImage(labels, detections, space);
  Boxes counted;
  for (std::size_t j = 0; j < detections.size(); ++j) {
    const bool out = matched[j] != nullptr ? !Counts(*matched[j], category)
                                           : IsForgiven(*detections[j], frame.labels, space);
    if (!out) counted.push_back(detections[j]);
  }
  return counted;
}

// Maps the track ids of a file to identities without gaps.
class Identities {
 public:
  std::vector<int> Of(const Boxes& boxes) {
    std::vector<int> ids;
    for (const ObjectBox* box : boxes) {
      ids.push_back(ids_.emplace(box->track, static_cast<int>(ids_.size())).first->second);
    }
    return ids;
  }
  int count() const { return static_cast<int>(ids_.size()); }

 private:
  std::map<int, int> ids_;
};

}  // namespace

TrackedSequence CountedBoxes(const std::vector<ApFrame>& frames, const std::string& category,
                             BoxSpace space) {
  TrackedSequence sequence;
  Identities true_ids;
  Identities reported_ids;
  for (const ApFrame& frame : frames) {
    Boxes labels;
    for (const ObjectBox& label : frame.labels) {
      if (Counts(label, category)) labels.push_back(&label);
    }
    const Boxes detections = CountedDetections(frame, category, space);
    TrackedFrame tracked{true_ids.Of(labels), reported_ids.Of(detections),
                         Eigen::MatrixXd(labels.size(), detections.size())};
    for (std::size_t i = 0; i < labels.size(); ++i) {
      for (std::size_t j = 0; j < detections.size(); ++j) {
        tracked.similarity(i, j) = IntersectionOverUnion(space, *labels[i], *detections[j]);
      }
    }
    sequence.frames.push_back(std::move(tracked));
  }
  sequence.truth_count = true_ids.count();
  sequence.estimate_count = reported_ids.count();
  return sequence;
}

namespace {

constexpr double kLeast = 0.5;
constexpr int kNone = -1;

struct ClearTrack {
  int last = kNone;      // reported identity of its last match
  int previous = kNone;  // its match in the preceding frame; kNone: none
};

class ClearCounter {
 public:
  explicit ClearCounter(int truth_count) : tracks_(static_cast<std::size_t>(truth_count)) {}

  void Add(const TrackedFrame& frame);
  ClearScores Scores() const;

 private:
  void Match(ClearTrack& track, int estimate, double similarity);

  std::vector<ClearTrack> tracks_;
  ClearScores scores_;
  double similarity_ = 0.0;
};

// Assignment costs that keep a pair of the preceding frame in preference to any other.
Eigen::MatrixXd Costs(const TrackedFrame& frame, const std::vector<ClearTrack>& tracks) {
  constexpr double kKept = 1000.0;
  Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(frame.similarity.rows(), frame.similarity.cols());
  for (std::size_t i = 0; i < frame.truth.size(); ++i) {
    const ClearTrack& track = tracks[static_cast<std::size_t>(frame.truth[i])];
    for (std::size_t j = 0; j < frame.estimate.size(); ++j) {
      const double similarity = frame.similarity(i, j);
      if (similarity < kLeast - kSimilaritySlack) continue;
      cost(i, j) = -similarity - (track.previous == frame.estimate[j] ? kKept : 0.0);
    }
  }
  return cost;
}

void ClearCounter::Match(ClearTrack& track, int estimate, double similarity) {
  ++scores_.matches;
  similarity_ += similarity;
  if (track.last != kNone && track.last != estimate) ++scores_.switches;
  track.last = estimate;
}

void ClearCounter::Add(const TrackedFrame& frame) {
  const int before = scores_.matches;
  // A frame without true or without reported boxes leaves the previous matches as they are.
  if (!frame.truth.empty() && !frame.estimate.empty()) {
    const Eigen::MatrixXd cost = Costs(frame, tracks_);
    const std::vector<int> columns = Assign(cost);
    std::vector<ClearTrack> next = tracks_;
    for (ClearTrack& track : next) track.previous = kNone;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i] < 0 || !(-cost(i, columns[i]) > kSimilaritySlack)) continue;
      const auto id = static_cast<std::size_t>(frame.truth[i]);
      const int estimate = frame.estimate[static_cast<std::size_t>(columns[i])];
      Match(next[id], estimate, frame.similarity(i, columns[i]));
      next[id].previous = estimate;
      if (tracks_[id].previous == kNone) ++scores_.fragments;
    }
    tracks_ = std::move(next);
  }
  const int matches = scores_.matches - before;
  scores_.missed += static_cast<int>(frame.truth.size()) - matches;
  scores_.false_boxes += static_cast<int>(frame.estimate.size()) - matches;
}

ClearScores ClearCounter::Scores() const {
  ClearScores scores = scores_;
  // The first match of a body is not a fragment.
  scores.fragments -= static_cast<int>(std::count_if(
      tracks_.begin(), tracks_.end(), [](const ClearTrack& track) { return track.last != kNone; }));
  const double wrong = scores.missed + scores.false_boxes + scores.switches;
  const double truth = std::max(1, scores.matches + scores.missed);
  scores.mota = (scores.matches + scores.missed - wrong) / truth;
  scores.motp = similarity_ / std::max(1, scores.matches);
  return scores;
}

}  // namespace

ClearScores EvaluateClear(const TrackedSequence& sequence) {
  ClearCounter counter(sequence.truth_count);
  for (const TrackedFrame& frame : sequence.frames) counter.Add(frame);
  return counter.Scores();
}

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

IdentityScores EvaluateIdentities(const TrackedSequence& sequence) {
  constexpr double kLeast = 0.5;
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(sequence.truth_count, sequence.estimate_count);
  double truth = 0.0;
  double estimate = 0.0;
  for (const TrackedFrame& frame : sequence.frames) {
    truth += static_cast<double>(frame.truth.size());
    estimate += static_cast<double>(frame.estimate.size());
    for (std::size_t i = 0; i < frame.truth.size(); ++i) {
      for (std::size_t j = 0; j < frame.estimate.size(); ++j) {
        if (frame.similarity(i, j) >= kLeast) together(frame.truth[i], frame.estimate[j]) += 1.0;
      }
    }
  }
  // Each common box of a pair of tracks saves two errors: one missed and one false box.
  const std::vector<int> columns = Assign(-together);
  double matches = 0.0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] >= 0) matches += together(static_cast<Eigen::Index>(i), columns[i]);
  }
  IdentityScores scores;
  scores.recall = matches / std::max(1.0, truth);
  scores.precision = matches / std::max(1.0, estimate);
  scores.idf1 = matches / std::max(1.0, 0.5 * (truth + estimate));
  return scores;
}

}  // namespace cvo
