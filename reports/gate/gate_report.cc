// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/gate_report.h"

#include <algorithm>

#include "core/base/error.h"

namespace cvo::reports {

std::size_t GateReport::Count(Verdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(comparisons.begin(), comparisons.end(),
                    [&](const Comparison& comparison) { return comparison.verdict == verdict; }));
}

bool GateReport::Slower() const {
  return !time_problems.empty() ||
         std::any_of(times.begin(), times.end(),
                     [](const TimeComparison& time) { return time.verdict == Verdict::kWorse; });
}

const char* ToString(Verdict verdict) {
  switch (verdict) {
    case Verdict::kSame:
      return "same";
    case Verdict::kWithin:
      return "within";
    case Verdict::kWorse:
      return "worse";
    case Verdict::kBetter:
      return "better";
  }
  throw Error("Verdict: not one of the enumerators");
}

}  // namespace cvo::reports
