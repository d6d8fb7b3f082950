// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/files/disk.h"

namespace cvo {

// A new file of a cache folder, which appears either complete or not at all. Creates the folder if
// necessary and removes temporaries of writers that have ended. All functions throw Error with the
// system's reason. The temporary is deleted with the object.
class NewCacheFile {
 public:
  explicit NewCacheFile(const std::filesystem::path& folder);
  ~NewCacheFile();
  NewCacheFile(const NewCacheFile&) = delete;
  NewCacheFile& operator=(const NewCacheFile&) = delete;

  void Append(std::string_view bytes);
  void ReplaceStart(std::string_view bytes);
  std::uint64_t size_bytes() const { return size_bytes_; }

  // Syncs the file to disk, then gives it its name. A file that already has this name stays.
  void Publish(const std::string& name);

 private:
  std::filesystem::path folder_;
  std::filesystem::path temporary_;
  FileDescriptor file_;
  std::uint64_t size_bytes_ = 0;
};

// Whether the file does not exist, for example because another process has removed it.
bool IsGone(const std::filesystem::path& file);

// Makes the file the most recently used, which TrimFolder removes last. Fails silently, for example
// in a folder of another user.
void MarkUsed(const std::filesystem::path& file);

// Removes files, least recently used first, until the rest is within the limit. Temporaries do not
// count. Files that cannot be removed stay.
void TrimFolder(const std::filesystem::path& folder, std::uint64_t limit_bytes);

}  // namespace cvo
