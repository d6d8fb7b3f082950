// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/record/metric_catalogue.h"
#include "reports/statistics/estimate.h"

namespace cvo::reports {
namespace {

// How a metric of a run is computed from its bodies.
struct BodyMetric {
  MetricForm form;

  const MetricEntry& entry() const { return EntryOf(form.id); }
  bool predicted() const { return form.bodies == BodyGroup::kPredicted; }
  bool movers() const { return form.bodies != BodyGroup::kStanding; }
  // Whether the errors of the metric are listed frame by frame.
  bool by_frames() const { return form.id == MetricId::kObjectAte; }
};

// Empty if the metric is not about bodies.
std::optional<BodyMetric> FindBodyMetric(const std::string& metric) {
  const std::optional<MetricForm> form = FindForm(metric);
  if (!form || EntryOf(form->id).family != MetricFamily::kBodies) return std::nullopt;
  return BodyMetric{*form};
}

const FrameErrors& ErrorsOf(const BodyMetric& metric, const BodyRow& body) {
  return metric.predicted() ? body.predicted : body.errors;
}

// Over the frames that both have.
std::optional<std::pair<Part, Part>> CommonRootMeanSquares(const FrameErrors& a,
                                                           const FrameErrors& b) {
  double sum_a = 0.0;
  double sum_b = 0.0;
  int n = 0;
  for (std::size_t i = 0, j = 0; i < a.frames.size() && j < b.frames.size();) {
    const int frame = a.frames[i];
    const int other = b.frames[j];
    if (frame == other) {
      sum_a += a.position_m[i] * a.position_m[i];
      sum_b += b.position_m[j] * b.position_m[j];
      ++n;
    }
    if (frame <= other) ++i;
    if (other <= frame) ++j;
  }
  if (n == 0) return std::nullopt;
  return std::pair{Part{std::sqrt(sum_a / n)}, Part{std::sqrt(sum_b / n)}};
}

std::optional<Part> FractionOf(const BodyMetric& metric, const BodyRow& body) {
  const FrameErrors& errors = ErrorsOf(metric, body);
  const int frames =
      metric.predicted() ? static_cast<int>(errors.frames.size()) : body.visible_frames;
  if (frames <= 0) return std::nullopt;
  const auto within =
      std::count_if(errors.position_m.begin(), errors.position_m.end(),
                    [&](double error_m) { return error_m <= metric.entry().limit_m; });
  return Part{static_cast<double>(within), static_cast<double>(frames)};
}

// The contribution of a body to the metric. Empty if the metric does not apply to the body or the
// run has no value for it.
std::optional<Part> PartOf(const BodyMetric& metric, const BodyRow& body) {
  if (body.mover != metric.movers()) return std::nullopt;
  const MetricEntry& entry = metric.entry();
  switch (entry.from_body) {
    case FromBody::kSuccess:
      return FractionOf(metric, body);
    case FromBody::kUnmatched:
      return Part{body.cluster == -1 ? 1.0 : 0.0};
    case FromBody::kSum:
      return Part{static_cast<double>(body.*entry.body_count)};
    case FromBody::kCoverage:
      if (body.visible_frames <= 0) return std::nullopt;
      return Part{static_cast<double>(body.estimated_frames),
                  static_cast<double>(body.visible_frames)};
    case FromBody::kField: {
      const std::optional<double>& error =
          metric.predicted() ? body.predicted_ate_m : body.*entry.body_error;
      return error ? std::optional(Part{*error}) : std::nullopt;
    }
    case FromBody::kMaxDrift:
      if (!body.max_drift) return std::nullopt;
      return Part{body.max_drift->Values().at(MaxDriftIndex(entry.id).value())};
    case FromBody::kNothing:
      break;
  }
  return std::nullopt;
}

// The bodies of a run from which the metric is computed.
const std::vector<BodyRow>& BodiesOf(const BodyMetric& metric, const RunSummary& run) {
  static const std::vector<BodyRow> kNone;
  if (!run.bodies) return kNone;
  return metric.form.causal ? run.bodies->causal : run.bodies->refined;
}

// The contributions of a body and, if there is a reference run, of the same body there. Errors that
// are listed by frame are then taken over the frames that both runs have.
std::optional<std::pair<Part, Part>> PartsOf(const BodyMetric& metric, const BodyRow& body,
                                             const RunSummary* reference) {
  const BodyRow* other =
      reference ? FindBy(BodiesOf(metric, *reference), &BodyRow::id, body.id) : nullptr;
  if (reference && (other == nullptr || other->mover != metric.movers())) return std::nullopt;
  if (reference && metric.by_frames()) {
    return CommonRootMeanSquares(ErrorsOf(metric, body), ErrorsOf(metric, *other));
  }
  const auto ours = PartOf(metric, body);
  const auto theirs = reference ? PartOf(metric, *other) : Part{};
  if (!ours || !theirs) return std::nullopt;
  return std::pair{*ours, *theirs};
}

// The samples of a cell, or of a difference, and what is missing from them.
struct Gathered {
  std::vector<Sample> samples;
  std::set<std::string> scenes;
  std::set<std::uint64_t> seeds;
  std::size_t runs = 0;            // that exist
  std::size_t used = 0;            // of these, runs with a value
  std::size_t bodies = 0;          // summed over runs
  std::size_t bodies_without = 0;  // of these, bodies without a value
};

// `place`: family, scene and repetition of the run.
void GatherRun(const RunSummary& run, const RunSummary* reference, const Sample& place,
               const std::string& metric, Gathered& gathered) {
  const MetricValue* ours = FindMetric(run, metric);
  const MetricValue* theirs = reference ? FindMetric(*reference, metric) : nullptr;
  if (ours == nullptr || (reference && theirs == nullptr)) return;
  const std::optional<BodyMetric> body_metric = FindBodyMetric(metric);
  const auto add = [&](const std::string& body, const Part& value, const Part& other) {
    Sample& sample = gathered.samples.emplace_back(place);
    sample.body = body;
    sample.value = value;
    sample.reference = other;
  };
  if (!body_metric) return add("", {ours->value}, {theirs ? theirs->value : 0.0});
  for (const BodyRow& body : BodiesOf(*body_metric, run)) {
    if (body.mover != body_metric->movers()) continue;
    ++gathered.bodies;
    const auto parts = PartsOf(*body_metric, body, reference);
    if (parts) add(StrCat("body ", body.id), parts->first, parts->second);
    if (!parts) ++gathered.bodies_without;
  }
}

// Of a row or, with a reference, of the runs of the same scene and repetition.
Gathered Gather(const RowRuns& row, const RowRuns* reference, const std::vector<std::string>& keys,
                const std::string& metric) {
  const auto repetition_of = [&keys](const SuiteRun& run) {
    return StrCat(SceneOf(run), " ", RepetitionOf(run, keys));
  };
  std::map<std::string, const SuiteRun*> references;
  for (const SuiteRun* run : reference ? reference->runs : std::vector<const SuiteRun*>()) {
    if (run->run) references[repetition_of(*run)] = run;
  }
  Gathered gathered;
  SceneNames names;
  for (const SuiteRun* run : row.runs) {
    if (!run->run) continue;
    Sample place;
    place.repetition = repetition_of(*run);
    const auto other = references.find(place.repetition);
    if (reference && other == references.end()) continue;
    const RunSequence& sequence = run->run->sequence;
    const std::string changes = sequence.perturbation ? sequence.perturbation->dump() : "";
    place.family = run->planned.family;
    place.scene = names.Of(sequence.images.empty() ? "" : sequence.images + changes, SceneOf(*run));
    ++gathered.runs;
    const std::size_t before = gathered.samples.size();
    GatherRun(*run->run, reference ? &*other->second->run : nullptr, place, metric, gathered);
    if (gathered.samples.size() == before) continue;
    ++gathered.used;
    gathered.scenes.insert(place.scene);
    gathered.seeds.insert(run->planned.seed);
  }
  return gathered;
}

// The mean of camera_truth_gap over the runs of a row, for a position error of the camera.
std::optional<double> TruthGap(const RowRuns& row, const std::string& metric) {
  const std::optional<MetricForm> form = FindForm(metric);
  if (!form || form->id < MetricId::kCameraAte || form->id > MetricId::kCameraAteVelocity) {
    return std::nullopt;
  }
  std::vector<double> gaps;
  for (const SuiteRun* run : row.runs) {
    const MetricValue* gap =
        run->run ? FindMetric(*run->run, MetricName({MetricId::kCameraTruthGap})) : nullptr;
    if (gap) gaps.push_back(gap->value);
  }
  return gaps.empty() ? std::nullopt : std::optional(MeanOf(gaps));
}

Within WithinOf(const std::string& metric) {
  const bool count = FindBodyMetric(metric) && FindEntry(metric)->kind == MetricKind::kCount;
  return count ? Within::kSum : Within::kMean;
}

// The range over the runs of a single scene: there is nothing to resample, but it shows how much
// the seeds differ.
std::optional<Interval> SpreadOfSeeds(const Gathered& gathered) {
  if (gathered.scenes.size() != 1 || gathered.samples.size() < 2) return std::nullopt;
  const auto [low, high] = std::minmax_element(
      gathered.samples.begin(), gathered.samples.end(),
      [](const Sample& a, const Sample& b) { return a.value.sum < b.value.sum; });
  return Interval{low->value.sum, high->value.sum};
}

}  // namespace

Cell MakeCell(const RowRuns& row, const std::vector<std::string>& keys, const Column& column) {
  Cell cell;
  const bool of_bodies = FindBodyMetric(column.metric).has_value();
  const Gathered gathered = Gather(row, nullptr, keys, column.metric);
  const auto estimate = EstimateMean(gathered.samples, WithinOf(column.metric));
  if (!estimate) {
    cell.message = gathered.runs == 0   ? "no result"
                   : gathered.runs == 1 ? "no value in the run"
                                        : "no value in any run";
    return cell;
  }
  cell.value = estimate->value;
  cell.n = {gathered.used, gathered.scenes.size(), of_bodies ? estimate->bodies : 0,
            gathered.seeds.size()};
  cell.interval = estimate->interval;
  if (!of_bodies && !cell.interval) cell.interval = SpreadOfSeeds(gathered);
  if (gathered.used < gathered.runs) {
    cell.left_out =
        StrCat("no value in ", gathered.runs - gathered.used, " of ", gathered.runs, " runs");
  }
  if (gathered.bodies_without > 0) {
    cell.left_out += StrCat(cell.left_out.empty() ? "" : "; ", gathered.bodies_without, " of ",
                            gathered.bodies, " bodies (of all runs) without a value");
  }
  return cell;
}

std::optional<Difference> MakeDifference(const RowRuns& row, const RowRuns& reference,
                                         const std::vector<std::string>& keys,
                                         const Column& column) {
  const auto estimate = EstimateDifference(Gather(row, &reference, keys, column.metric).samples,
                                           WithinOf(column.metric));
  if (!estimate) return std::nullopt;
  Difference difference = {*estimate};
  const std::optional<double> gap = TruthGap(row, column.metric);
  if (gap && std::abs(difference.difference) < *gap) {
    difference.truth_gap = gap;
    difference.percent.reset();
    difference.p_value.reset();
  }
  return difference;
}

void CorrectForMany(const std::vector<Difference*>& differences) {
  std::vector<Difference*> tested;
  std::vector<double> p_values;
  for (Difference* difference : differences) {
    if (!difference->p_value) continue;
    tested.push_back(difference);
    p_values.push_back(*difference->p_value);
  }
  const std::vector<double> adjusted = HolmAdjusted(p_values);
  for (std::size_t i = 0; i < tested.size(); ++i) {
    Difference& difference = *tested[i];
    difference.adjusted_p_value = adjusted[i];
    const auto& interval = difference.interval;
    difference.distinguishable = interval && (interval->low > 0.0 || interval->high < 0.0) &&
                                 adjusted[i] < 1.0 - kConfidence && difference.pairs >= kMinPairs;
  }
}

}  // namespace cvo::reports
