// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "reports/results/metric_catalogue.h"

namespace cvo {

// What a number means. Two numbers are comparable only if these agree (left_out apart).
struct MetricContract {
  std::string frame;        // whose motion, in which frame
  std::string truth;        // which ground truth: "devkit", "interpolated", "official", ...
  std::string alignment;    // of the estimate to the truth
  std::string pairing;      // which frames or pairs of frames are compared
  std::string delta;        // distance within a pair; "none" for absolute errors
  std::string aggregation;  // from many errors to one number
  std::string left_out;     // what does not enter, with counts
};

struct Metric {
  std::string name;
  double value = 0.0;  // finite
  std::string unit;
  std::int64_t n = 0;  // how many errors were aggregated
  MetricContract contract;
};

// With the name and unit of the catalogue.
inline Metric MakeMetric(const reports::MetricForm& form, double value, std::int64_t n,
                         const MetricContract& contract) {
  return {reports::MetricName(form), value, reports::EntryOf(form.id).unit, n, contract};
}

}  // namespace cvo
