// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/euroc_poses.h"

#include <optional>

#include "experiments/datasets/formats/data_rows.h"

namespace cvo {

Trajectory ReadEurocPoses(const std::filesystem::path& path) {
  const DataRows rows(path, 8, "time in ns, position x y z, quaternion w x y z");
  Trajectory poses;
  std::optional<std::int64_t> before_ns;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::int64_t time_ns = rows.Integer(i, 0);
    CheckLater(rows, i, time_ns, before_ns, "the body");
    before_ns = time_ns;
    poses.push_back({time_ns, {rows.Quaternion(i, 4, true), rows.Vector(i, 1)}});
  }
  return poses;
}

}  // namespace cvo
