// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/suite_overrides.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/options_json.h"
#include "core/interface/options.h"
#include "experiments/suite/parse_suite.h"
#include "experiments/suite/suite_grid.h"

namespace cvo {
namespace {

// Parses JSON; any other text is taken as a string, so that a word needs no quotes.
Json ParseValue(const std::string& text) {
  try {
    return ParseJson(text, "value");
  } catch (const Error&) {
    return text;
  }
}

void SetSuiteOption(const std::string& assignment, Json& options) {
  Options values;
  const std::vector<OptionLeaf> leaves = OptionLeaves(values);
  SetOption(assignment, leaves);
  const std::string path = assignment.substr(0, assignment.find('='));
  Json* at = &options;
  for (std::size_t start = 0; start < path.size();) {
    const std::size_t end = std::min(path.find('.', start), path.size());
    at = &(*at)[path.substr(start, end - start)];
    start = end + 1;
  }
  *at = ValueToJson(*FindBy(leaves, &OptionLeaf::path, path));
}

void Set(const std::string& assignment, Suite& suite) {
  const std::size_t equals = assignment.find('=');
  if (equals == 0 || equals == std::string::npos) {
    ThrowError("--set " + assignment, "no PATH=VALUE", "PATH=VALUE, such as window.spatial=5");
  }
  const std::string path = assignment.substr(0, equals);
  const Json value = ParseValue(assignment.substr(equals + 1));
  GridAxis* axis = FindBy(suite.grid, &GridAxis::path, path);
  const bool of_sequence = !IsOptionPath(path);
  if ((of_sequence || axis != nullptr) && suite.grid_one_at_a_time) {
    ThrowError("--set " + assignment, "a suite that varies one axis of its grid at a time",
               "an option that is not an axis");
  }
  if (axis != nullptr) {
    axis->values = {value};
  } else if (of_sequence) {
    suite.grid.push_back({path, {value}});
  } else {
    SetSuiteOption(assignment, suite.options);
  }
}

}  // namespace

Suite Override(Suite suite, const SuiteOverrides& overrides) {
  if (overrides.seeds > 0) {
    suite.seeds.resize(static_cast<std::size_t>(overrides.seeds));
    std::iota(suite.seeds.begin(), suite.seeds.end(), 1);
  }
  if (!overrides.frames.empty()) {
    for (SuiteSequence& sequence : suite.sequences) sequence.frames = overrides.frames;
  }
  for (const std::string& assignment : overrides.set) Set(assignment, suite);
  CheckSuite(suite, "suite " + suite.name);
  return suite;
}

}  // namespace cvo
