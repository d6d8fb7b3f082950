// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/suite/suite_run.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "reports/results/suite_runs.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> SplitNames(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    names.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

std::vector<std::string> NamesOf(const reports::SuitePlan& plan, const std::string& key) {
  std::vector<std::string> names;
  for (const reports::PlannedRun& run : plan.runs) {
    AddOnce(reports::KeyOf(run, key), names);
  }
  return names;
}

void CheckName(const reports::SuitePlan& plan, const std::string& key, const std::string& name) {
  const std::vector<std::string> known = NamesOf(plan, key);
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  ThrowError(StrCat(plan.file.string(), ", ", key), StrCat("no \"", name, "\""),
             OneOfKnown(name, known));
}

std::string FolderOf(const reports::SuitePlan& plan, const SuiteRunChoice& choice,
                     const std::string& variant) {
  const std::string what = StrCat(choice.sequence, ", ", variant);
  for (const reports::PlannedRun& run : plan.runs) {
    if (reports::KeyOf(run, "sequence") != choice.sequence) continue;
    if (run.system || reports::KeyOf(run, "variant") != variant) continue;
    if (choice.seed && run.seed != *choice.seed) continue;
    if (run.job.empty()) ThrowError(what, run.missing, "a sequence that exists");
    const fs::path folder = fs::path(choice.folder) / "jobs" / run.job;
    if (!fs::exists(folder / "result.json")) {
      ThrowError(folder.string(), "no result", StrCat("that of ", what, ", seed ", run.seed));
    }
    return folder.string();
  }
  ThrowError(plan.file.string(),
             StrCat("no run of ", what, choice.seed ? StrCat(", seed ", *choice.seed) : ""), "one");
}

}  // namespace

std::vector<std::string> SuiteRunFolders(const SuiteRunChoice& choice) {
  const reports::SuitePlan plan = reports::ReadPlan(fs::path(choice.folder) / "plan.json");
  CheckName(plan, "sequence", choice.sequence);
  std::vector<std::string> folders;
  for (const std::string& variant : SplitNames(choice.variants)) {
    CheckName(plan, "variant", variant);
    folders.push_back(FolderOf(plan, choice, variant));
  }
  return folders;
}

}  // namespace cvo
