// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string_view>

#include "core/base/error.h"
#include "reports/results/json_text.h"
#include "reports/runs/csv_line.h"
#include "reports/runs/detail_files.h"

namespace cvo::reports {
namespace {

ClusterRow ReadRow(const CsvLine& line) {
  ClusterRow row;
  row.frame = line.As<int>("frame");
  row.id = line.As<std::int64_t>("id");
  row.category = line.Text("category");
  row.predicted = line.Text("status") == "predicted";
  // Empty where the run never went back to the frame: then as it was when the frame came.
  const std::string prefix = line.Text("refined_x").empty() ? "" : "refined_";
  row.world_from_object = line.Numbers<7>({"x", "y", "z", "qx", "qy", "qz", "qw"}, prefix);
  row.velocity_m_s = line.Numbers<3>({"vx", "vy", "vz"}, prefix);
  row.center_in_object = line.Numbers<3>({"center_x", "center_y", "center_z"});
  row.half_size_m = line.Numbers<3>({"half_x_m", "half_y_m", "half_z_m"});
  row.observed_landmarks = line.As<int>("observed_landmarks");
  return row;
}

}  // namespace

std::vector<ClusterRow> ReadClusterTable(const std::filesystem::path& file) {
  const std::string text = ReadText(file);
  if (text.back() != '\n') {
    ThrowError(file.string(), StrCat("text that ends after ", text.size(), " bytes"),
               "whole lines");
  }
  const std::vector<std::string_view> lines =
      SplitCells(std::string_view(text).substr(0, text.size() - 1), '\n');
  const std::vector<std::string_view> header = SplitCells(lines.front(), ',');
  std::vector<ClusterRow> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    rows.push_back(ReadRow({header, lines[i], StrCat(file.string(), ", line ", i + 1)}));
  }
  std::stable_sort(rows.begin(), rows.end(), [](const ClusterRow& a, const ClusterRow& b) {
    return std::pair(a.frame, a.id) < std::pair(b.frame, b.id);
  });
  return rows;
}

}  // namespace cvo::reports
