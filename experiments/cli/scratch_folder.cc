// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/scratch_folder.h"

#include <sys/stat.h>

#include "core/base/error.h"
#include "core/files/atomic_file.h"

namespace cvo {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  const fs::path parent = fs::temp_directory_path();
  RemoveLeftovers(parent);
  path_ = TemporaryName(parent / "clustervo");
  if (::mkdir(path_.c_str(), 0700) == 0) return;
  ThrowError(path_.string(), "a folder that cannot be created",
             "a writable folder for temporary files (TMPDIR)");
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace cvo
