// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/job_status.h"

#include <algorithm>
#include <fstream>
#include <map>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "experiments/log/run_record.h"
#include "experiments/suite/shipped_trajectories.h"
#include "reports/results/plan_file.h"
#include "reports/results/run_summary.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kErrorPrefix = "clustervo: error: ";

// Throws Error if tables and the gate would reject the result, or if it is that of another job.
void CheckResult(const fs::path& file, const PlannedJob& job) {
  const reports::RunSummary run = reports::ReadRun(file, {});
  const Cell& cell = job.cell;
  reports::CheckRunOf(
      {.job = job.job,
       .variant = cell.system.empty() ? cell.variant : reports::SystemVariant(cell.system),
       .seed = cell.seed,
       .content = job.content,
       .oracle = cell.oracle,
       .parameters = ParametersOf(cell)},
      run);
  if (run.status == ToString(RunStatus::kFailed)) {
    throw Error(StrCat(file.string(), ": the estimator gave up: ", run.message));
  }
}

std::string FailureMessage(const fs::path& file) {
  try {
    const std::string message = ReadRecord<reports::JobFailure>(file).message;
    return message.empty() ? "failed, without a message in its record" : message;
  } catch (const Error& error) {
    return StrCat("failed, and its record cannot be read: ", error.what());
  }
}

// Returns a limited part of the end of a file, starting at the beginning of a line.
std::string Tail(const fs::path& file) {
  constexpr std::streamoff kBytes = 4000;
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return "";
  const std::streamoff size = in.tellg();
  in.seekg(std::max<std::streamoff>(0, size - kBytes));
  std::string text(static_cast<std::size_t>(std::min(size, kBytes)), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  const std::size_t line = text.find('\n');
  return size > kBytes && line != std::string::npos ? text.substr(line + 1) : text;
}

// A scene can always be rendered, and a folder that was found was meant to be used, so a problem
// with either is a failure and not missing data. A stale trajectory and a missing file of boxes,
// labels or a network cannot be obtained, and count as missing data.
JobStatus::State StateWithoutInput(const PlannedJob& job) {
  if (IsPending(job.missing)) return JobStatus::State::kMissing;
  const bool absent = (job.cell.sequence.scene.empty() && job.folder.empty()) ||
                      job.missing.starts_with(kStale) || job.missing.starts_with(kNoFile);
  return absent ? JobStatus::State::kNoSequence : JobStatus::State::kFailed;
}

}  // namespace

const char* ToString(JobStatus::State state) {
  switch (state) {
    case JobStatus::State::kDone:
      return "done";
    case JobStatus::State::kFailed:
      return "failed";
    case JobStatus::State::kMissing:
      return "missing";
    case JobStatus::State::kNoSequence:
      return "no sequence";
  }
  throw Error("JobStatus: not one of the enumerators");
}

bool HasFiles(const SuiteFolder& folder, const PlannedJob& job) {
  const fs::path files = folder.job(job.job);
  return fs::exists(files / "result.json") &&
         (!job.cell.landmarks || fs::exists(files / "landmarks.csv"));
}

std::string ProblemOfResult(const SuiteFolder& folder, const PlannedJob& job) {
  if (!HasFiles(folder, job)) return "ended without a result";
  try {
    CheckResult(folder.job(job.job) / "result.json", job);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

JobStatus StatusOf(const SuiteFolder& folder, const PlannedJob& job) {
  if (job.job.empty()) return {StateWithoutInput(job), job.missing};
  // A damaged result does not count: its job runs again.
  if (ProblemOfResult(folder, job).empty()) return {JobStatus::State::kDone, ""};
  const fs::path failure = folder.failure(job.job);
  if (!fs::exists(failure)) return {JobStatus::State::kMissing, ""};
  return {JobStatus::State::kFailed, FailureMessage(failure)};
}

std::vector<JobStatus> StatusOfAll(const SuiteFolder& folder, const Plan& plan) {
  std::map<std::string, JobStatus> known;
  std::vector<JobStatus> all;
  for (const PlannedJob& job : plan.jobs) {
    if (job.job.empty()) {
      all.push_back(StatusOf(folder, job));
      continue;
    }
    const auto [found, added] = known.try_emplace(job.job);
    if (added) found->second = StatusOf(folder, job);
    all.push_back(found->second);
  }
  return all;
}

std::string Describe(const Cell& cell) {
  std::string text =
      StrCat(cell.sequence.name, " ", cell.system.empty() ? cell.variant : cell.system);
  if (cell.system.empty()) text += StrCat(", seed ", cell.seed);
  for (const auto& [path, value] : cell.parameters) {
    text += StrCat(", ", path, "=", value.dump());
  }
  for (std::size_t i = 0; i < cell.oracle.size(); ++i) {
    text += StrCat(i == 0 ? ", oracle " : "+", cell.oracle[i]);
  }
  return text;
}

void WriteFailure(const SuiteFolder& folder, const std::string& id, const std::string& message) {
  const fs::path file = folder.failure(id);
  const reports::JobFailure failure{id, message, Tail(folder.log(id))};
  WriteFilesAtomically(file.parent_path(), {{file.filename().string(), FileText(failure)}});
}

std::string ErrorInLog(const fs::path& log) {
  const std::string text = Tail(log);
  const std::size_t found = text.rfind(kErrorPrefix);
  if (found == std::string::npos) return "";
  const std::size_t begin = found + kErrorPrefix.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace cvo
