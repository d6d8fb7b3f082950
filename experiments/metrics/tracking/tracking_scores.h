// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cvo {

// Boxes of one frame: identities of true and reported ones, each once, and how similar they are in
// [0, 1] (rows: true). Identities count from 0 without gaps over the sequence.
struct TrackedFrame {
  std::vector<int> truth;
  std::vector<int> estimate;
  Eigen::MatrixXd similarity;
};

struct TrackedSequence {
  int truth_count = 0;  // identities
  int estimate_count = 0;
  std::vector<TrackedFrame> frames;
};

// Limits are compared with this much slack, as TrackEval does: the spacing of doubles at 1.
inline constexpr double kSimilaritySlack = 2.220446049250313e-16;

// Higher order tracking accuracy (Luiten et al., IJCV 2021): means over the similarity limits 0.05,
// 0.10, ..., 0.95. HOTA is the mean of sqrt(DetA AssA), not the root of the means.
struct HotaScores {
  double hota = 0.0;
  double det_a = 0.0;
  double ass_a = 0.0;
  double loc_a = 0.0;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("hota", self.hota);
    archive.Field("det_a", self.det_a);
    archive.Field("ass_a", self.ass_a);
    archive.Field("loc_a", self.loc_a);
  }
};
HotaScores EvaluateHota(const TrackedSequence& sequence);

// CLEAR (Bernardin and Stiefelhagen 2008), at similarity 0.5.
struct ClearScores {
  double mota = 0.0;  // 1 - (missed + false + switches) / true boxes
  double motp = 0.0;  // mean similarity of matches
  int matches = 0;
  int missed = 0;
  int false_boxes = 0;
  int switches = 0;
  int fragments = 0;  // times that a true body is matched again after a frame without

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("mota", self.mota);
    archive.Field("motp", self.motp);
    archive.Field("matches", self.matches);
    archive.Field("missed", self.missed);
    archive.Field("false_boxes", self.false_boxes);
    archive.Field("switches", self.switches);
    archive.Field("fragments", self.fragments);
  }
};
ClearScores EvaluateClear(const TrackedSequence& sequence);

// Identity scores (Ristani et al. 2016), at similarity 0.5: over the whole sequence, each true body
// has at most one reported one, such that most boxes match.
struct IdentityScores {
  double idf1 = 0.0;
  double precision = 0.0;
  double recall = 0.0;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("idf1", self.idf1);
    archive.Field("precision", self.precision);
    archive.Field("recall", self.recall);
  }
};
IdentityScores EvaluateIdentities(const TrackedSequence& sequence);

}  // namespace cvo
