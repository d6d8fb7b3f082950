// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/output.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <exception>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json.h"
#include "experiments/datasets/sequence.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

fs::path Resolved(const fs::path& path) {
  const fs::path resolved = fs::weakly_canonical(fs::absolute(path));
  return resolved.has_filename() ? resolved : resolved.parent_path();
}

[[noreturn]] void Refuse(const fs::path& output, const std::string& found) {
  throw UsageError(StrCat(output.string(), ": found ", found,
                          ", expected an output folder or file that is not also an input"));
}

bool IsSame(const fs::path& a, const fs::path& b) {
  std::error_code none;  // set if one of them does not exist
  return fs::equivalent(a, b, none);
}

bool IsSequence(const fs::path& folder) {
  return !DetectSequenceType(folder).empty() || IsTrackingSet(folder);
}

// Refuses `output` if `resolved` or a folder above it is a sequence.
void RefuseBelowSequence(const fs::path& output, const fs::path& resolved) {
  for (fs::path folder = resolved; folder != folder.parent_path(); folder = folder.parent_path()) {
    if (IsSequence(folder)) Refuse(output, "the sequence " + folder.string());
  }
}

void RefuseRunsOfSuite(const fs::path& output, const fs::path& resolved) {
  constexpr std::array kSuiteFolders = {"jobs", "failed", "logs", "slurm"};
  std::error_code ignored;
  for (fs::path folder = resolved; folder != folder.parent_path(); folder = folder.parent_path()) {
    const bool own = std::find(kSuiteFolders.begin(), kSuiteFolders.end(), folder.filename()) !=
                     kSuiteFolders.end();
    if (own && fs::exists(folder.parent_path() / "plan.json", ignored)) {
      Refuse(output, "the runs of a suite in " + folder.string());
    }
  }
}

void RefuseFolders(const fs::path& output, const std::vector<fs::path>& read) {
  for (const fs::path& path : read) {
    if (fs::is_directory(path) && IsSame(output, path)) Refuse(output, "an input folder");
  }
}

void RefuseFile(const fs::path& output, const std::vector<fs::path>& read) {
  for (const fs::path& path : read) {
    if (!fs::is_directory(path) && IsSame(output, path)) Refuse(output, "an input file");
  }
}

fs::path FolderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

OutputFolder OpenFolderOf(const fs::path& file, const std::vector<fs::path>& read) {
  const fs::path resolved = Resolved(FolderOf(file));
  RefuseBelowSequence(file, resolved);
  RefuseRunsOfSuite(file, resolved);
  RefuseFile(file, read);
  return {FolderOf(file), {file.filename().string()}};
}

constexpr const char* kOwnFolder = "a folder of its own";

[[noreturn]] void Refuse(const fs::path& output, const std::string& found,
                         const std::string& expected) {
  throw UsageError(StrCat(output.string(), ": found ", found, ", expected ", expected));
}

bool Exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool IsIn(const fs::path& folder, const fs::path& above) {
  const auto [folder_end, above_end] =
      std::mismatch(folder.begin(), folder.end(), above.begin(), above.end());
  return above_end == above.end();
}

bool IsRun(const fs::path& folder) {
  return Exists(folder / "result.json") &&
         (Exists(folder / "truth.json") || Exists(folder / "objects.csv"));
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
  const fs::path resolved = Resolved(folder);
  RefuseBelowSequence(folder, resolved);
  RefuseRunsOfSuite(folder, resolved);
  RefuseFolders(folder, read);
  for (const std::string& name : names) {
    RefuseFile(folder / name, read);
    if (name.ends_with('/')) RefuseBelowSequence(folder / name, Resolved(folder / name));
  }
  return {folder, names};
}

void CheckOutputFile(const fs::path& file, const std::vector<fs::path>& read) {
  (void)OpenFolderOf(file, read);
}

void WriteOutputFile(const fs::path& file, const std::string& content,
                     const std::vector<fs::path>& read) {
  const OutputFolder output = OpenFolderOf(file, read);
  WriteFilesAtomically(output.path(), {{file.filename().string(), content}});
}

void CheckNewSequence(const fs::path& folder, const std::vector<fs::path>& read) {
  const fs::path resolved = Resolved(folder);
  RefuseBelowSequence(folder, FolderOf(resolved));
  RefuseRunsOfSuite(folder, resolved);
  RefuseFolders(folder, read);
}

std::vector<fs::path> FoldersOf(const Sequence& sequence) {
  std::set<fs::path> folders = {sequence.folder};
  for (const fs::path& file : sequence.other_files) folders.insert(FolderOf(file));
  return {folders.begin(), folders.end()};
}

void CheckApartFrom(const std::vector<fs::path>& inputs, const fs::path& output) {
  const fs::path resolved = Resolved(output);
  for (const fs::path& input : inputs) {
    if (input.empty() || !Exists(input)) continue;
    if (!fs::is_directory(input)) {
      if (Resolved(fs::absolute(input).parent_path()) != resolved) continue;
      Refuse(output, "the folder of the input " + input.string(), kOwnFolder);
    }
    const fs::path folder = Resolved(input);
    if (IsIn(resolved, folder)) Refuse(output, "the input folder " + input.string(), kOwnFolder);
    if (IsIn(folder, resolved)) {
      Refuse(output, "a folder that holds the input " + input.string(), kOwnFolder);
    }
  }
}

void CheckPlaceOfRun(const fs::path& output) {
  if (Exists(output / "plan.json")) Refuse(output, "the folder of a suite", kOwnFolder);
  const fs::path resolved = Resolved(output);
  for (fs::path folder = resolved.parent_path(); folder != folder.parent_path();
       folder = folder.parent_path()) {
    if (IsRun(folder)) Refuse(output, "the run in " + folder.string(), kOwnFolder);
  }
}

void CheckPlaceOfSuite(const fs::path& output, const std::string& suite) {
  if (Exists(output / "result.json")) Refuse(output, "the folder of a run", kOwnFolder);
  const std::string found = SuiteIn(output);
  if (found.empty() || found == suite) return;
  Refuse(output, "the suite " + found, "a folder of its own for " + suite);
}

void CheckNoCollection(const fs::path& folder) {
  if (Exists(folder / "plan.json") || !fs::is_directory(folder)) return;
  std::vector<std::string> suites;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (Exists(entry.path() / "plan.json")) suites.push_back(entry.path().filename().string());
  }
  if (suites.empty()) return;
  std::sort(suites.begin(), suites.end());
  ThrowError(folder.string(), "the folder of a collection of suites",
             "that of a suite in it: " + Joined(suites, ", "));
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
