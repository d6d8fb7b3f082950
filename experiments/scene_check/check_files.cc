// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/scene_check/checks.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct ListedFile {
  std::string name;
  std::uint64_t bytes = 0;
  std::string sha256;
};

std::vector<ListedFile> ReadManifest(const fs::path& path) {
  const Json manifest = ReadJson(path);
  std::vector<ListedFile> files;
  try {
    for (const Json& file : manifest.at("files")) {
      files.push_back({file.at("name"), file.at("size_bytes"), file.at("sha256")});
    }
  } catch (const Json::exception& error) {
    ThrowError(path.string(), StrCat("no list of files (", error.what(), ")"),
               "\"files\": [{\"name\", \"size_bytes\", \"sha256\"}, ...]");
  }
  return files;
}

// Describes what is wrong with a listed file; empty if nothing is.
std::string FindFault(const fs::path& folder, const ListedFile& file) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(folder / file.name, error);
  if (error) return "missing";
  if (size != file.bytes) return StrCat(size, " bytes, listed with ", file.bytes);
  return Sha256Hex(ReadFileBytes(folder / file.name)) == file.sha256 ? "" : "other SHA-256";
}

std::set<std::string> FilesIn(const fs::path& folder) {
  std::set<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) files.insert(fs::relative(entry.path(), folder).generic_string());
  }
  return files;
}

// Returns the check that `count` is zero, with the first of the files counted.
SceneCheck CountOf(const std::string& name, int count, const std::string& first) {
  return {name, static_cast<double>(count), "files", Bound::kAtMost, 0.0, first};
}

}  // namespace

std::vector<SceneCheck> CheckFiles(const fs::path& folder, TaskPool& pool) {
  const std::vector<ListedFile> listed = ReadManifest(folder / "manifest.json");
  const std::vector<std::string> faults = ForAll<std::string>(
      static_cast<int>(listed.size()), pool,
      [&](int i) { return FindFault(folder, listed[static_cast<std::size_t>(i)]); });
  int changed = 0;
  std::string first_changed;
  std::set<std::string> present = FilesIn(folder);
  present.erase("manifest.json");
  for (std::size_t i = 0; i < listed.size(); ++i) {
    present.erase(listed[i].name);
    if (faults[i].empty()) continue;
    if (changed++ == 0) first_changed = listed[i].name + ": " + faults[i];
  }
  return {CountOf("manifest_changed_files", changed, first_changed),
          CountOf("manifest_unlisted_files", static_cast<int>(present.size()),
                  present.empty() ? "" : *present.begin())};
}

}  // namespace cvo
