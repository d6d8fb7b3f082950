// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/base/error.h"
#include "experiments/metrics/objects/object_scores.h"

namespace cvo {
namespace {

using reports::BodyGroup;
using reports::EntryOf;
using reports::MetricId;
using enum reports::MetricId;

constexpr std::array kSuccesses = {kObjectSuccess5cm, kObjectSuccess10cm, kObjectSuccess20cm};

// The bodies of one group of metrics, and what these metrics have in common.
struct Group {
  BodyGroup form = BodyGroup::kMovers;
  std::vector<const BodyScore*> bodies;
  reports::Contract contract;
  std::string left_out;
  bool differentiated = false;  // ObjectScores::differentiated
  std::int64_t visible = 0;     // object-frames
  std::int64_t estimated = 0;   // of these

  // Makes a metric of errors, which leaves out what has no estimate.
  Metric Error(MetricId id, double value, std::int64_t n) const {
    Metric metric = MakeMetric({id, form}, value, n);
    StateTruth(contract, metric);
    metric.left_out = left_out;
    return metric;
  }
  // Makes a metric of fractions or counts, which leave nothing out.
  Metric Whole(MetricId id, double value, std::int64_t n) const {
    Metric metric = Error(id, value, n);
    metric.left_out = "nothing";
    return metric;
  }
  bool Tells(const BodyScore& body) const { return body.estimated_frames > 0; }

  static void StateTruth(const reports::Contract& contract, Metric& metric) {
    metric.contract = WithTruthOf(metric.contract, contract);
    metric.contract.subject = contract.subject;
    metric.contract.travel_m = contract.travel_m;
    metric.contract.matching = contract.matching;
    metric.contract.least_landmarks = contract.least_landmarks;
  }
};

std::string UnmatchedBodiesText(const Group& group) {
  std::int64_t matched = 0;
  for (const BodyScore* body : group.bodies) matched += group.Tells(*body) ? 1 : 0;
  return StrCat(static_cast<std::int64_t>(group.bodies.size()) - matched, " of ",
                group.bodies.size(), " bodies without an estimate, ",
                group.visible - group.estimated, " of ", group.visible,
                " visible object-frames without one");
}

// The contract of the truth, with how clusters are matched to bodies.
reports::Contract MatchingOf(const ObjectTruth& truth, const ObjectScores& scores) {
  reports::Contract contract = truth.contract;
  contract.matching = scores.match_by;
  if (scores.match_by == MatchBy::kLandmarks) contract.least_landmarks = kMinObservedLandmarks;
  return contract;
}

Group MakeGroup(const ObjectTruth& truth, const ObjectScores& scores, bool movers) {
  Group group;
  group.form = movers ? BodyGroup::kMovers : BodyGroup::kStanding;
  for (const BodyScore& body : scores.bodies) {
    if (body.mover != movers) continue;
    group.bodies.push_back(&body);
    group.visible += body.visible_frames;
    group.estimated += body.estimated_frames;
  }
  group.contract = MatchingOf(truth, scores);
  group.contract.subject = movers ? reports::Subject::kMovers : reports::Subject::kStanding;
  group.contract.travel_m = truth.mover_travel_m;
  group.differentiated = scores.differentiated;
  group.left_out = UnmatchedBodiesText(group);
  return group;
}

std::int64_t Within(const reports::FrameErrors& errors, double limit_m) {
  return std::count_if(errors.position_m.begin(), errors.position_m.end(),
                       [&](double error_m) { return error_m <= limit_m; });
}

double Ratio(std::int64_t part, std::int64_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

void AddFractions(const Group& group, std::vector<Metric>& metrics) {
  metrics.push_back(
      group.Whole(kObjectCoverage, Ratio(group.estimated, group.visible), group.visible));
  for (const MetricId id : kSuccesses) {
    std::int64_t successes = 0;
    for (const BodyScore* body : group.bodies) {
      successes += Within(body->errors, EntryOf(id).limit_m);
    }
    metrics.push_back(group.Whole(id, Ratio(successes, group.visible), group.visible));
  }
}

// Adds the mean over the bodies that determine the value; absent if none does.
template <typename Value>
void AddMean(const Group& group, MetricId id, Value value, std::vector<Metric>& metrics) {
  double sum = 0.0;
  std::int64_t n = 0;
  for (const BodyScore* body : group.bodies) {
    const std::optional<double> of_body = std::invoke(value, *body);
    if (!of_body) continue;
    sum += *of_body;
    ++n;
  }
  if (n > 0) metrics.push_back(group.Error(id, sum / static_cast<double>(n), n));
}

void AddMaxDrift(const Group& group, std::vector<Metric>& metrics) {
  for (std::size_t i = 0; i < reports::MaxDrifts().Values().size(); ++i) {
    const auto value = [i](const BodyScore& body) -> std::optional<double> {
      return body.max_drift ? std::optional(body.max_drift->Values().at(i)) : std::nullopt;
    };
    AddMean(group, reports::MaxDriftMetric(kObjectMaxDrift, i), value, metrics);
  }
}

void AddVelocity(const Group& group, std::vector<Metric>& metrics) {
  const std::size_t before = metrics.size();
  AddMean(group, kObjectVelocity, &BodyScore::velocity_m_s, metrics);
  if (group.differentiated && metrics.size() > before) {
    metrics.back().contract.pairing = reports::Pairing::kVelocitiesOfPositions;
  }
}

void AddErrors(const ObjectTruth& truth, const Group& group, std::vector<Metric>& metrics) {
  AddMean(group, kObjectAte, &BodyScore::ate_m, metrics);
  AddMean(group, kObjectRrpeAllPairs, &BodyScore::all_pairs_rad, metrics);
  AddMean(group, kObjectTrpeAllPairs, &BodyScore::all_pairs_m, metrics);
  AddMean(group, kObjectRrpe1Frame, &BodyScore::one_frame_rad, metrics);
  AddMean(group, kObjectTrpe1Frame, &BodyScore::one_frame_m, metrics);
  const std::size_t before = metrics.size();
  AddMean(group, kObjectMotionR, &BodyScore::motion_rad, metrics);
  AddMean(group, kObjectMotionT, &BodyScore::motion_m, metrics);
  AddMean(group, kObjectMotionTInCamera, &BodyScore::motion_in_camera_m, metrics);
  for (std::size_t i = before; i < metrics.size(); ++i) {
    metrics[i].contract.frames = reports::FrameSpan{
        truth.first_frame, truth.first_frame + static_cast<int>(truth.frame_count()) - 1};
  }
  AddMean(group, kObjectAteInCamera, &BodyScore::ate_in_camera_m, metrics);
  AddVelocity(group, metrics);
  if (group.form == BodyGroup::kMovers) AddMaxDrift(group, metrics);
}

void AddCounts(const Group& group, std::vector<Metric>& metrics) {
  std::int64_t switches = 0;
  std::int64_t fragments = 0;
  std::int64_t joins = 0;
  std::int64_t wrong_joins = 0;
  std::int64_t unmatched = 0;
  for (const BodyScore* body : group.bodies) {
    switches += body->id_switches;
    fragments += body->fragments;
    joins += body->joins;
    wrong_joins += body->wrong_joins;
    unmatched += body->cluster == -1 ? 1 : 0;
  }
  const auto n = static_cast<std::int64_t>(group.bodies.size());
  metrics.push_back(group.Whole(kObjectIdSwitches, static_cast<double>(switches), n));
  metrics.push_back(group.Whole(kObjectFragments, static_cast<double>(fragments), n));
  metrics.push_back(group.Whole(kObjectJoins, static_cast<double>(joins), n));
  metrics.push_back(group.Whole(kObjectWrongJoins, static_cast<double>(wrong_joins), n));
  metrics.push_back(group.Whole(kObjectUnmatched, static_cast<double>(unmatched), n));
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
    frames += static_cast<std::int64_t>(body->predicted.frames.size());
  }
  if (frames == 0) return;
  Group group = movers;
  group.form = BodyGroup::kPredicted;
  group.left_out = "bodies that are estimated in no frame";
  AddMean(group, kObjectAte, &BodyScore::predicted_ate_m, metrics);
  for (const MetricId id : kSuccesses) {
    std::int64_t successes = 0;
    for (const BodyScore* body : group.bodies) {
      successes += Within(body->predicted, EntryOf(id).limit_m);
    }
    metrics.push_back(group.Error(id, Ratio(successes, frames), frames));
  }
}

void AddUnmatchedClusters(const ObjectTruth& truth, const ObjectScores& scores,
                          std::vector<Metric>& metrics) {
  if (scores.clusters == 0) return;
  Group group;
  group.contract = MatchingOf(truth, scores);
  group.contract.subject = reports::Subject::kClusters;
  metrics.push_back(group.Whole(kObjectUnmatchedClusters,
                                static_cast<double>(scores.unmatched_clusters), scores.clusters));
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
