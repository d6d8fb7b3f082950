// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/jobs/temporaries.h"

#include <system_error>
#include <vector>

namespace cvo {

namespace fs = std::filesystem;

void RemoveTemporaries(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().filename().string().starts_with('.') && it->path().extension() == ".tmp") {
      found.push_back(it->path());
    }
  }
  for (const fs::path& file : found) fs::remove(file, error);
}

}  // namespace cvo
