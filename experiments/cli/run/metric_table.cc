// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/metric_table.h"

#include <string>

#include "experiments/cli/run/text_table.h"

namespace cvo {

void PrintMetrics(const std::vector<Metric>& metrics, std::ostream& out) {
  TextTable table({"metric", "value", "unit", "n"});
  for (const Metric& metric : metrics) {
    table.Add(
        {metric.name, ReadableNumber(metric.value), NameOf(metric.unit), std::to_string(metric.n)});
  }
  table.Print(out);
}

}  // namespace cvo
