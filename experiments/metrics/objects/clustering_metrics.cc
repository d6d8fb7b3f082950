// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "experiments/metrics/objects/object_scores.h"

namespace cvo {
namespace {

using reports::MetricId;
using enum reports::MetricId;

// Observed landmarks that are judged. Body 0 is the static scene, which is treated as a body of its
// own.
struct Judged {
  int body = 0;
  int cluster = 0;  // -1: none
  int count = 0;
};

struct LeftOut {
  std::int64_t unknown = 0;
  std::int64_t standing = 0;
  std::int64_t judged = 0;
};

std::vector<std::vector<Judged>> Judge(const ObjectEstimate& estimate, LeftOut& left_out) {
  std::vector<std::vector<Judged>> frames;
  for (const auto& observed : estimate.landmarks) {
    frames.emplace_back();
    for (const LandmarkObservation& landmark : observed) {
      if (landmark.truth.body < 0) {
        left_out.unknown += landmark.count;
      } else if (landmark.truth.body > 0 && landmark.truth.motion == PointMotion::kStill) {
        left_out.standing += landmark.count;
      } else {
        frames.back().push_back({landmark.truth.body, landmark.cluster, landmark.count});
        left_out.judged += landmark.count;
      }
    }
  }
  return frames;
}

struct Decisions {
  std::int64_t hits = 0, predicted = 0, moving = 0;
};

Decisions Count(const std::vector<std::vector<Judged>>& frames) {
  Decisions decisions;
  for (const auto& frame : frames) {
    for (const Judged& landmark : frame) {
      decisions.hits += landmark.body > 0 && landmark.cluster > 0 ? landmark.count : 0;
      decisions.predicted += landmark.cluster > 0 ? landmark.count : 0;
      decisions.moving += landmark.body > 0 ? landmark.count : 0;
    }
  }
  return decisions;
}

// Counts the landmarks in clusters, including those on stationary bodies, and as `right` those on
// the body that holds most of their cluster's landmarks over all frames.
struct Purity {
  std::int64_t right = 0, in_clusters = 0;
};

Purity CountPurity(const ObjectEstimate& estimate) {
  std::map<int, std::map<int, std::int64_t>> bodies_of_cluster;
  Purity purity;
  for (const auto& observed : estimate.landmarks) {
    for (const LandmarkObservation& landmark : observed) {
      if (landmark.truth.body < 0 || landmark.cluster <= 0) continue;
      purity.in_clusters += landmark.count;
      // The static scene is not the body of any cluster.
      if (landmark.truth.body == 0) continue;
      bodies_of_cluster[landmark.cluster][landmark.truth.body] += landmark.count;
    }
  }
  for (const auto& [cluster, bodies] : bodies_of_cluster) {
    std::int64_t most = 0;
    for (const auto& [body, count] : bodies) most = std::max(most, count);
    purity.right += most;
  }
  return purity;
}

// Cluster of each body; -2, which no landmark has, for a body without a match.
using ClusterOf = std::map<int, std::int64_t>;

ClusterOf MatchedClusters(const ObjectTruth& truth, const ObjectEstimate& estimate,
                          const std::vector<ObjectMatch>& matches) {
  ClusterOf cluster_of = {{0, 0}};
  for (const TruthBody& body : truth.bodies) cluster_of[body.id] = -2;
  for (const ObjectMatch& match : matches) {
    cluster_of[truth.bodies.at(match.body).id] = estimate.clusters.at(match.cluster).id;
  }
  return cluster_of;
}

// Mean over the static scene and the bodies seen in the frame, which must not be empty.
double FrameIou(const std::vector<Judged>& frame, const ClusterOf& cluster_of) {
  std::map<int, std::int64_t> size_of_body;
  std::map<int, std::int64_t> size_of_cluster;
  std::map<int, std::int64_t> both;
  for (const Judged& landmark : frame) {
    size_of_body[landmark.body] += landmark.count;
    size_of_cluster[landmark.cluster] += landmark.count;
    const auto cluster = cluster_of.find(landmark.body);
    if (cluster == cluster_of.end() || cluster->second != landmark.cluster) continue;
    both[landmark.body] += landmark.count;
  }
  double sum = 0.0;
  for (const auto& [body, size] : size_of_body) {
    const std::int64_t shared = both[body];
    if (shared == 0) continue;
    const std::int64_t cluster_size = size_of_cluster[static_cast<int>(cluster_of.at(body))];
    sum += static_cast<double>(shared) / static_cast<double>(size + cluster_size - shared);
  }
  return sum / static_cast<double>(size_of_body.size());
}

struct Mean {
  double sum = 0.0;
  std::int64_t n = 0;

  void Add(double value) {
    sum += value;
    ++n;
  }
};

bool HasTwoGroups(const std::vector<Judged>& frame) {
  return std::any_of(frame.begin(), frame.end(),
                     [&](const Judged& l) { return l.body != frame.front().body; });
}

double FrameAri(const std::vector<Judged>& frame) {
  std::vector<int> bodies, clusters;
  for (const Judged& landmark : frame) {
    const auto count = static_cast<std::size_t>(landmark.count);
    bodies.insert(bodies.end(), count, landmark.body);
    clusters.insert(clusters.end(), count, landmark.cluster);
  }
  return AdjustedRandIndex(bodies, clusters);
}

// What all clustering metrics share.
struct Base {
  reports::Contract contract;
  std::string left_out;

  void Add(MetricId id, double value, std::int64_t n, std::vector<Metric>& metrics) const {
    if (n == 0) return;
    Metric metric = MakeMetric({id}, value / static_cast<double>(n), n);
    metric.contract.subject = reports::Subject::kLandmarks;
    metric.contract.travel_m = kMovedPoint_m;
    metric.contract.travel_frames = kMovedFrames;
    metric.contract.truth = contract.truth;
    metric.contract.camera_truth = contract.camera_truth;
    metric.left_out = left_out;
    metrics.push_back(std::move(metric));
  }
};

Base MakeBase(const ObjectTruth& truth, const LeftOut& left_out) {
  return {truth.contract, StrCat(left_out.unknown, " observations of unknown truth, ",
                                 left_out.standing, " on bodies that have not moved yet, of ",
                                 left_out.unknown + left_out.standing + left_out.judged)};
}

double Pairs(std::int64_t n) { return 0.5 * static_cast<double>(n) * static_cast<double>(n - 1); }

template <typename Key>
double SumOfPairs(const std::map<Key, std::int64_t>& sizes) {
  double sum = 0.0;
  for (const auto& [key, size] : sizes) sum += Pairs(size);
  return sum;
}

}  // namespace

double AdjustedRandIndex(const std::vector<int>& a, const std::vector<int>& b) {
  Require(a.size() == b.size(), "AdjustedRandIndex: needs two labels for each thing");
  std::map<int, std::int64_t> sizes_a, sizes_b;
  std::map<std::pair<int, int>, std::int64_t> sizes_both;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] >= 0) ++sizes_a[a[i]];
    if (b[i] >= 0) ++sizes_b[b[i]];
    if (a[i] >= 0 && b[i] >= 0) ++sizes_both[{a[i], b[i]}];
  }
  const double together = SumOfPairs(sizes_both);
  const double in_a = SumOfPairs(sizes_a);
  const double in_b = SumOfPairs(sizes_b);
  // Equal if the labellings agree on every pair; only then can the quotient be 0 / 0.
  if (together == in_a && together == in_b) return 1.0;
  const double by_chance = in_a * in_b / Pairs(static_cast<std::int64_t>(a.size()));
  return (together - by_chance) / (0.5 * (in_a + in_b) - by_chance);
}

std::vector<Metric> ClusteringMetrics(const ObjectTruth& truth, const ObjectEstimate& estimate,
                                      const std::vector<ObjectMatch>& matches) {
  CheckEstimate(truth, estimate);
  LeftOut left_out;
  const std::vector<std::vector<Judged>> frames = Judge(estimate, left_out);
  const ClusterOf cluster_of = MatchedClusters(truth, estimate, matches);
  Mean iou, ari;
  for (const auto& frame : frames) {
    if (frame.empty()) continue;
    iou.Add(FrameIou(frame, cluster_of));
    if (HasTwoGroups(frame)) ari.Add(FrameAri(frame));
  }
  const Base base = MakeBase(truth, left_out);
  const Decisions decisions = Count(frames);
  const auto hits = static_cast<double>(decisions.hits);
  std::vector<Metric> metrics;
  base.Add(kMovingPrecision, hits, decisions.predicted, metrics);
  base.Add(kMovingRecall, hits, decisions.moving, metrics);
  const Purity purity = CountPurity(estimate);
  base.Add(kClusterPurity, static_cast<double>(purity.right), purity.in_clusters, metrics);
  base.Add(kClusteringIou, iou.sum, iou.n, metrics);
  base.Add(kClusteringAri, ari.sum, ari.n, metrics);
  return metrics;
}

}  // namespace cvo
