// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include "reports/overlays/csv_columns.h"
#include "reports/overlays/overlay_run.h"
#include "reports/results/json_text.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

using ClusterKey = std::pair<int, std::int64_t>;  // frame, id

// The rows of objects.csv that say which detection the cluster was associated with.
std::set<ClusterKey> AssociatedClusters(const fs::path& file) {
  std::set<ClusterKey> associated;
  ReadCsvColumns(file, {"frame", "id", "detection"}, [&](const CsvCells& row) {
    if (row.Text(2).empty()) return;
    associated.emplace(row.Number<int>(0), row.Number<std::int64_t>(1));
  });
  return associated;
}

std::vector<std::string_view> Words(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(' '); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find(' ', begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(' ', end);
  }
  return words;
}

// One row of KITTI tracking results.
class TrackRow {
 public:
  // A category may hold blanks, so what follows it is counted from the end.
  TrackRow(std::string_view line, std::string where)
      : words_(Words(line)), where_(std::move(where)) {
    constexpr std::size_t kColumns = 18;
    if (words_.size() < kColumns) {
      ThrowError(where_, StrCat(words_.size(), " columns"), StrCat(kColumns));
    }
  }
  ClusterKey Key() const { return {As<int>(0), As<std::int64_t>(1)}; }
  PixelBox Box() const {
    const std::size_t first = words_.size() - 12;  // box, size, position, heading, score
    return {As<double>(first), As<double>(first + 1), As<double>(first + 2), As<double>(first + 3)};
  }

 private:
  template <typename Value>
  Value As(std::size_t column) const {
    const std::string_view text = words_[column];
    Value value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      ThrowError(StrCat(where_, ", column ", column + 1), StrCat("\"", text, "\""), "a number");
    }
    return value;
  }

  std::vector<std::string_view> words_;
  std::string where_;
};

}  // namespace

std::map<int, std::vector<LandmarkDot>> ReadLandmarks(const fs::path& file, LandmarkLabel label) {
  const std::string column = label == LandmarkLabel::kCluster ? "cluster" : "inferred";
  std::map<int, std::vector<LandmarkDot>> landmarks;
  ReadCsvColumns(file, {"frame", "u_px", "v_px", column, "truth_body"}, [&](const CsvCells& row) {
    LandmarkDot dot;
    dot.u_px = static_cast<float>(row.Number<double>(1));
    dot.v_px = static_cast<float>(row.Number<double>(2));
    if (!row.Text(3).empty()) dot.label = row.Number<std::int64_t>(3);
    if (!row.Text(4).empty()) dot.truth_body = row.Number<std::int32_t>(4);
    landmarks[row.Number<int>(0)].push_back(dot);
  });
  return landmarks;
}

std::map<int, std::vector<PixelBox>> ReadAssociatedBoxes(const fs::path& folder) {
  const std::set<ClusterKey> associated = AssociatedClusters(folder / "objects.csv");
  std::map<int, std::vector<PixelBox>> boxes;
  if (associated.empty()) return boxes;
  const std::string file = (folder / "tracks.kitti").string();
  const std::string text = ReadText(file);
  std::size_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::string where = StrCat(file, ", line ", number);
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) ThrowError(where, "a file that ends within it", "whole lines");
    const TrackRow row(std::string_view(text).substr(begin, end - begin), where);
    if (associated.contains(row.Key())) boxes[row.Key().first].push_back(row.Box());
    begin = end + 1;
  }
  return boxes;
}

}  // namespace cvo::reports
