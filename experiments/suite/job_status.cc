// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/job_status.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <map>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/record/run_summary.h"
#include "core/record/suite_runs.h"
#include "experiments/runner/run_result.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

std::string Holder(int fd) {
  std::array<char, 400> text{};
  const ssize_t size = ::pread(fd, text.data(), text.size(), 0);
  const std::string holder(text.data(), static_cast<std::size_t>(size > 0 ? size : 0));
  return holder.empty() ? "another process" : holder.substr(0, holder.find('\n'));
}

// Whether the path still leads to this open file, which its last holder may have removed.
bool IsAt(const fs::path& file, int fd) {
  struct stat opened {};
  struct stat found {};
  return ::fstat(fd, &opened) == 0 && ::stat(file.c_str(), &found) == 0 &&
         opened.st_dev == found.st_dev && opened.st_ino == found.st_ino;
}

}  // namespace

FolderLock::FolderLock(fs::path file) : file_(std::move(file)) {
  do {
    ::close(fd_);
    fd_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (fd_ < 0) ThrowErrno(file_, "write", errno);
    if (::flock(fd_, LOCK_EX | LOCK_NB) == 0) continue;
    const int error = errno;
    const std::string holder = Holder(fd_);
    ::close(fd_);
    if (error != EWOULDBLOCK) ThrowErrno(file_, "lock", error);
    ThrowError(file_.parent_path().string(), StrCat("in use by ", holder),
               "a folder not in use by another run");
  } while (!IsAt(file_, fd_));
  // Used only in the message above, so a full disk is no reason to fail.
  const std::string me = StrCat("process ", ::getpid(), " on ", HostName(), '\n');
  if (::ftruncate(fd_, 0) == 0) {
    [[maybe_unused]] const ssize_t written = ::pwrite(fd_, me.data(), me.size(), 0);
  }
}

FolderLock::~FolderLock() {
  ::unlink(file_.c_str());
  ::close(fd_);
}

namespace {

constexpr std::string_view kErrorPrefix = "clustervo: error: ";

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
// with either is a failure and not missing data. A stale trajectory and a missing file of boxes
// or labels cannot be obtained, and count as missing data.
JobStatus::State StateWithoutInput(const Plan& plan, const PlanJob& job) {
  if (job.missing == kNotRendered) return JobStatus::State::kMissing;
  const bool absent = (plan.suite.sequences[job.entry].scene.empty() && job.folder.empty()) ||
                      job.missing.starts_with(kStale) || job.missing.starts_with(kNoFile);
  return absent ? JobStatus::State::kNoSequence : JobStatus::State::kFailed;
}

}  // namespace

// A result that tables and the gate would reject, or that is of another job, does not count.
std::string ProblemOfResult(const SuiteFolder& folder, const PlanJob& job) {
  const fs::path files = folder.job(job.job);
  if (!fs::exists(files / "result.json") ||
      (job.landmarks && !fs::exists(files / "landmarks.csv"))) {
    return "ended without a result";
  }
  try {
    const reports::RunSummary run = reports::ReadRun(files / "result.json", {});
    reports::CheckRunOf(job, run);
    const bool failed = run.status == ToString(RunStatus::kFailed);
    return failed ? "the estimator gave up: " + run.message : "";
  } catch (const Error& error) {
    return error.what();
  }
}

JobStatus StatusOf(const SuiteFolder& folder, const PlanJob& job) {
  // A damaged result does not count: its job runs again.
  if (ProblemOfResult(folder, job).empty()) return {JobStatus::State::kDone, ""};
  const fs::path failure = folder.failure(job.job);
  if (!fs::exists(failure)) return {JobStatus::State::kMissing, ""};
  try {
    return {JobStatus::State::kFailed, ReadRecord<reports::JobFailure>(failure).message};
  } catch (const Error& error) {
    return {JobStatus::State::kFailed, error.what()};
  }
}

std::vector<JobStatus> StatusOfAll(const SuiteFolder& folder, const Plan& plan) {
  std::map<std::string, JobStatus> known;
  std::vector<JobStatus> all;
  for (const PlanJob& job : plan.jobs) {
    if (job.job.empty()) {
      all.push_back({StateWithoutInput(plan, job), job.missing});
      continue;
    }
    const auto [found, added] = known.try_emplace(job.job);
    if (added) found->second = StatusOf(folder, job);
    all.push_back(found->second);
  }
  return all;
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
