// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/known_metrics.h"

namespace cvo {
namespace {

void Add(const std::string& prefix, const std::vector<std::string>& names,
         std::vector<std::string>& all) {
  for (const std::string& name : names) all.push_back(prefix + name);
}

}  // namespace

std::vector<std::string> KnownMetrics() {
  const std::vector<std::string> camera = {
      "coverage",       "ate",          "ate_mean",     "ate_median", "ate_max", "rrpe_all_pairs",
      "trpe_all_pairs", "rrpe_1_frame", "trpe_1_frame", "t_drift",    "r_drift"};
  const std::vector<std::string> predicted = {"ate", "success_5cm", "success_10cm", "success_20cm"};
  const std::vector<std::string> bodies = {
      "coverage",       "success_5cm",    "success_10cm", "success_20cm", "ate",
      "rrpe_all_pairs", "trpe_all_pairs", "rrpe_1_frame", "trpe_1_frame", "motion_r",
      "motion_t",       "velocity",       "id_switches",  "fragments",    "unmatched"};
  std::vector<std::string> all;
  for (const char* time : {"", "causal_"}) {
    const std::string object = std::string("object_") + time;
    Add(std::string("camera_") + time, camera, all);
    Add(object, bodies, all);
    Add(object + "predicted_", predicted, all);
    Add(object + "standing_", bodies, all);
    all.push_back(object + "unmatched_clusters");
  }
  Add("", {"moving_precision", "moving_recall", "clustering_iou", "clustering_ari"}, all);
  return all;
}

}  // namespace cvo
