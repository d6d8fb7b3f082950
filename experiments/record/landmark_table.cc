// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/record/landmark_table.h"

#include "core/base/error.h"
#include "experiments/record/table_row.h"

namespace cvo {
namespace {

// Finer than anything that is computed from these values, and half the bytes of an exact
// representation.
constexpr int kDecimalsPixels = 2;
constexpr int kDecimals = 3;  // m, nats

void Label(ClusterId id, TableRow& row) {
  if (id.valid()) {
    row.Integer(id.value);
  } else {
    row.Empty(1);
  }
}

}  // namespace

const std::string_view kLandmarksHeader =
    "frame,id,u_px,v_px,u_right_px,cluster,inferred,confidence,energy_2d,energy_3d,energy_motion,"
    "x,y,z,truth_body,second,second_2d,second_3d,second_motion\n";

std::string LandmarkRows(int frame, const StereoFrame& given,
                         const std::vector<LandmarkReport>& landmarks,
                         const std::vector<LandmarkTruth>& feature_truth) {
  Require(feature_truth.empty() || feature_truth.size() == given.features.size(),
          "LandmarkRows: truth for every feature, or none");
  std::string rows;
  for (const LandmarkReport& landmark : landmarks) {
    const auto feature = static_cast<std::size_t>(landmark.feature);
    TableRow row(',');
    row.Integer(frame);
    row.Integer(landmark.id.value);
    for (int k = 0; k < 3; ++k) row.Rounded(given.features.at(feature).z_px[k], kDecimalsPixels);
    Label(landmark.cluster, row);
    Label(landmark.inferred, row);
    row.Integer(landmark.confidence);
    row.Rounded(landmark.energy_2d, kDecimals);
    row.Rounded(landmark.energy_3d, kDecimals);
    row.Rounded(landmark.energy_motion, kDecimals);
    for (int k = 0; k < 3; ++k) row.Rounded(landmark.p_in_world[k], kDecimals);
    const int body = feature_truth.empty() ? -1 : feature_truth[feature].body;
    body < 0 ? row.Empty(1) : row.Integer(body);
    Label(landmark.second, row);
    row.Rounded(landmark.second_2d, kDecimals);
    row.Rounded(landmark.second_3d, kDecimals);
    row.Rounded(landmark.second_motion, kDecimals);
    rows += row.Line();
  }
  return rows;
}

}  // namespace cvo
