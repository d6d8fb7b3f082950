// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "experiments/cache/cache_size.h"

namespace cvo {

// What the file system states about a file: with the same stamp it has the same bytes.
struct FileStamp {
  std::int64_t size_bytes = 0;
  std::int64_t modified_ns = 0;  // last change of content
  std::int64_t changed_ns = 0;   // of content, name or permissions; cannot be set back
  std::uint64_t inode = 0;

  bool operator==(const FileStamp&) const = default;
};

// Returns nothing if there is no such file. Follows symbolic links.
[[nodiscard]] std::optional<FileStamp> StampOf(const std::filesystem::path& file);

// Hashes (SHA-256) of the files of one folder from earlier runs, kept in an index file.
class HashIndex {
 public:
  // Reads the index of `folder`. A damaged index file counts as empty and is removed, with a
  // notice. If `index_folder` is empty, nothing is known and nothing is kept.
  HashIndex(const std::filesystem::path& index_folder, const std::filesystem::path& folder,
            const Notice& notice);

  // Returns the hash that the file had with this stamp; empty if unknown.
  std::string Find(const std::string& name, const FileStamp& stamp) const;
  void Add(const std::string& name, const FileStamp& stamp, const std::string& sha256);

  // Writes the index, merged with what others have added in the meantime and without files that no
  // longer exist. Throws Error if it cannot be written.
  void Save() const;

 private:
  struct Entry {
    FileStamp stamp;
    std::string sha256;
  };
  using Entries = std::map<std::string, Entry>;  // by name within the folder

  Entries Read() const;

  std::filesystem::path index_folder_;
  std::string folder_;  // absolute
  std::string name_;    // of the index file
  Entries entries_;
  bool changed_ = false;
};

}  // namespace cvo
