// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/figures/suite/swept_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"

namespace cvo::reports {
namespace {

constexpr char kDefault[] = "default";

std::optional<double> NumberOf(const std::string& text) {
  double number = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool good = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
  return good && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

// The standard deviation of the steps between values, divided by their mean.
double Unevenness(const std::vector<double>& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) steps.push_back(values[i] - values[i - 1]);
  double mean = 0.0;
  for (const double step : steps) mean += step / static_cast<double>(steps.size());
  double squares = 0.0;
  for (const double step : steps) squares += (step - mean) * (step - mean);
  return std::sqrt(squares / static_cast<double>(steps.size())) / mean;
}

std::optional<double> DefaultOf(const std::string& path, const Table& table) {
  for (const ChangedOption& option : table.provenance.options) {
    if (option.path == path) return NumberOf(option.default_value);
  }
  return std::nullopt;
}

// Whether all other options are at their defaults, as in a suite that varies one option at a time.
bool OthersAtDefault(const Table& table, const Row& row, std::size_t key) {
  for (std::size_t i = 0; i < row.keys.size(); ++i) {
    if (i != key && IsOption(table.keys[i]) && row.keys[i] != kDefault) return false;
  }
  return true;
}

std::string LabelOf(const Table& table, const Row& row, std::size_t key, bool one_at_a_time) {
  std::string label;
  for (std::size_t i = 0; i < row.keys.size(); ++i) {
    if (i == key || (one_at_a_time && IsOption(table.keys[i]))) continue;
    label += StrCat(label.empty() ? "" : ", ",
                    IsOption(table.keys[i]) ? table.keys[i] + " " : std::string(), row.keys[i]);
  }
  return label;
}

void AddPoint(const SuitePlan& plan, const Table& table, std::size_t row, double value,
              const std::string& label, SweptOption& option) {
  const std::string variant = VariantOf(plan, table, table.rows[row]);
  const std::string name = label.empty() ? variant : label;
  FindOrAdd(option.lines, &SweptLine::label, {name, variant, {}}).points.emplace_back(value, row);
}

SweptOption ReadOption(const SuitePlan& plan, const Table& table, std::size_t key) {
  SweptOption option;
  option.path = table.keys[key];
  option.default_value = DefaultOf(option.path, table);
  const bool one_at_a_time = std::any_of(table.rows.begin(), table.rows.end(), [&](const Row& row) {
    return row.keys[key] != kDefault && OthersAtDefault(table, row, key);
  });
  std::set<double> values;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    const std::optional<double> value = NumberOf(row.keys[key]);
    if (!value || (one_at_a_time && !OthersAtDefault(table, row, key))) continue;
    values.insert(*value);
    AddPoint(plan, table, i, *value, LabelOf(table, row, key, one_at_a_time), option);
  }
  option.values.assign(values.begin(), values.end());
  option.log_spaced = AreLogSpaced(option.values);
  for (SweptLine& line : option.lines) std::sort(line.points.begin(), line.points.end());
  return option;
}

}  // namespace

bool IsOption(const std::string& key) {
  constexpr std::array kNonOptionKeys = {"sequence", "family", "detections", "variant", "oracle"};
  return std::find(kNonOptionKeys.begin(), kNonOptionKeys.end(), key) == kNonOptionKeys.end();
}

bool AreLogSpaced(const std::vector<double>& ascending) {
  constexpr double kMinRatio = 8.0;
  if (ascending.size() < 3 || ascending.front() <= 0.0) return false;
  if (ascending.back() / ascending.front() < kMinRatio) return false;
  std::vector<double> logarithms;
  for (const double value : ascending) logarithms.push_back(std::log(value));
  return Unevenness(logarithms) < Unevenness(ascending);
}

std::string OneVariant(const SuitePlan& plan) {
  std::set<std::string> variants;
  for (const PlannedRun& run : plan.runs) variants.insert(KeyOf(run, "variant"));
  return variants.size() == 1 ? *variants.begin() : "all variants";
}

std::string VariantOf(const SuitePlan& plan, const Table& table, const Row& row) {
  for (std::size_t i = 0; i < table.keys.size(); ++i) {
    if (table.keys[i] == "variant") return row.keys[i];
  }
  return OneVariant(plan);
}

std::vector<SweptOption> FindSweptOptions(const SuitePlan& plan, const Table& table,
                                          std::vector<std::string>& not_drawn) {
  std::set<std::string> pooled;
  for (const PlannedRun& run : plan.runs) {
    for (const auto& [key, value] : run.keys) {
      if (IsOption(key) && std::find(table.keys.begin(), table.keys.end(), key) == table.keys.end())
        pooled.insert(key);
    }
  }
  for (const std::string& path : pooled) {
    not_drawn.push_back(
        StrCat("Sensitivity to ", path,
               ": the suite's table has no rows by this option; its rows are means over it."));
  }
  std::vector<SweptOption> options;
  for (std::size_t key = 0; key < table.keys.size(); ++key) {
    if (!IsOption(table.keys[key])) continue;
    SweptOption option = ReadOption(plan, table, key);
    if (option.values.size() >= 2) {
      options.push_back(std::move(option));
    } else {
      not_drawn.push_back(StrCat("Sensitivity to ", option.path, ": ", option.values.size(),
                                 " numeric values; a curve needs at least 2."));
    }
  }
  return options;
}

}  // namespace cvo::reports
