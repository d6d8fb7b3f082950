// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Where commands may write: never into a sequence, an input, or the results of another command.
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <exception>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "experiments/cli/command.h"
#include "experiments/runner/run_files.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoInput = "an output folder or file that is not also an input";
constexpr const char* kOwnFolder = "a folder of its own";

[[noreturn]] void Refuse(const fs::path& output, const std::string& found,
                         const std::string& expected = kNoInput) {
  throw UsageError(StrCat(output.string(), ": found ", found, ", expected ", expected));
}

fs::path Resolved(const fs::path& path) {
  const fs::path resolved = fs::weakly_canonical(fs::absolute(path));
  return resolved.has_filename() ? resolved : resolved.parent_path();
}

bool Exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

fs::path FolderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// The folder, links resolved, and all folders above it.
std::vector<fs::path> FromHereUp(const fs::path& folder) {
  std::vector<fs::path> folders;
  for (fs::path at = Resolved(folder); at != at.parent_path(); at = at.parent_path()) {
    folders.push_back(at);
  }
  return folders;
}

void RefuseBelowSequence(const fs::path& output, const fs::path& folder) {
  for (const fs::path& at : FromHereUp(folder)) {
    if (!DetectSequenceType(at).empty() || IsTrackingSet(at)) {
      Refuse(output, "the sequence " + at.string());
    }
  }
}

void RefuseRunsOfSuite(const fs::path& output, const fs::path& folder) {
  constexpr std::array kSuiteFolders = {"jobs", "failed", "logs", "slurm"};
  for (const fs::path& at : FromHereUp(folder)) {
    const bool own =
        std::find(kSuiteFolders.begin(), kSuiteFolders.end(), at.filename()) != kSuiteFolders.end();
    if (own && Exists(at.parent_path() / "plan.json")) {
      Refuse(output, "the runs of a suite in " + at.string());
    }
  }
}

// Refuses a place that is a folder of `read`, or a file of `read`.
void RefuseInput(const fs::path& place, const std::vector<fs::path>& read, bool folders) {
  std::error_code none;  // set if one of them does not exist
  for (const fs::path& path : read) {
    if (fs::is_directory(path) != folders || !fs::equivalent(place, path, none)) continue;
    Refuse(place, folders ? "an input folder" : "an input file");
  }
}

// Name of the suite planned in a folder. Empty if there is none, or if its plan cannot be read.
std::string SuiteIn(const fs::path& folder) try {
  const fs::path plan = folder / "plan.json";
  return Exists(plan) ? ReadJson(plan).at("suite").at("name") : "";
} catch (const std::exception&) {  // also those of the JSON library
  return "";
}

}  // namespace

OutputFolder OpenOutput(const fs::path& folder, const std::vector<std::string>& names,
                        const std::vector<fs::path>& read) {
  RefuseBelowSequence(folder, folder);
  RefuseRunsOfSuite(folder, folder);
  RefuseInput(folder, read, true);
  for (const std::string& name : names) {
    RefuseInput(folder / name, read, false);
    if (name.ends_with('/')) RefuseBelowSequence(folder / name, folder / name);
  }
  return {folder, names};
}

OutputFolder CheckOutputFile(const fs::path& file, const std::vector<fs::path>& read) {
  RefuseBelowSequence(file, FolderOf(file));
  RefuseRunsOfSuite(file, FolderOf(file));
  RefuseInput(file, read, false);
  const std::vector<std::string> of_runs = RunFileNames();
  if (std::find(of_runs.begin(), of_runs.end(), file.filename()) != of_runs.end() &&
      Exists(FolderOf(file) / "result.json")) {
    Refuse(file, "a file of a run", "another name");
  }
  return {FolderOf(file), {file.filename().string()}};
}

void WriteOutputFile(const fs::path& file, const std::string& content,
                     const std::vector<fs::path>& read) {
  const OutputFolder output = CheckOutputFile(file, read);
  WriteFilesAtomically(output.path(), {{file.filename().string(), content}});
}

void CheckOwnFile(const fs::path& file, const std::string& begins) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored) || fs::is_empty(file, ignored)) return;
  if (ReadFileBytes(file, begins.size()) == begins) return;
  Refuse(file, "a file with another content", "a new file, or one that this command wrote");
}

void CheckNewSequence(const fs::path& folder, const std::vector<fs::path>& read) {
  RefuseBelowSequence(folder, FolderOf(Resolved(folder)));
  RefuseRunsOfSuite(folder, folder);
  RefuseInput(folder, read, true);
}

std::vector<fs::path> FoldersOf(const Sequence& sequence) {
  std::set<fs::path> folders = {sequence.folder};
  for (const fs::path& file : sequence.other_files) folders.insert(FolderOf(file));
  return {folders.begin(), folders.end()};
}

void CheckNotBelow(const std::vector<fs::path>& inputs, const fs::path& output) {
  for (const fs::path& at : FromHereUp(output)) RefuseInput(at, inputs, true);
}

void CheckPlaceOfRun(const fs::path& output) {
  if (Exists(output / "plan.json")) Refuse(output, "the folder of a suite", kOwnFolder);
}

void CheckPlaceOfSuite(const fs::path& output, const std::string& suite) {
  if (Exists(output / "result.json")) Refuse(output, "the folder of a run", kOwnFolder);
  const std::string found = SuiteIn(output);
  if (found.empty() || found == suite) return;
  Refuse(output, "the suite " + found, "a folder of its own for " + suite);
}

ScratchFolder::ScratchFolder() {
  const fs::path parent = fs::temp_directory_path();
  RemoveLeftovers(parent);
  path_ = TemporaryName(parent / "clustervo");
  if (::mkdir(path_.c_str(), 0700) == 0) return;
  ThrowError(path_.string(), "a folder that cannot be created",
             "a writable folder for temporary files (TMPDIR)");
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace cvo
