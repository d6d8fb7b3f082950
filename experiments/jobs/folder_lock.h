// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace cvo {

// The right to write to a suite's folder, for as long as it exists and this process lives. Others
// may read meanwhile.
class FolderLock {
 public:
  // Throws Error saying which process on which host holds it, or why the file cannot be made.
  explicit FolderLock(const std::filesystem::path& file);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_;
};

}  // namespace cvo
