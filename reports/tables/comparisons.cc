// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/comparisons.h"

#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "reports/results/metric_catalogue.h"
#include "reports/statistics/paired_test.h"

namespace cvo::reports {
namespace {

std::string Line(const Row& row, const Column& column, const Difference& difference) {
  const std::string unit = column.unit == "1" ? "" : " " + column.unit;
  std::string line = StrCat("  ", RowLabel(row), ", ", column.metric, ": ",
                            FormatSigned(difference.difference, 4), unit);
  if (difference.percent) line += StrCat(" (", FormatSigned(*difference.percent, 4), " %)");
  if (difference.interval) {
    line += StrCat(", ", FormatSigned(difference.interval->low, 4), " to ",
                   FormatSigned(difference.interval->high, 4));
  } else {
    line += ", no interval";
  }
  return StrCat(line, ", ", Counted(difference.pairs, "pair"), "\n");
}

}  // namespace

Difference DifferenceOf(const PairedEstimate& estimate, const std::string& reference,
                        const std::string& meaning, const std::string& pairing) {
  const auto interval = [&](const std::optional<Range>& range) {
    return range ? std::optional(Interval{range->low, range->high, meaning}) : std::nullopt;
  };
  Difference difference;
  difference.reference = reference;
  difference.value = estimate.value;
  difference.reference_value = estimate.reference;
  difference.difference = estimate.difference;
  difference.interval = interval(estimate.interval);
  difference.percent = estimate.percent;
  difference.percent_interval = interval(estimate.percent_interval);
  difference.reference_lower = estimate.reference_lower;
  difference.reference_lower_interval = interval(estimate.reference_lower_interval);
  difference.effect = estimate.effect;
  difference.p_value = estimate.p_value;
  difference.scenes_for_10_percent = estimate.scenes_for_10_percent;
  difference.pairs = estimate.pairs;
  difference.pairing = pairing;
  return difference;
}

std::optional<bool> IsBetter(const std::string& metric, double difference) {
  const MetricEntry* rule = FindEntry(metric);
  if (!rule) return std::nullopt;
  return (difference > 0.0) == rule->higher_is_better();
}

std::string UndecidedText(std::size_t pairs, const std::string& what) {
  return StrCat("undecided (", Counted(pairs, what), ", ", kMinPairs, " needed)");
}

std::string VerdictText(const Difference& difference, const std::string& metric,
                        const std::string& what) {
  if (difference.difference == 0.0) return "the same";
  if (!difference.distinguishable) {
    return difference.pairs < kMinPairs ? UndecidedText(difference.pairs, what) : "not significant";
  }
  const auto better = IsBetter(metric, difference.difference);
  return !better ? "differs" : *better ? "better" : "worse";
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

void CorrectForMany(Table& table) {
  std::vector<Difference*> differences;
  for (Row& row : table.rows) {
    for (Cell& cell : row.cells) {
      if (cell.difference) differences.push_back(&*cell.difference);
    }
  }
  CorrectForMany(differences);
}

std::string MovedText(const Table& table) {
  std::string distinguishable;
  std::string noise;
  std::map<std::size_t, std::string> undecided;  // by the number of pairs
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const auto& difference = row.cells[i].difference;
      if (!difference || difference->difference == 0.0) continue;
      (difference->distinguishable     ? distinguishable
       : difference->pairs < kMinPairs ? undecided[difference->pairs]
                                       : noise) += Line(row, table.columns[i], *difference);
    }
  }
  std::string text;
  if (!distinguishable.empty()) text += "changed, distinguishable from noise:\n" + distinguishable;
  if (!noise.empty()) text += "changed, not distinguishable from noise:\n" + noise;
  for (const auto& [pairs, lines] : undecided) {
    text += StrCat("moved, ", UndecidedText(pairs), ":\n", lines);
  }
  return text.empty() ? "nothing changed\n" : text;
}

}  // namespace cvo::reports
