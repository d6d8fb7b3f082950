// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/identity_switches.h"

#include <map>

#include "core/files/text_file.h"

namespace cvo::reports {
namespace {

constexpr int kMinObservedLandmarks = 3;

// Number of landmarks by frame, body and cluster.
using LandmarkCounts = std::map<int, std::map<int, std::map<std::int64_t, int>>>;

LandmarkCounts ReadCounts(const std::filesystem::path& file) {
  const CsvFile csv(file);
  const std::size_t frame = csv.Column("frame");
  const std::size_t body = csv.Column("truth_body");
  const std::size_t cluster = csv.Column("cluster");
  const auto is_none = [&](std::size_t row, std::size_t column) {
    return csv.Empty(row, column) || csv.Text(row, column) == "0";
  };
  LandmarkCounts counts;
  for (std::size_t i = 0; i < csv.rows(); ++i) {
    if (is_none(i, body) || is_none(i, cluster)) continue;
    ++counts[csv.Integer(i, frame)][csv.Integer(i, body)][csv.Id(i, cluster)];
  }
  return counts;
}

// Returns the cluster with most landmarks; -1 if none has enough. On a tie, the last one wins, else
// the lower id.
std::int64_t BestCluster(const std::map<std::int64_t, int>& landmarks, std::int64_t last) {
  std::int64_t best = -1;
  int most = kMinObservedLandmarks - 1;
  for (const auto& [cluster, count] : landmarks) {
    if (count > most || (count == most && best != -1 && cluster == last)) {
      best = cluster;
      most = count;
    }
  }
  return best;
}

}  // namespace

std::optional<std::vector<IdentitySwitch>> ReadIdentitySwitches(
    const std::filesystem::path& run_folder, const std::vector<BodyDetail>& bodies) {
  const std::filesystem::path file = run_folder / "landmarks.csv";
  if (!std::filesystem::exists(file)) return std::nullopt;
  LandmarkCounts counts = ReadCounts(file);
  std::vector<IdentitySwitch> switches;
  for (const BodyDetail& body : bodies) {
    std::int64_t last = -1;
    for (const int frame : body.visible) {
      const std::int64_t best = BestCluster(counts[frame][body.id], last);
      if (best == -1) continue;
      if (last != -1 && best != last) switches.push_back({frame, body.id, last, best});
      last = best;
    }
  }
  return switches;
}

}  // namespace cvo::reports
