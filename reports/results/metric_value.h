// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "reports/results/contract.h"

namespace cvo::reports {

// A number of a run, as result files hold it.
struct MetricValue {
  std::string name;    // of a form in the catalogue
  double value = 0.0;  // finite
  MetricUnit unit = MetricUnit::kOne;
  std::int64_t n = 0;  // how many errors were aggregated
  Contract contract;
  std::string left_out;  // what does not enter, with counts; no part of the contract

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("name", self.name);
    archive.Field("value", self.value);
    archive.Field("unit", self.unit);
    archive.Field("n", self.n);
    archive.Field("contract", self.contract);
    archive.Optional("left_out", self.left_out);
  }
};

}  // namespace cvo::reports
