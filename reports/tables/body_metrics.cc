// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/body_metrics.h"

#include <algorithm>

namespace cvo::reports {
namespace {

const FrameErrors& ErrorsOf(const BodyMetric& metric, const BodyResult& body) {
  return metric.predicted() ? body.predicted : body.errors;
}

std::optional<double> ValueOf(const BodyResult& body, const std::string& field) {
  const auto found = body.values.find(field);
  if (found == body.values.end()) return std::nullopt;
  return found->second;
}

std::optional<Part> FractionOf(const BodyMetric& metric, const BodyResult& body) {
  const FrameErrors& errors = ErrorsOf(metric, body);
  const std::optional<double> frames = metric.predicted()
                                           ? static_cast<double>(errors.frames.size())
                                           : ValueOf(body, "visible_frames");
  if (!frames || *frames <= 0.0) return std::nullopt;
  const auto within =
      std::count_if(errors.position_m.begin(), errors.position_m.end(),
                    [&](double error_m) { return error_m <= metric.entry().limit_m; });
  return Part{static_cast<double>(within), *frames};
}

}  // namespace

std::optional<BodyMetric> FindBodyMetric(const std::string& metric) {
  const std::optional<MetricForm> form = FindForm(metric);
  if (!form || EntryOf(form->id).family != MetricFamily::kBodies) return std::nullopt;
  return BodyMetric{*form};
}

const std::vector<BodyResult>& BodiesOf(const BodyMetric& metric, const RunSummary& run) {
  return metric.form.causal ? run.causal : run.refined;
}

std::optional<Part> PartOf(const BodyMetric& metric, const BodyResult& body) {
  if (body.mover != metric.movers()) return std::nullopt;
  const FromBody from = metric.entry().from_body;
  if (from == FromBody::kSuccess) return FractionOf(metric, body);
  const char* field = from == FromBody::kCoverage    ? "estimated_frames"
                      : from == FromBody::kUnmatched ? "cluster"
                      : metric.predicted()           ? "predicted_ate_m"
                                                     : metric.entry().body_field;
  const std::optional<double> value = ValueOf(body, field);
  if (!value) return std::nullopt;
  if (from == FromBody::kUnmatched) return Part{*value == -1.0 ? 1.0 : 0.0};
  if (from != FromBody::kCoverage) return Part{*value};
  const std::optional<double> visible = ValueOf(body, "visible_frames");
  if (!visible || *visible <= 0.0) return std::nullopt;
  return Part{*value, *visible};
}

std::optional<std::pair<Part, Part>> PairOf(const BodyMetric& metric, const BodyResult& body,
                                            const BodyResult& reference) {
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
