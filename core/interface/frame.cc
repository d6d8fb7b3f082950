// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/interface/frame.h"

#include "core/base/error.h"

namespace cvo {

void CheckGiven(const StereoFrame& frame) {
  const auto check = [](const char* where, std::size_t given, std::size_t expected) {
    if (given != 0 && given != expected) {
      ThrowError(where, StrCat(given, " bodies"), StrCat("none or ", expected));
    }
  };
  check("given.feature_body", frame.given.feature_body.size(), frame.features.size());
  check("given.detection_body", frame.given.detection_body.size(), frame.detections.size());
}

const char* ToString(FrameStatus status) {
  switch (status) {
    case FrameStatus::kFirst:
      return "first";
    case FrameStatus::kTracked:
      return "tracked";
    case FrameStatus::kRecovered:
      return "recovered";
    case FrameStatus::kLost:
      return "lost";
    case FrameStatus::kSkipped:
      return "skipped";
  }
  throw Error("ToString(FrameStatus): not a status");
}

const char* ToString(ClusterStatus status) {
  switch (status) {
    case ClusterStatus::kTracked:
      return "tracked";
    case ClusterStatus::kPredicted:
      return "predicted";
  }
  throw Error("ToString(ClusterStatus): not a status");
}

Matrix6d CalibrationReport::Covariance_px2() const { return information.inverse(); }

}  // namespace cvo
