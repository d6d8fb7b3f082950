// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.h"
#include "experiments/suite/parse_suite.h"
#include "experiments/suite/plan/plan.h"

namespace cvo {
namespace {

// Returns the index of the sequence in the suite.
std::size_t EntryOf(const SuiteSequence& sequence, const Suite& suite) {
  for (std::size_t i = 0; i < suite.sequences.size(); ++i) {
    const SuiteSequence& other = suite.sequences[i];
    if (other.name == sequence.name && other.detections == sequence.detections) return i;
  }
  ThrowError("plan", "a job on " + sequence.name, "a sequence of the suite");
}

reports::PlanJob JobInFile(const PlannedJob& job, const Suite& suite) {
  const Cell& cell = job.cell;
  reports::PlanJob row;
  row.sequence = cell.sequence.name;
  row.family = FamilyOf(cell.sequence);
  row.split = SplitOf(cell.sequence);
  row.detections = cell.sequence.detections;
  row.variant = cell.variant;
  row.system = cell.system;
  row.seed = cell.seed;
  row.oracle = cell.oracle;
  row.parameters = ParametersOf(cell);
  row.landmarks = cell.landmarks;
  row.folder = job.folder;
  row.missing = job.missing;
  row.frames = job.frames;
  row.content = job.content;
  row.input = job.input;
  row.job = job.job;
  row.boxes = job.boxes;
  row.entry = EntryOf(cell.sequence, suite);
  return row;
}

PlannedJob JobOf(const reports::PlanJob& row, const Suite& suite, const std::string& where) {
  if (row.entry >= suite.sequences.size()) {
    ThrowError(where + ", jobs", "a job on a sequence that the suite does not have",
               StrCat("one of its ", suite.sequences.size()));
  }
  PlannedJob job;
  job.cell.sequence = suite.sequences[row.entry];
  job.cell.variant = row.variant;
  job.cell.system = row.system;
  job.cell.seed = row.seed;
  job.cell.oracle = row.oracle;
  for (const auto& [path, value] : row.parameters.items()) {
    job.cell.parameters.emplace_back(path, value);
  }
  job.cell.landmarks = row.landmarks;
  job.folder = row.folder;
  job.missing = row.missing;
  job.frames = row.frames;
  job.content = row.content;
  job.input = row.input;
  job.job = row.job;
  job.boxes = row.boxes;
  return job;
}

}  // namespace

std::string PlanText(const Plan& plan) {
  reports::PlanFile file;
  file.suite = {plan.suite.name, plan.suite.about, SplitOf(plan.suite)};
  file.build = plan.build;
  file.data = plan.data;
  file.table = plan.suite.table;
  file.definition = SuiteToJson(plan.suite);
  for (const PlannedJob& job : plan.jobs) file.jobs.push_back(JobInFile(job, plan.suite));
  return FileText(file);
}

Plan ParsePlan(const Json& json, const std::string& where) {
  const auto read = ReadRecord<reports::PlanFile>(json, where);
  Plan plan;
  plan.suite = ReadCheckedSuite(read.definition, where + ", definition");
  plan.build = read.build;
  plan.data = read.data;
  for (const reports::PlanJob& job : read.jobs) {
    plan.jobs.push_back(JobOf(job, plan.suite, where));
  }
  return plan;
}

}  // namespace cvo
