// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "core/files/csv_file.h"
#include "core/files/text_file.h"
#include "reports/overlays/overlay_run.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

using ClusterKey = std::pair<int, std::int64_t>;  // frame, id

// The rows of objects.csv that name the detection that the cluster was associated with.
std::set<ClusterKey> AssociatedClusters(const fs::path& file) {
  const CsvFile csv(file);
  const std::size_t frame = csv.Column("frame");
  const std::size_t id = csv.Column("id");
  const std::size_t detection = csv.Column("detection");
  std::set<ClusterKey> associated;
  for (std::size_t i = 0; i < csv.rows(); ++i) {
    if (!csv.Empty(i, detection)) associated.emplace(csv.Integer(i, frame), csv.Id(i, id));
  }
  return associated;
}

// The 2D box of one row of KITTI tracking results. The category may contain spaces, so the columns
// after it are counted from the end.
PixelBox BoxOf(const TextRow& row) {
  const std::size_t first = row.size() - 12;  // box, size, position, heading, score
  return {row.Number(first), row.Number(first + 1), row.Number(first + 2), row.Number(first + 3),
          row.Id(1)};
}

}  // namespace

std::map<int, std::vector<LandmarkDot>> ReadLandmarks(const fs::path& file, LandmarkLabel label) {
  const std::string column = label == LandmarkLabel::kCluster ? "cluster" : "inferred";
  const CsvFile csv(file);
  const std::size_t frame = csv.Column("frame");
  const std::size_t u = csv.Column("u_px");
  const std::size_t v = csv.Column("v_px");
  const std::size_t of_cluster = csv.Column(column);
  const std::size_t body = csv.Column("truth_body");
  std::map<int, std::vector<LandmarkDot>> landmarks;
  for (std::size_t i = 0; i < csv.rows(); ++i) {
    LandmarkDot dot;
    dot.u_px = static_cast<float>(csv.Number(i, u));
    dot.v_px = static_cast<float>(csv.Number(i, v));
    if (!csv.Empty(i, of_cluster)) dot.label = csv.Id(i, of_cluster);
    if (!csv.Empty(i, body)) dot.truth_body = csv.Integer(i, body);
    landmarks[csv.Integer(i, frame)].push_back(dot);
  }
  return landmarks;
}

std::map<int, std::vector<PixelBox>> ReadAssociatedBoxes(const fs::path& folder) {
  const std::set<ClusterKey> associated = AssociatedClusters(folder / "objects.csv");
  std::map<int, std::vector<PixelBox>> boxes;
  if (associated.empty()) return boxes;
  const TextFile file(folder / "tracks.kitti");
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i);
    constexpr std::size_t kColumns = 18;
    if (file.Unterminated(i)) row.Fail("a last line without a line end", "whole lines");
    if (row.size() < kColumns) row.ExpectColumns(kColumns, "or more");
    const ClusterKey key{row.Integer(0), row.Id(1)};
    if (associated.contains(key)) boxes[key.first].push_back(BoxOf(row));
  }
  return boxes;
}

}  // namespace cvo::reports
