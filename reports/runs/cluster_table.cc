// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "core/base/error.h"
#include "reports/runs/detail_files.h"
#include "reports/tables/json_text.h"

namespace cvo::reports {
namespace {

// Cells of one line; a trailing line end is not part of the last.
std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    cells.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

class CsvLine {
 public:
  CsvLine(const std::vector<std::string_view>& header, std::string_view line, std::string where)
      : header_(header), cells_(Split(line, ',')), where_(std::move(where)) {
    if (cells_.size() != header_.size()) {
      ThrowError(where_, StrCat(cells_.size(), " cells"), StrCat(header_.size(), " as in line 1"));
    }
  }

  std::string_view Text(std::string_view column) const {
    const auto found = std::find(header_.begin(), header_.end(), column);
    if (found == header_.end()) ThrowError(where_, StrCat("no column ", column), "one");
    return cells_[static_cast<std::size_t>(found - header_.begin())];
  }
  template <typename Number>
  Number As(std::string_view column) const {
    const std::string_view text = Text(column);
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() ||
        !std::isfinite(static_cast<double>(number))) {
      ThrowError(StrCat(where_, ", column ", column), StrCat("\"", text, "\""), "a finite number");
    }
    return number;
  }
  // Of columns named as given, after the prefix.
  template <std::size_t kSize>
  std::array<double, kSize> Numbers(const std::array<const char*, kSize>& columns,
                                    const std::string& prefix = "") const {
    std::array<double, kSize> numbers{};
    for (std::size_t i = 0; i < kSize; ++i) numbers[i] = As<double>(prefix + columns[i]);
    return numbers;
  }

 private:
  const std::vector<std::string_view>& header_;
  std::vector<std::string_view> cells_;
  std::string where_;
};

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
      Split(std::string_view(text).substr(0, text.size() - 1), '\n');
  const std::vector<std::string_view> header = Split(lines.front(), ',');
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
