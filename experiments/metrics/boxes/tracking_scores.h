// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "experiments/metrics/boxes/average_precision.h"

namespace cvo {

// The boxes of one frame: identities of true and reported boxes, each at most once, and the
// similarity of each pair in [0, 1] (rows: true). Identities are numbered from 0 without gaps over
// the sequence.
struct TrackedFrame {
  std::vector<int> truth;
  std::vector<int> estimate;
  Eigen::MatrixXd similarity;
};

struct TrackedSequence {
  int truth_count = 0;  // number of identities
  int estimate_count = 0;
  std::vector<TrackedFrame> frames;
};

// Slack with which HOTA, CLEAR and the KITTI rules compare similarities, as in TrackEval: the
// spacing of doubles at 1.
inline constexpr double kSimilaritySlack = 2.220446049250313e-16;

// Higher order tracking accuracy (Luiten et al., IJCV 2021): means over the similarity thresholds
// 0.05, 0.10, ..., 0.95. HOTA is the mean of sqrt(DetA AssA), not the square root of the product of
// the means.
struct HotaScores {
  double hota = 0.0;
  double det_a = 0.0;
  double ass_a = 0.0;
  double loc_a = 0.0;
};
HotaScores EvaluateHota(const TrackedSequence& sequence);

// CLEAR metrics (Bernardin and Stiefelhagen 2008), at similarity 0.5.
struct ClearScores {
  double mota = 0.0;  // 1 - (missed + false + switches) / true boxes
  double motp = 0.0;  // mean similarity of matches
  int matches = 0;
  int missed = 0;
  int false_boxes = 0;
  int switches = 0;
  int fragments = 0;  // number of times a true body is matched again after a frame without a match
};
ClearScores EvaluateClear(const TrackedSequence& sequence);

// Identity metrics (Ristani et al. 2016), at similarity 0.5: over the whole sequence, each true
// body is assigned at most one reported identity, such that as many boxes as possible match.
struct IdentityScores {
  double idf1 = 0.0;
  double precision = 0.0;
  double recall = 0.0;
};
IdentityScores EvaluateIdentities(const TrackedSequence& sequence);

// Selects the boxes of `category` ("Car", "Pedestrian") that KITTI's tracking benchmark counts, by
// the rules of TrackEval. True boxes count if their occlusion is at most 2 and their truncation 0.
// Reported boxes do not count if they match, in the image (similarity 0.5), a true box that does
// not count or one of a neighbouring class (van, person), nor if they are unmatched and either at
// most 25 px high or with more than half of their area in a DontCare region. `space` is that of the
// similarity in the result; which boxes count is decided in the image, or in 3D for a reported box
// that is in no image. No track has two boxes in a frame (ReadTracks).
TrackedSequence CountedBoxes(const std::vector<ApFrame>& frames, const std::string& category,
                             BoxSpace space);

}  // namespace cvo
