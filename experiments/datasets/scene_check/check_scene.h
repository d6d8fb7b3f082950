// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cvo {

// A measured figure of a rendered scene and the most that it may be.
struct SceneCheck {
  std::string name;   // "disparity_offset"
  double figure = 0;  // NaN, which fails, if nothing could be measured
  std::string unit;
  double limit = 0.0;
  std::string where;  // where the figure is worst; may be empty

  bool Passed() const { return figure <= limit; }
};

struct SceneCheckReport {
  std::string folder;
  int frames = 0;        // of the sequence
  int image_frames = 0;  // evenly chosen frames whose images were compared
  std::vector<SceneCheck> checks;

  bool Passed() const;
};

// Checks the files of a rendered scene against each other and against their manifest, using nothing
// but the contents of the folder: images against depth, poses and masks, poses against velocities,
// masks against boxes. The report does not depend on the number of threads. A file that cannot be
// read is a failed check; throws Error only if the folder is not that of a rendered scene.
SceneCheckReport CheckScene(const std::filesystem::path& folder, int threads);

}  // namespace cvo
