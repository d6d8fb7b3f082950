// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/body_metrics.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>

namespace cvo::reports {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

struct ErrorField {
  const char* quantity;
  const char* field;
  double scale;
};
constexpr std::array<ErrorField, 8> kErrors = {{{"ate", "ate_m", 1.0},
                                                {"rrpe_all_pairs", "all_pairs_rad", 1.0},
                                                {"trpe_all_pairs", "all_pairs_m", 1.0},
                                                {"rrpe_1_frame", "one_frame_rad", 1.0},
                                                {"trpe_1_frame", "one_frame_m", 1.0},
                                                {"motion_r", "motion_rad", kDegrees},
                                                {"motion_t", "motion_m", 1.0},
                                                {"velocity", "velocity_m_s", 1.0}}};

bool Strip(const std::string& prefix, std::string& text) {
  if (!text.starts_with(prefix)) return false;
  text.erase(0, prefix.size());
  return true;
}

// "success_10cm" gives 0.1 m.
std::optional<double> SuccessLimit(std::string quantity) {
  if (!Strip("success_", quantity) || !quantity.ends_with("cm")) return std::nullopt;
  int limit_cm = 0;
  const char* end = quantity.data() + quantity.size() - 2;
  const auto parsed = std::from_chars(quantity.data(), end, limit_cm);
  if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return 0.01 * limit_cm;
}

bool FindQuantity(const std::string& quantity, BodyMetric& metric) {
  using Kind = BodyMetric::Kind;
  for (const ErrorField& error : kErrors) {
    if (quantity != error.quantity) continue;
    if (metric.predicted && quantity != "ate") return false;
    metric.field = metric.predicted ? "predicted_ate_m" : error.field;
    metric.scale = error.scale;
    metric.by_frames = quantity == "ate";
    return true;
  }
  if (const auto limit_m = SuccessLimit(quantity)) {
    metric.kind = Kind::kSuccess;
    metric.limit_m = *limit_m;
    return true;
  }
  if (metric.predicted) return false;
  if (quantity == "coverage") metric.kind = Kind::kCoverage;
  if (quantity == "unmatched") metric.kind = Kind::kUnmatched;
  if (quantity == "id_switches" || quantity == "fragments") metric.kind = Kind::kCount;
  metric.field = quantity;
  return metric.kind != Kind::kError;
}

const FrameErrors& ErrorsOf(const BodyMetric& metric, const BodyResult& body) {
  return metric.predicted ? body.predicted : body.errors;
}

std::optional<double> ValueOf(const BodyResult& body, const std::string& field) {
  const auto found = body.values.find(field);
  if (found == body.values.end()) return std::nullopt;
  return found->second;
}

std::optional<Part> FractionOf(const BodyMetric& metric, const BodyResult& body) {
  const FrameErrors& errors = ErrorsOf(metric, body);
  const std::optional<double> frames = metric.predicted ? static_cast<double>(errors.frames.size())
                                                        : ValueOf(body, "visible_frames");
  if (!frames || *frames <= 0.0) return std::nullopt;
  const auto within = std::count_if(errors.position_m.begin(), errors.position_m.end(),
                                    [&](double error_m) { return error_m <= metric.limit_m; });
  return Part{static_cast<double>(within), *frames};
}

}  // namespace

std::optional<BodyMetric> FindBodyMetric(const std::string& metric) {
  std::string rest = metric;
  BodyMetric found;
  if (!Strip("object_", rest)) return std::nullopt;
  found.causal = Strip("causal_", rest);
  found.predicted = Strip("predicted_", rest);
  if (!found.predicted) found.movers = !Strip("standing_", rest);
  if (!FindQuantity(rest, found)) return std::nullopt;
  return found;
}

const std::vector<BodyResult>& BodiesOf(const BodyMetric& metric, const RunSummary& run) {
  return metric.causal ? run.causal : run.refined;
}

std::optional<Part> PartOf(const BodyMetric& metric, const BodyResult& body) {
  if (body.mover != metric.movers) return std::nullopt;
  using Kind = BodyMetric::Kind;
  if (metric.kind == Kind::kSuccess) return FractionOf(metric, body);
  const char* field = metric.kind == Kind::kCoverage    ? "estimated_frames"
                      : metric.kind == Kind::kUnmatched ? "cluster"
                                                        : metric.field.c_str();
  const std::optional<double> value = ValueOf(body, field);
  if (!value) return std::nullopt;
  if (metric.kind == Kind::kUnmatched) return Part{*value == -1.0 ? 1.0 : 0.0};
  if (metric.kind != Kind::kCoverage) return Part{metric.scale * *value};
  const std::optional<double> visible = ValueOf(body, "visible_frames");
  if (!visible || *visible <= 0.0) return std::nullopt;
  return Part{*value, *visible};
}

std::optional<std::pair<Part, Part>> PairOf(const BodyMetric& metric, const BodyResult& body,
                                            const BodyResult& reference) {
  if (body.mover != metric.movers || reference.mover != metric.movers) return std::nullopt;
  if (metric.by_frames) {
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
  if (metric.by_frames) return "object-frames that both estimate";
  if (metric.kind == BodyMetric::Kind::kError)
    return "bodies that both estimate, each on its frames";
  return metric.predicted ? "bodies of both, each on its predicted frames"
                          : "all visible object-frames";
}

}  // namespace cvo::reports
