// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "core/base/lists.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/run.h"

namespace cvo {
namespace {

const std::string kNone = "-";

// Returns "camera_ate" for "camera_causal_ate".
std::string WithoutCausal(const std::string& name) {
  reports::MetricForm form = reports::FindForm(name).value();
  form.causal = false;
  return reports::MetricName(form);
}

// Whether the metric is printed by default.
bool IsKeyMetric(const std::string& name) {
  constexpr std::array<std::string_view, 8> kKey = {
      "camera_ate",          "camera_trpe_1_frame", "camera_rrpe_1_frame", "object_ate",
      "object_success_10cm", "object_coverage",     "moving_precision",    "moving_recall"};
  return std::find(kKey.begin(), kKey.end(), name) != kKey.end();
}

std::string Value(const std::optional<double>& value) {
  return value ? ReadableNumber(*value) : kNone;
}

std::string SuccessAt10cm(const BodyScore& body) {
  constexpr double kLimit_m = 0.1;
  const std::vector<double>& errors_m = body.errors.position_m;
  const auto within = std::count_if(errors_m.begin(), errors_m.end(),
                                    [](double error_m) { return error_m <= kLimit_m; });
  return ReadableNumber(static_cast<double>(within) / body.visible_frames);
}

}  // namespace

void PrintDetections(const Sequence& sequence, const DetectionCounts& counts, std::ostream& out) {
  if (sequence.box_sources.detections.empty()) return;
  out << "detections: " << counts.given << " used";
  if (sequence.detections.empty() && sequence.low_scores == 0) out << ", none in the frames read";
  const char* separator = "; left out: ";
  const auto left_out = [&](int count, const std::string& why) {
    if (count == 0) return;
    out << separator << count << ' ' << why;
    separator = ", ";
  };
  left_out(sequence.low_scores, "below --min-score");
  left_out(counts.outside, "outside the image");
  left_out(counts.skipped, "of skipped frames");
  for (const auto& [type, count] : counts.other_classes) left_out(count, "of class " + type);
  if (counts.without_depth > 0) {
    out << "; " << counts.without_depth
        << " used where they were detected, because no feature gives a depth to move them to this "
           "camera";
  }
  out << '\n';
  int negative = 0;
  int positive = 0;
  for (const ObjectBox& box : sequence.detections) {
    negative += box.score && *box.score < 0.0 ? 1 : 0;
    positive += box.score && *box.score > 0.0 ? 1 : 0;
  }
  if (negative == 0) return;
  out << "warning: of " << sequence.detections.size() << " boxes in the file, " << positive
      << " have a score above 0: --min-score 0 leaves out the others\n";
}

void PrintScores(const RunScores& scores, bool all, std::ostream& out) {
  TextTable table({"metric", "refined", "causal", "unit", "n"});
  const auto row = [&table, all](const Metric& metric, const std::string& refined,
                                 const std::string& causal) {
    if (!all && !IsKeyMetric(metric.name)) return;
    table.Add({WithoutCausal(metric.name), refined, causal, NameOf(metric.unit),
               std::to_string(metric.n)});
  };
  for (const Metric& refined : scores.refined) {
    const Metric* causal = FindBy(
        scores.causal, [](const Metric& metric) { return WithoutCausal(metric.name); },
        refined.name);
    row(refined, ReadableNumber(refined.value),
        causal == nullptr ? kNone : ReadableNumber(causal->value));
  }
  for (const Metric& metric : scores.clustering) row(metric, kNone, ReadableNumber(metric.value));
  for (const Metric& metric : scores.boxes) row(metric, ReadableNumber(metric.value), kNone);
  for (const Metric& metric : scores.calibration) row(metric, kNone, ReadableNumber(metric.value));
  table.Print(out);
  out << "refined: final estimates; causal: estimates at the time of each frame\n";
  if (!all) out << "all metrics: --all, and in result.json\n";
  if (scores.refined_bodies.empty()) return;
  out << "\nbodies, refined poses:\n";
  PrintBodies(scores.refined_bodies, scores.refined, out);
}

void PrintBodies(const std::vector<BodyScore>& bodies, const std::vector<Metric>& metrics,
                 std::ostream& out) {
  double least_travel_m = 0.0;
  for (const Metric& metric : metrics) {
    least_travel_m = std::max(least_travel_m, metric.contract.travel_m.value_or(0.0));
  }
  const std::string moves = StrCat("moves (> ", ReadableNumber(least_travel_m), " m)");
  TextTable table({"body", "class", moves, "travel m", "cluster", "visible", "estimated", "ATE m",
                   "in 10 cm", "motion rad", "motion m", "velocity error m/s", "switches"});
  for (const BodyScore& body : bodies) {
    table.Add({body.name, body.category, body.mover ? "yes" : "no", ReadableNumber(body.travel_m),
               body.cluster < 0 ? kNone : std::to_string(body.cluster),
               std::to_string(body.visible_frames), std::to_string(body.estimated_frames),
               Value(body.ate_m), SuccessAt10cm(body), Value(body.motion_rad), Value(body.motion_m),
               Value(body.velocity_m_s), std::to_string(body.id_switches)});
  }
  table.Print(out);
}

void PrintMetrics(const std::vector<Metric>& metrics, std::ostream& out) {
  TextTable table({"metric", "value", "unit", "n"});
  for (const Metric& metric : metrics) {
    table.Add(
        {metric.name, ReadableNumber(metric.value), NameOf(metric.unit), std::to_string(metric.n)});
  }
  table.Print(out);
}

}  // namespace cvo
