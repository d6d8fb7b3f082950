// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/output_place.h"

#include <algorithm>
#include <exception>
#include <system_error>

#include "core/base/lists.h"
#include "core/files/json/json.h"
#include "experiments/cli/output_file.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOwnFolder = "a folder of its own";

[[noreturn]] void Refuse(const fs::path& output, const std::string& found,
                         const std::string& expected) {
  throw UsageError(StrCat(output.string(), ": found ", found, ", expected ", expected));
}

bool Exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

fs::path Resolved(const fs::path& path) {
  const fs::path resolved = fs::weakly_canonical(fs::absolute(path));
  return resolved.has_filename() ? resolved : resolved.parent_path();
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

}  // namespace cvo
