// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cvo::reports {

struct Term {
  std::string name;
  std::string meaning;
};

// Words that the page uses of estimators, statistics and runs.
std::vector<Term> Terms();

// What a metric measures, in plain words; its name says enough where there is none.
std::string MeasureMeaning(const std::string& metric);

}  // namespace cvo::reports
