// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/scratch_folder.h"

#include <sys/stat.h>

#include <cerrno>
#include <string>

#include "core/base/error.h"
#include "core/files/temporary.h"

namespace cvo {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  const fs::path parent = fs::temp_directory_path();
  RemoveLeftovers(parent);
  for (int attempt = 0;; ++attempt) {
    path_ = TemporaryName(parent / "clustervo", std::to_string(attempt));
    if (::mkdir(path_.c_str(), 0700) == 0) return;
    if (errno != EEXIST || attempt == 1000) {
      ThrowError(path_.string(), "a folder that cannot be created",
                 "a writable folder for temporary files (TMPDIR)");
    }
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace cvo
