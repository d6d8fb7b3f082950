// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/association/box_association.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// One row of a table, with cells separated by `separator`. Numbers are written as the shortest text
// that reads back as the same number; a number that is not finite throws Error.
class TableRow {
 public:
  explicit TableRow(char separator) : separator_(separator) {}

  void Text(std::string_view text);
  void Integer(std::int64_t value);
  void Number(double value);
  // Appends the value rounded to a multiple of 10^-decimals.
  void Rounded(double value, int decimals);
  void Vector(const Eigen::Vector3d& vector);
  void Pose(const RigidTransform& pose);         // x y z qx qy qz qw
  void Box(const std::optional<ImageBox>& box);  // left top right bottom, px
  void Empty(int cells);

  // Returns the row with a newline.
  std::string Line() const { return line_ + '\n'; }

 private:
  void Part();

  char separator_;
  bool first_ = true;
  std::string line_;
};

}  // namespace cvo
