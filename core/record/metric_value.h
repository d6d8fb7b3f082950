// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "core/record/contract.h"

namespace cvo::reports {

// One value of a run, as stored in result files.
struct MetricValue {
  std::string name;    // name of a form in the catalogue
  double value = 0.0;  // finite
  MetricUnit unit = MetricUnit::kOne;
  std::int64_t n = 0;  // number of errors aggregated
  Contract contract;
  std::string left_out;  // what was left out, with counts; not part of the contract

  CVO_RECORD(CVO_FIELD(name, value, unit, n, contract) CVO_OPTIONAL(left_out));
};

}  // namespace cvo::reports
