// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/files/disk.h"

namespace cvo {

// A new file of a cache folder: it appears complete or not at all. Makes the folder where there is
// none and removes what dead writers left in it. All functions throw Error with the system's
// reason; the temporary goes away with the object.
class NewCacheFile {
 public:
  explicit NewCacheFile(const std::filesystem::path& folder);
  ~NewCacheFile();
  NewCacheFile(const NewCacheFile&) = delete;
  NewCacheFile& operator=(const NewCacheFile&) = delete;

  void Append(std::string_view bytes);
  void ReplaceStart(std::string_view bytes);
  std::uint64_t size_bytes() const { return size_bytes_; }

  // Synced to the disk, then under its name; a file that is there already stays.
  void Publish(const std::string& name);

 private:
  std::filesystem::path folder_;
  std::filesystem::path temporary_;
  FileDescriptor file_;
  std::uint64_t size_bytes_ = 0;
};

// Whether there is no such file, as once another process has removed it.
bool IsGone(const std::filesystem::path& file);

// Last in the order in which TrimFolder removes. Fails silently, as in a folder of somebody else.
void MarkUsed(const std::filesystem::path& file);

// Removes files, those used longest ago first, until the rest is within the limit. Temporaries do
// not count. Files that cannot be removed stay.
void TrimFolder(const std::filesystem::path& folder, std::uint64_t limit_bytes);

}  // namespace cvo
