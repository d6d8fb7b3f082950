// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/metrics_json.h"

namespace cvo {

Json MetricsToJson(const std::vector<Metric>& metrics, const std::string& poses) {
  Json list = Json::array();
  for (const Metric& metric : metrics) {
    const MetricContract& contract = metric.contract;
    list.push_back({{"name", metric.name},
                    {"value", metric.value},
                    {"unit", metric.unit},
                    {"n", metric.n},
                    {"contract",
                     {{"frame", contract.frame},
                      {"poses", poses},
                      {"truth", contract.truth},
                      {"alignment", contract.alignment},
                      {"pairing", contract.pairing},
                      {"delta", contract.delta},
                      {"aggregation", contract.aggregation},
                      {"left_out", contract.left_out}}}});
  }
  return list;
}

}  // namespace cvo
