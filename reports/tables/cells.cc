// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
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
  Within within() const {
    return entry().kind == MetricKind::kCount ? Within::kSum : Within::kMean;
  }
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

// The scenes of a row. One under several names has the first of them in statistics: scenes are told
// apart by their images and what was done to these, where both are known.
class SceneNames {
 public:
  const std::string& Of(const SuiteRun& run) {
    const RunSequence& sequence = run.run->sequence;
    const std::string name = SceneOf(run);
    if (sequence.images.empty()) return names_.try_emplace(name, name).first->second;
    const std::string changes = sequence.perturbation ? sequence.perturbation->dump() : "";
    return names_.try_emplace(StrCat(sequence.images, changes), name).first->second;
  }

 private:
  std::map<std::string, std::string> names_;
};

// The samples of a cell, and what is missing from them.
struct Gathered {
  std::vector<Sample> samples;
  std::set<std::string> scenes;
  std::set<std::uint64_t> seeds;
  std::size_t bodies = 0;          // summed over runs
  std::size_t bodies_without = 0;  // of these, bodies without a value
  std::size_t runs_without = 0;
};

std::string BodyName(const BodyRow& body) { return StrCat("body ", body.id); }

// The bodies of a run from which the metric is computed.
const std::vector<BodyRow>& BodiesOf(const BodyMetric& metric, const RunSummary& run) {
  static const std::vector<BodyRow> kNone;
  if (!run.bodies) return kNone;
  return metric.form.causal ? run.bodies->causal : run.bodies->refined;
}

void GatherBodies(const SuiteRun& run, const BodyMetric& metric, const std::string& scene,
                  const std::string& repetition, Gathered& gathered) {
  for (const BodyRow& body : BodiesOf(metric, *run.run)) {
    if (body.mover != metric.movers()) continue;
    ++gathered.bodies;
    const auto part = PartOf(metric, body);
    if (part)
      gathered.samples.push_back({run.planned.family, scene, BodyName(body), repetition, *part});
    if (!part) ++gathered.bodies_without;
  }
}

Gathered Gather(const RowRuns& row, const std::vector<std::string>& keys, const Column& column,
                const std::optional<BodyMetric>& body_metric, Cell& cell) {
  Gathered gathered;
  SceneNames names;
  std::size_t index = 0;
  for (const SuiteRun* run : row.runs) {
    if (!run->run) continue;
    const MetricValue* metric = FindMetric(*run->run, column.metric);
    const std::string& scene = names.Of(*run);
    const std::string repetition = StrCat(SceneOf(*run), " ", RepetitionOf(*run, keys));
    const std::size_t before = gathered.samples.size();
    if (metric != nullptr && body_metric) {
      GatherBodies(*run, *body_metric, scene, repetition, gathered);
    }
    if (metric != nullptr && !body_metric) {
      gathered.samples.push_back({run->planned.family, scene, "", repetition, {metric->value}});
    }
    if (gathered.samples.size() > before) {
      gathered.scenes.insert(scene);
      gathered.seeds.insert(run->planned.seed);
      cell.runs.push_back(index);
    } else {
      ++gathered.runs_without;
    }
    ++index;
  }
  return gathered;
}

std::string LeftOutText(const Gathered& gathered, std::size_t runs) {
  std::string left_out;
  if (gathered.runs_without > 0) {
    left_out = StrCat("no value in ", gathered.runs_without, " of ", runs, " runs");
  }
  if (gathered.bodies_without > 0) {
    left_out += StrCat(left_out.empty() ? "" : "; ", gathered.bodies_without, " of ",
                       gathered.bodies, " bodies (of all runs) without a value");
  }
  return left_out;
}

// Describes what an interval resamples. Runs of several seeds of a scene count as one.
std::string Resampled(std::size_t scenes, std::size_t bodies, bool families, std::size_t seeds) {
  const std::string what =
      scenes == 1 ? StrCat(bodies, " bodies of one scene: says nothing about other scenes")
                  : StrCat(scenes, " scenes", families ? " within their families" : "");
  return StrCat("95 %, bootstrap over ", what, seeds > 1 ? "; seeds averaged" : "");
}

bool OfSeveralFamilies(const std::vector<Sample>& samples) {
  return std::any_of(samples.begin(), samples.end(),
                     [&](const Sample& sample) { return sample.family != samples.front().family; });
}

std::optional<Interval> ToInterval(const std::optional<Range>& range, const std::string& meaning) {
  if (!range) return std::nullopt;
  return Interval{range->low, range->high, meaning};
}

// The range over the runs of a single scene: there is nothing to resample, but it shows how much
// the seeds differ.
std::optional<Interval> SpreadOfSeeds(const Gathered& gathered) {
  if (gathered.scenes.size() != 1 || gathered.samples.size() < 2) return std::nullopt;
  const auto [low, high] = std::minmax_element(
      gathered.samples.begin(), gathered.samples.end(),
      [](const Sample& a, const Sample& b) { return a.value.sum < b.value.sum; });
  return Interval{low->value.sum, high->value.sum,
                  StrCat("least and largest of ", gathered.samples.size(), " runs of one scene")};
}

// The contributions of the same body in two runs. Errors that are listed by frame are taken over
// the frames that both runs have.
std::optional<std::pair<Part, Part>> PairOf(const BodyMetric& metric, const BodyRow& body,
                                            const BodyRow& reference) {
  if (body.mover != metric.movers() || reference.mover != metric.movers()) return std::nullopt;
  if (metric.by_frames()) {
    return CommonRootMeanSquares(ErrorsOf(metric, body), ErrorsOf(metric, reference));
  }
  const auto ours = PartOf(metric, body);
  const auto theirs = PartOf(metric, reference);
  if (!ours || !theirs) return std::nullopt;
  return std::pair{*ours, *theirs};
}

// Describes in words what PairOf compares.
const char* PairingText(const BodyMetric& metric) {
  if (metric.by_frames()) return "object-frames that both estimate";
  if (metric.entry().kind == MetricKind::kError)
    return "bodies that both estimate, each on its frames";
  return metric.predicted() ? "bodies of both, each on its predicted frames"
                            : "all visible object-frames";
}

// `place`: family, scene and repetition of the run.
void GatherPair(const SuiteRun& run, const SuiteRun& reference, const Sample& place,
                const std::optional<BodyMetric>& body_metric, const std::string& metric,
                std::vector<Sample>& samples) {
  if (!body_metric) {
    const MetricValue* ours = FindMetric(*run.run, metric);
    const MetricValue* theirs = FindMetric(*reference.run, metric);
    if (ours == nullptr || theirs == nullptr) return;
    samples.push_back(place);
    samples.back().value = {ours->value};
    samples.back().reference = {theirs->value};
    return;
  }
  for (const BodyRow& body : BodiesOf(*body_metric, *run.run)) {
    const BodyRow* other = FindBy(BodiesOf(*body_metric, *reference.run), &BodyRow::id, body.id);
    if (other == nullptr) continue;
    if (const auto pair = PairOf(*body_metric, body, *other)) {
      samples.push_back(place);
      samples.back().body = BodyName(body);
      std::tie(samples.back().value, samples.back().reference) = *pair;
    }
  }
}

// Converts a paired estimate. `meaning` describes the intervals, `pairing` what the two rows share.
Difference DifferenceOf(const PairedEstimate& estimate, const std::string& reference,
                        const std::string& meaning, const std::string& pairing) {
  Difference difference;
  difference.reference = reference;
  difference.value = estimate.value;
  difference.reference_value = estimate.reference;
  difference.difference = estimate.difference;
  difference.interval = ToInterval(estimate.interval, meaning);
  difference.percent = estimate.percent;
  difference.p_value = estimate.p_value;
  difference.pairs = estimate.pairs;
  difference.pairing = pairing;
  return difference;
}

}  // namespace

Cell MakeCell(const RowRuns& row, const std::vector<std::string>& keys, const Column& column) {
  Cell cell;
  const std::optional<BodyMetric> body_metric = FindBodyMetric(column.metric);
  const Gathered gathered = Gather(row, keys, column, body_metric, cell);
  const std::size_t runs = cell.runs.size() + gathered.runs_without;
  const auto estimate =
      EstimateMean(gathered.samples, body_metric ? body_metric->within() : Within::kMean);
  if (!estimate) {
    cell.message = runs == 0   ? "no result"
                   : runs == 1 ? "no value in the run"
                               : "no value in any run";
    return cell;
  }
  cell.value = estimate->value;
  cell.n = {cell.runs.size(), gathered.scenes.size(), body_metric ? estimate->bodies : 0,
            gathered.seeds.size()};
  cell.interval = ToInterval(estimate->interval,
                             Resampled(estimate->scenes, estimate->bodies,
                                       OfSeveralFamilies(gathered.samples), gathered.seeds.size()));
  if (!body_metric && !cell.interval) cell.interval = SpreadOfSeeds(gathered);
  cell.left_out = LeftOutText(gathered, runs);
  return cell;
}

std::optional<Difference> MakeDifference(const PairedRows& rows, const Column& column) {
  std::map<std::pair<std::string, std::string>, const SuiteRun*> references;
  for (const SuiteRun* run : rows.reference.runs) {
    if (run->run) references[{SceneOf(*run), RepetitionOf(*run, rows.keys)}] = run;
  }
  const std::optional<BodyMetric> body_metric = FindBodyMetric(column.metric);
  std::vector<Sample> samples;
  std::set<std::uint64_t> seeds;
  SceneNames names;
  for (const SuiteRun* run : rows.row.runs) {
    if (!run->run) continue;
    const std::string repetition = RepetitionOf(*run, rows.keys);
    const auto reference = references.find({SceneOf(*run), repetition});
    if (reference == references.end()) continue;
    Sample place;
    place.family = run->planned.family;
    place.scene = names.Of(*run);
    place.repetition = StrCat(SceneOf(*run), " ", repetition);
    GatherPair(*run, *reference->second, place, body_metric, column.metric, samples);
    seeds.insert(run->planned.seed);
  }
  const auto estimate =
      EstimateDifference(samples, body_metric ? body_metric->within() : Within::kMean);
  if (!estimate) return std::nullopt;
  const std::string meaning =
      Resampled(estimate->scenes, estimate->bodies, OfSeveralFamilies(samples), seeds.size());
  return DifferenceOf(*estimate, rows.reference_label, meaning,
                      body_metric ? PairingText(*body_metric) : "runs of the same scene and seed");
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
