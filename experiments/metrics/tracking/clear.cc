// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/association/assignment.h"
#include "experiments/metrics/tracking/tracking_scores.h"

namespace cvo {
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

}  // namespace cvo
