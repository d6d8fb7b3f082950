// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/table_row.h"

#include <cmath>

#include "core/base/error.h"
#include "core/files/text/number.h"

namespace cvo {

void TableRow::Part() {
  if (!first_) line_ += separator_;
  first_ = false;
}

void TableRow::Text(std::string_view text) {
  Part();
  line_ += text;
}

void TableRow::Integer(std::int64_t value) { Text(std::to_string(value)); }

void TableRow::Number(double value) {
  if (!std::isfinite(value)) {
    ThrowError("a table's row \"" + line_ + "\"", "a number that is not finite", "a finite one");
  }
  Text(FormatDouble(value));
}

void TableRow::Rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  Number(std::round(value * scale) / scale);
}

void TableRow::Vector(const Eigen::Vector3d& vector) {
  for (int i = 0; i < 3; ++i) Number(vector[i]);
}

void TableRow::Pose(const RigidTransform& pose) {
  Vector(pose.translation());
  for (int i = 0; i < 4; ++i) Number(pose.data()[i]);
}

void TableRow::Box(const std::optional<ImageBox>& box) {
  if (!box) return Empty(4);
  for (const double side_px : {box->left_px, box->top_px, box->right_px, box->bottom_px}) {
    Number(side_px);
  }
}

void TableRow::Empty(int cells) {
  for (int i = 0; i < cells; ++i) Text("");
}

}  // namespace cvo
