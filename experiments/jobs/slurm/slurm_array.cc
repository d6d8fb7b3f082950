// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/slurm/slurm_array.h"

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/jobs/slurm/slurm_script.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

constexpr const char* kRecord = "array.json";
constexpr int kSchemaVersion = 1;
constexpr std::size_t kNameDigits = 16;

fs::path NewFolder(const fs::path& root) {
  std::error_code error;
  fs::create_directories(root, error);
  if (error) throw Error(StrCat(root.string(), ": cannot create the folder: ", error.message()));
  std::string name = (root / "array-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw Error(StrCat(name, ": cannot create the folder: ", std::strerror(errno)));
  }
  fs::create_directories(fs::path(name) / "end");
  fs::create_directories(fs::path(name) / "out");
  return name;
}

SlurmArray Parse(const fs::path& folder, const Json& json) {
  const std::string where = (folder / kRecord).string();
  try {
    if (json.at("schema_version") != kSchemaVersion || json.at("kind") != "slurm_array") {
      ThrowError(where, "another kind of file", "a job array of this program's version");
    }
    SlurmArray array{folder, json.at("name").get<std::string>(), {}};
    for (const Json& task : json.at("tasks")) {
      array.entries.push_back(
          {task.at("name").get<std::string>(), task.at("key").get<std::string>()});
    }
    return array;
  } catch (const Json::exception& error) {
    ThrowError(where, error.what(), "name and tasks of a job array");
  }
}

std::optional<std::size_t> Number(const std::string& name) {
  if (name.empty() || name.size() > 9) return std::nullopt;
  if (!std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    return std::nullopt;
  }
  return std::stoul(name);
}

}  // namespace

std::string TaskKey(const Task& task, const std::vector<std::string>& sbatch_flags) {
  const Json what = {{"name", task.name},
                     {"argv", task.argv},
                     {"log", task.log.string()},
                     {"limit_s", task.limit_s},
                     {"limit_memory_mb", task.limit_memory_mb},
                     {"sbatch_flags", sbatch_flags}};
  // File names may contain bytes that are not UTF-8; for a key, replacing them is fine.
  return Sha256Hex(what.dump(-1, ' ', true, Json::error_handler_t::replace));
}

SlurmArray WriteSlurmArray(const fs::path& root, std::span<const Task> tasks,
                           const std::vector<std::string>& sbatch_flags) {
  SlurmArray array;
  array.folder = NewFolder(root);
  array.name = "clustervo-" + Sha256Hex(array.folder.string()).substr(0, kNameDigits);
  Json entries = Json::array();
  for (const Task& task : tasks) {
    array.entries.push_back({task.name, TaskKey(task, sbatch_flags)});
    entries.push_back({{"name", task.name}, {"key", array.entries.back().key}});
  }
  const Json record = {{"schema_version", kSchemaVersion},
                       {"kind", "slurm_array"},
                       {"name", array.name},
                       {"tasks", entries}};
  WriteFilesAtomically(
      array.folder, {{"tasks.sh", SlurmScript(tasks, array.folder)}, {kRecord, DumpJson(record)}});
  return array;
}

std::vector<SlurmArray> ReadSlurmArrays(const fs::path& root) {
  std::vector<SlurmArray> arrays;
  if (!fs::exists(root)) return arrays;
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
    if (entry.path().filename().string().starts_with("array-")) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  for (const fs::path& folder : folders) {
    if (fs::exists(folder / kRecord)) {
      arrays.push_back(Parse(folder, ReadJson(folder / kRecord)));
    } else {
      fs::remove_all(folder);
    }
  }
  return arrays;
}

std::map<std::size_t, SlurmEnd> ReadSlurmEnds(const SlurmArray& array) {
  std::map<std::size_t, SlurmEnd> ends;
  for (const fs::directory_entry& entry : fs::directory_iterator(array.folder / "end")) {
    const std::optional<std::size_t> number = Number(entry.path().filename().string());
    std::ifstream file(entry.path());
    SlurmEnd end;
    double start_s = 0.0;
    double end_s = 0.0;
    if (!number || !(file >> end.code >> start_s >> end_s)) continue;
    end.seconds = std::max(0.0, end_s - start_s);
    ends[*number] = end;
  }
  return ends;
}

void RemoveSlurmArray(const SlurmArray& array) {
  std::error_code ignored;
  fs::remove_all(array.folder, ignored);
}

std::string SlurmWords(const SlurmArray& array, std::size_t number) {
  std::ifstream file(array.folder / "out" / std::to_string(number));
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

}  // namespace cvo
