// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cache/hash_index.h"

#include <sys/stat.h>

#include <algorithm>
#include <exception>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/cache/cache_file.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

constexpr int kSchemaVersion = 1;
constexpr std::uint64_t kLimit_bytes = 256'000'000;  // of all folders together

std::int64_t Nanoseconds(const timespec& time) {
  return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

// Parses an index file: a line with the checksum, then the index.
Json ParseIndex(const std::string& bytes, const std::string& where) {
  const std::string_view content =
      std::string_view(bytes).substr(std::min(bytes.size(), kHashBytes + 1));
  if (bytes.substr(0, kHashBytes) != Sha256Hex(content)) {
    ThrowError(where, "a damaged file", "the bytes that were written");
  }
  Json json = ParseJson(content, where);
  if (json.at("schema_version") != kSchemaVersion) {
    ThrowError(where, json.at("schema_version").dump(), StrCat("version ", kSchemaVersion));
  }
  return json;
}

}  // namespace

std::optional<FileStamp> StampOf(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return FileStamp{status.st_size, Nanoseconds(status.st_mtim), Nanoseconds(status.st_ctim),
                   status.st_ino};
}

HashIndex::HashIndex(const fs::path& index_folder, const fs::path& folder, const Notice& notice)
    : index_folder_(index_folder),
      folder_(fs::absolute(folder).lexically_normal().string()),
      name_(Sha256Hex(folder_) + ".json") {
  try {
    entries_ = Read();
  } catch (const std::exception& error) {       // including those of the JSON library
    if (IsGone(index_folder_ / name_)) return;  // another process has removed it
    notice(StrCat("file hashes are computed again: ", error.what()));
    std::error_code ignored;
    fs::remove(index_folder_ / name_, ignored);
  }
}

HashIndex::Entries HashIndex::Read() const {
  const fs::path file = index_folder_ / name_;
  if (index_folder_.empty() || IsGone(file)) return {};
  const Json json = ParseIndex(ReadFileBytes(file), file.string());
  if (json.at("folder") != folder_) {
    ThrowError(file.string(), Quoted(json.at("folder").dump()), folder_);
  }
  Entries entries;
  for (const Json& row : json.at("files")) {
    entries[row.at("name")] = {
        {row.at("size_bytes"), row.at("modified_ns"), row.at("changed_ns"), row.at("inode")},
        row.at("sha256")};
  }
  return entries;
}

std::string HashIndex::Find(const std::string& name, const FileStamp& stamp) const {
  const auto entry = entries_.find(name);
  return entry != entries_.end() && entry->second.stamp == stamp ? entry->second.sha256 : "";
}

void HashIndex::Add(const std::string& name, const FileStamp& stamp, const std::string& sha256) {
  entries_[name] = {stamp, sha256};
  changed_ = true;
}

void HashIndex::Save() const {
  if (!changed_ || index_folder_.empty()) return;
  std::error_code error;
  fs::create_directories(index_folder_, error);
  Entries merged;
  try {
    merged = Read();
  } catch (const std::exception&) {  // damaged in the meantime: replaced
  }
  for (const auto& [name, entry] : entries_) merged[name] = entry;
  Json files = Json::array();
  for (const auto& [name, entry] : merged) {
    if (!StampOf(fs::path(folder_) / name)) continue;
    files.push_back({{"name", name},
                     {"size_bytes", entry.stamp.size_bytes},
                     {"modified_ns", entry.stamp.modified_ns},
                     {"changed_ns", entry.stamp.changed_ns},
                     {"inode", entry.stamp.inode},
                     {"sha256", entry.sha256}});
  }
  const std::string content =
      DumpJson({{"schema_version", kSchemaVersion}, {"folder", folder_}, {"files", files}});
  WriteFilesAtomically(index_folder_, {{name_, Sha256Hex(content) + "\n" + content}});
  TrimFolder(index_folder_, kLimit_bytes);
}

}  // namespace cvo
