// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/output_file.h"

#include "core/files/atomic_file.h"

namespace cvo {

void WriteOutputFile(const std::filesystem::path& file, const std::string& content) {
  const std::filesystem::path folder = file.parent_path();
  const OutputFolder output(folder.empty() ? "." : folder, {file.filename().string()});
  WriteFilesAtomically(output.path(), {{file.filename().string(), content}});
}

}  // namespace cvo
