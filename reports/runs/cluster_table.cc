// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>

#include "core/files/csv_file.h"
#include "reports/runs/detail_files.h"

namespace cvo::reports {
namespace {

class ClusterTable {
 public:
  explicit ClusterTable(const std::filesystem::path& file) : csv_(file) {}

  std::size_t rows() const { return csv_.rows(); }
  ClusterRow Row(std::size_t i) const {
    ClusterRow row;
    row.frame = csv_.Integer(i, frame_);
    row.id = csv_.Id(i, id_);
    row.category = csv_.Text(i, category_);
    row.predicted = csv_.Text(i, status_) == "predicted";
    // Refined values are empty if the run never returned to the frame; then those from when the
    // frame arrived are used.
    const bool refined = !csv_.Empty(i, refined_pose_);
    row.world_from_object = csv_.Numbers<7>(i, refined ? refined_pose_ : pose_);
    row.velocity_m_s = csv_.Numbers<3>(i, refined ? refined_velocity_ : velocity_);
    AddBox(i, row);
    row.observed_landmarks = csv_.Integer(i, observed_);
    return row;
  }

 private:
  // Older tables only have the extent along the axes of the object frame.
  void AddBox(std::size_t i, ClusterRow& row) const {
    if (box_) {
      row.object_from_box = csv_.Numbers<7>(i, *box_);
      row.size_m = csv_.Numbers<3>(i, *box_ + 7);
      return;
    }
    const std::array<double, 6> extent = csv_.Numbers<6>(i, extent_);
    row.object_from_box = {extent[0], extent[1], extent[2], 0.0, 0.0, 0.0, 1.0};
    row.size_m = {2.0 * extent[3], 2.0 * extent[4], 2.0 * extent[5]};
  }

  CsvFile csv_;
  // The first column of each group.
  std::size_t frame_ = csv_.Column("frame");
  std::size_t id_ = csv_.Column("id");
  std::size_t category_ = csv_.Column("category");
  std::size_t status_ = csv_.Column("status");
  std::size_t pose_ = csv_.Columns({"x", "y", "z", "qx", "qy", "qz", "qw"});
  std::size_t velocity_ = csv_.Columns({"vx", "vy", "vz"});
  std::size_t refined_pose_ = csv_.Columns({"refined_x", "refined_y", "refined_z", "refined_qx",
                                            "refined_qy", "refined_qz", "refined_qw"});
  std::size_t refined_velocity_ = csv_.Columns({"refined_vx", "refined_vy", "refined_vz"});
  std::size_t extent_ =
      csv_.Columns({"center_x", "center_y", "center_z", "half_x_m", "half_y_m", "half_z_m"});
  std::optional<std::size_t> box_ =
      csv_.Has("box_x")
          ? std::optional(csv_.Columns({"box_x", "box_y", "box_z", "box_qx", "box_qy", "box_qz",
                                        "box_qw", "length_m", "height_m", "width_m"}))
          : std::nullopt;
  std::size_t observed_ = csv_.Column("observed_landmarks");
};

}  // namespace

std::vector<ClusterRow> ReadClusterTable(const std::filesystem::path& file) {
  const ClusterTable table(file);
  std::vector<ClusterRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) rows.push_back(table.Row(i));
  std::stable_sort(rows.begin(), rows.end(), [](const ClusterRow& a, const ClusterRow& b) {
    return std::pair(a.frame, a.id) < std::pair(b.frame, b.id);
  });
  return rows;
}

}  // namespace cvo::reports
