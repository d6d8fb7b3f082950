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

// Terms of the page for estimators, statistics and runs.
std::vector<Term> Terms();

}  // namespace cvo::reports
