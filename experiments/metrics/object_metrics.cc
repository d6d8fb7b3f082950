// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/object_metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/error.h"

namespace cvo {
namespace {

using reports::BodyGroup;
using reports::EntryOf;
using reports::MetricId;
using enum reports::MetricId;

constexpr std::array kSuccesses = {kObjectSuccess5cm, kObjectSuccess10cm, kObjectSuccess20cm};
constexpr const char* kAligned =
    "world by the camera (chordal mean of orientations, mean of positions), one "
    "object_from_gtobject per body in closed form over its frames";
constexpr const char* kWorldAligned =
    "world by the camera (chordal mean of orientations, mean of positions)";
constexpr const char* kMeanOfBodies = "root mean square per body, mean over bodies";

// What tells which body a cluster is, in the words of contracts. It is said in the pairing alone,
// so that figures which differ in it alone show that they do.
struct MatchWords {
  std::string counted;   // frames that errors are taken in
  std::string in_frame;  // a body's cluster in one frame
  std::string clusters;  // that are matched at all
};

MatchWords Words(MatchBy match_by) {
  if (match_by == MatchBy::kLandmarks) {
    const std::string enough = StrCat("at least ", kLandmarksThatCount);
    return {StrCat("visible frames with ", enough,
                   " observed landmarks of the cluster matched to the body by shared landmarks"),
            StrCat("a body's cluster: the one with the most landmarks on it, ", enough),
            StrCat("clusters with ", enough,
                   " observed landmarks in some frame, matched by shared landmarks")};
  }
  const std::string nearness =
      "nearness (1 - distance of the centres seen from the camera / diagonal of the true box)";
  return {StrCat("visible frames with a pose of the cluster matched to the body by the largest sum "
                 "over frames of ",
                 nearness),
          StrCat("a body's cluster: one-to-one by ", nearness, " in the frame"),
          StrCat("clusters with a pose in some frame, matched by the largest sum over frames of ",
                 nearness)};
}

// The bodies that share a row, and what their metrics have in common.
struct Group {
  BodyGroup form = BodyGroup::kMovers;
  MatchWords words;
  std::vector<const BodyScore*> bodies;
  MetricContract contract;
  std::int64_t visible = 0;    // object-frames
  std::int64_t estimated = 0;  // of these

  Metric Make(MetricId id, double value, std::int64_t n, const MetricContract& of) const {
    return MakeMetric({id, form}, value, n, of);
  }
  bool Tells(const BodyScore& body) const { return body.estimated_frames > 0; }
};

std::string Unjudged(const Group& group) {
  std::int64_t matched = 0;
  for (const BodyScore* body : group.bodies) matched += group.Tells(*body) ? 1 : 0;
  return StrCat(static_cast<std::int64_t>(group.bodies.size()) - matched, " of ",
                group.bodies.size(), " bodies without an estimate, ",
                group.visible - group.estimated, " of ", group.visible,
                " visible object-frames without one");
}

Group MakeGroup(const ObjectTruth& truth, const ObjectScores& scores, bool movers) {
  Group group;
  group.words = Words(scores.match_by);
  group.form = movers ? BodyGroup::kMovers : BodyGroup::kStanding;
  for (const BodyScore& body : scores.bodies) {
    if (body.mover != movers) continue;
    group.bodies.push_back(&body);
    group.visible += body.visible_frames;
    group.estimated += body.estimated_frames;
  }
  group.contract.frame = StrCat("bodies that travel ", movers ? "more than " : "at most ",
                                truth.mover_travel_m, " m, in the world of the truth");
  group.contract.truth = StrCat(truth.source, "; visible: ", truth.visibility);
  group.contract.alignment = "none";
  group.contract.delta = "none";
  group.contract.left_out = Unjudged(group);
  return group;
}

MetricContract With(const Group& group, const char* alignment, const std::string& pairing,
                    const char* delta, const std::string& aggregation) {
  MetricContract contract = group.contract;
  contract.alignment = alignment;
  contract.pairing = pairing;
  contract.delta = delta;
  contract.aggregation = aggregation;
  return contract;
}

// Frames of which a fraction is taken: nothing is left out of them.
MetricContract Fraction(const Group& group, const char* alignment, const std::string& of) {
  MetricContract contract =
      With(group, alignment, "all visible object-frames; estimates: " + group.words.counted, "none",
           StrCat("fraction of object-frames ", of, "; one without an estimate has none"));
  contract.left_out = "nothing";
  return contract;
}

std::int64_t Within(const std::vector<ObjectFrameError>& errors, double limit_m) {
  return std::count_if(errors.begin(), errors.end(),
                       [&](const ObjectFrameError& error) { return error.position_m <= limit_m; });
}

double Ratio(std::int64_t part, std::int64_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

std::string WithinText(MetricId id) {
  return StrCat("with a position error of at most ", 100.0 * EntryOf(id).limit_m, " cm");
}

void AddFractions(const Group& group, std::vector<Metric>& metrics) {
  metrics.push_back(group.Make(kObjectCoverage, Ratio(group.estimated, group.visible),
                               group.visible, Fraction(group, "none", "with an estimate")));
  for (const MetricId id : kSuccesses) {
    std::int64_t successes = 0;
    for (const BodyScore* body : group.bodies) {
      successes += Within(body->errors, EntryOf(id).limit_m);
    }
    metrics.push_back(group.Make(id, Ratio(successes, group.visible), group.visible,
                                 Fraction(group, kAligned, WithinText(id))));
  }
}

// The mean over the bodies that determine the value; absent where none does.
template <typename ValueOf>
void AddMean(const Group& group, MetricId id, const MetricContract& contract,
             const ValueOf& value_of, std::vector<Metric>& metrics) {
  double sum = 0.0;
  std::int64_t n = 0;
  for (const BodyScore* body : group.bodies) {
    const std::optional<double> value = value_of(*body);
    if (!value) continue;
    sum += *value;
    ++n;
  }
  if (n > 0) metrics.push_back(group.Make(id, sum / static_cast<double>(n), n, contract));
}

template <typename Member>
auto Rotation(Member member) {
  return [=](const BodyScore& body) -> std::optional<double> {
    if (!(body.*member)) return std::nullopt;
    return (body.*member)->rotation_rad;
  };
}
template <typename Member>
auto Translation(Member member) {
  return [=](const BodyScore& body) -> std::optional<double> {
    if (!(body.*member)) return std::nullopt;
    return (body.*member)->translation_m;
  };
}

void AddErrors(const ObjectTruth& truth, const Group& group, std::vector<Metric>& metrics) {
  const std::string& counted = group.words.counted;
  AddMean(
      group, kObjectAte, With(group, kAligned, counted, "none", kMeanOfBodies),
      [](const BodyScore& body) { return body.ate_m; }, metrics);
  const MetricContract all =
      With(group, kAligned, "all ordered pairs i != j of " + counted, "all", kMeanOfBodies);
  AddMean(group, kObjectRrpeAllPairs, all, Rotation(&BodyScore::all_pairs), metrics);
  AddMean(group, kObjectTrpeAllPairs, all, Translation(&BodyScore::all_pairs), metrics);
  const MetricContract one =
      With(group, kAligned, "consecutive " + counted, "1 frame", kMeanOfBodies);
  AddMean(group, kObjectRrpe1Frame, one, Rotation(&BodyScore::one_frame), metrics);
  AddMean(group, kObjectTrpe1Frame, one, Translation(&BodyScore::one_frame), metrics);
  const MetricContract motion =
      With(group, kWorldAligned,
           StrCat("consecutive ", counted, ", within frames ", truth.first_frame, " to ",
                  truth.first_frame + static_cast<int>(truth.frame_count()) - 1,
                  "; E = G_k^-1 H_gt^-1 H_est G_k with the motion H = P_k+1 P_k^-1 in world"),
           "1 frame", kMeanOfBodies);
  AddMean(group, kObjectMotionR, motion, Rotation(&BodyScore::motion), metrics);
  AddMean(group, kObjectMotionT, motion, Translation(&BodyScore::motion), metrics);
  AddMean(
      group, kObjectVelocity,
      With(group, kAligned, counted + ", against differences of true positions of the same point",
           "central difference, one-sided where the truth begins or ends", kMeanOfBodies),
      [](const BodyScore& body) { return body.velocity_m_s; }, metrics);
}

void AddCounts(const Group& group, std::vector<Metric>& metrics) {
  std::int64_t switches = 0;
  std::int64_t fragments = 0;
  std::int64_t unmatched = 0;
  for (const BodyScore* body : group.bodies) {
    switches += body->continuity.id_switches;
    fragments += body->continuity.fragments;
    unmatched += body->cluster == -1 ? 1 : 0;
  }
  const auto n = static_cast<std::int64_t>(group.bodies.size());
  const auto add = [&](MetricId id, std::int64_t count, const std::string& how, const char* of) {
    MetricContract contract = With(group, "none", "all visible object-frames; " + how, "none", of);
    contract.left_out = "nothing";
    metrics.push_back(group.Make(id, static_cast<double>(count), n, contract));
  };
  add(kObjectIdSwitches, switches, group.words.in_frame,
      "number of times a body's cluster is another than the last one");
  add(kObjectFragments, fragments, group.words.in_frame,
      "number of times a body has a cluster again after visible frames without one");
  add(kObjectUnmatched, unmatched, group.words.clusters,
      "number of bodies matched to no cluster, one-to-one");
}

void AddGroup(const ObjectTruth& truth, const Group& group, std::vector<Metric>& metrics) {
  if (group.visible == 0) return;
  AddFractions(group, metrics);
  AddErrors(truth, group, metrics);
  AddCounts(group, metrics);
}

void AddPredicted(const Group& movers, std::vector<Metric>& metrics) {
  std::int64_t frames = 0;
  for (const BodyScore* body : movers.bodies) {
    frames += static_cast<std::int64_t>(body->predicted.size());
  }
  if (frames == 0) return;
  Group group = movers;
  group.form = BodyGroup::kPredicted;
  group.contract.left_out = "bodies that are estimated in no frame";
  const std::string pairing = StrCat(
      "object-frames, visible or not, where the pose is predicted "
      "or fewer than ",
      kLandmarksThatCount, " landmarks are observed");
  AddMean(
      group, kObjectAte, With(group, kAligned, pairing, "none", kMeanOfBodies),
      [](const BodyScore& body) { return body.predicted_ate_m; }, metrics);
  for (const MetricId id : kSuccesses) {
    std::int64_t successes = 0;
    for (const BodyScore* body : group.bodies) {
      successes += Within(body->predicted, EntryOf(id).limit_m);
    }
    metrics.push_back(
        group.Make(id, Ratio(successes, frames), frames,
                   With(group, kAligned, pairing, "none", "fraction " + WithinText(id))));
  }
}

void AddUnmatchedClusters(const ObjectTruth& truth, const ObjectScores& scores,
                          std::vector<Metric>& metrics) {
  if (scores.clusters == 0) return;
  MetricContract contract;
  contract.frame = "clusters";
  contract.truth = truth.source;
  contract.alignment = "none";
  contract.pairing = Words(scores.match_by).clusters;
  contract.delta = "none";
  contract.aggregation = "number matched to no body, one-to-one";
  contract.left_out = "nothing";
  metrics.push_back(MakeMetric({kObjectUnmatchedClusters},
                               static_cast<double>(scores.unmatched_clusters), scores.clusters,
                               contract));
}

}  // namespace

std::vector<Metric> ObjectMetrics(const ObjectTruth& truth, const ObjectScores& scores) {
  std::vector<Metric> metrics;
  const Group movers = MakeGroup(truth, scores, true);
  AddGroup(truth, movers, metrics);
  AddPredicted(movers, metrics);
  AddGroup(truth, MakeGroup(truth, scores, false), metrics);
  AddUnmatchedClusters(truth, scores, metrics);
  for (const Metric& metric : metrics) {
    if (!std::isfinite(metric.value)) ThrowError(metric.name, "an overflow", "a finite number");
  }
  return metrics;
}

}  // namespace cvo
