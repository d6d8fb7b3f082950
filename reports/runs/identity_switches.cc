// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/identity_switches.h"

#include <map>

#include "reports/results/json_text.h"
#include "reports/runs/csv_line.h"

namespace cvo::reports {
namespace {

constexpr int kLandmarksThatCount = 3;

// Landmarks by frame, body and cluster.
using Counts = std::map<int, std::map<int, std::map<std::int64_t, int>>>;

Counts ReadCounts(const std::filesystem::path& file) {
  const std::string text = ReadText(file);
  if (text.back() != '\n') {
    ThrowError(file.string(), StrCat("text that ends after ", text.size(), " bytes"),
               "whole lines");
  }
  const std::string where = file.string() + ", line ";
  Counts counts;
  std::vector<std::string_view> header;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    if (number++ == 0) {
      header = SplitCells(line, ',');
      continue;
    }
    const CsvLine row(header, line, StrCat(where, number));
    const std::string_view body = row.Text("truth_body");
    const std::string_view cluster = row.Text("cluster");
    if (body.empty() || body == "0" || cluster.empty() || cluster == "0") continue;
    ++counts[row.As<int>("frame")][row.As<int>("truth_body")][row.As<std::int64_t>("cluster")];
  }
  return counts;
}

// -1: none with enough landmarks. Of two with as many, the last one, else the lower id.
std::int64_t BestCluster(const std::map<std::int64_t, int>& landmarks, std::int64_t last) {
  std::int64_t best = -1;
  int most = kLandmarksThatCount - 1;
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
  Counts counts = ReadCounts(file);
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
