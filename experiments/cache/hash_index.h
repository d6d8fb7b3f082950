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

// What the file system says of a file: with the same stamp it has the same bytes.
struct FileStamp {
  std::int64_t size_bytes = 0;
  std::int64_t modified_ns = 0;  // content
  std::int64_t changed_ns = 0;   // of content, name or permissions; cannot be set back
  std::uint64_t inode = 0;

  bool operator==(const FileStamp&) const = default;
};

// Empty where there is no file. Follows links.
[[nodiscard]] std::optional<FileStamp> StampOf(const std::filesystem::path& file);

// SHA-256 of the files of one folder from earlier runs, kept in a file of its own.
class HashIndex {
 public:
  // Reads what is known of `folder`. A damaged file counts as empty: it is removed, with a notice.
  // Without an index folder nothing is known and nothing kept.
  HashIndex(const std::filesystem::path& index_folder, const std::filesystem::path& folder,
            const Notice& notice);

  // The hash that the file had with this stamp; empty where it is not known.
  std::string Find(const std::string& name, const FileStamp& stamp) const;
  void Add(const std::string& name, const FileStamp& stamp, const std::string& sha256);

  // Together with what others have added meanwhile, without files that are gone. Throws Error where
  // it cannot be written.
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
