// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/output_file.h"

#include <algorithm>
#include <array>
#include <set>
#include <system_error>

#include "core/files/atomic_file.h"
#include "experiments/datasets/sequence.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

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

fs::path Resolved(const fs::path& path) { return fs::weakly_canonical(fs::absolute(path)); }

OutputFolder OpenFolderOf(const fs::path& file, const std::vector<fs::path>& read) {
  const fs::path resolved = Resolved(FolderOf(file));
  RefuseBelowSequence(file, resolved);
  RefuseRunsOfSuite(file, resolved);
  RefuseFile(file, read);
  return {FolderOf(file), {file.filename().string()}};
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

}  // namespace cvo
