// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/body_metrics.h"

#include <algorithm>

namespace cvo::reports {
namespace {

const FrameErrors& ErrorsOf(const BodyMetric& metric, const BodyRow& body) {
  return metric.predicted() ? body.predicted : body.errors;
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

}  // namespace

std::optional<BodyMetric> FindBodyMetric(const std::string& metric) {
  const std::optional<MetricForm> form = FindForm(metric);
  if (!form || EntryOf(form->id).family != MetricFamily::kBodies) return std::nullopt;
  return BodyMetric{*form};
}

const std::vector<BodyRow>& BodiesOf(const BodyMetric& metric, const RunSummary& run) {
  static const std::vector<BodyRow> kNone;
  if (!run.bodies) return kNone;
  return metric.form.causal ? run.bodies->causal : run.bodies->refined;
}

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

std::optional<std::pair<Part, Part>> PairOf(const BodyMetric& metric, const BodyRow& body,
                                            const BodyRow& reference) {
  if (body.mover != metric.movers() || reference.mover != metric.movers()) return std::nullopt;
  if (metric.by_frames()) {
    const auto errors = CommonRootMeanSquares(ErrorsOf(metric, body), ErrorsOf(metric, reference));
    if (!errors) return std::nullopt;
    return std::pair{Part{errors->first}, Part{errors->second}};
  }
  const auto ours = PartOf(metric, body);
  const auto theirs = PartOf(metric, reference);
  if (!ours || !theirs) return std::nullopt;
  return std::pair{*ours, *theirs};
}

const char* PairingText(const BodyMetric& metric) {
  if (metric.by_frames()) return "object-frames that both estimate";
  if (metric.entry().kind == MetricKind::kError)
    return "bodies that both estimate, each on its frames";
  return metric.predicted() ? "bodies of both, each on its predicted frames"
                            : "all visible object-frames";
}

}  // namespace cvo::reports
