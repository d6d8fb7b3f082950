// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/front_end.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/features/orb/orb.h"
#include "core/features/stereo_matcher.h"

namespace cvo {
namespace {

std::string Describe(const cv::Mat& image) {
  if (image.empty()) return "no pixels";
  return StrCat(image.cols, " x ", image.rows, " ", cv::typeToString(image.type()));
}

void CheckImage(const char* name, const cv::Mat& image, const StereoCamera& camera) {
  if (image.type() == CV_8UC1 && image.cols == camera.width_px && image.rows == camera.height_px &&
      !image.empty()) {
    return;
  }
  ThrowError(StrCat("stereo pair: ", name, " image"), Describe(image),
             StrCat(camera.width_px, " x ", camera.height_px, " CV_8UC1, as the camera has it"));
}

}  // namespace

OrbOptions RightOrb(const OrbOptions& orb, const StereoMatchOptions& stereo) {
  OrbOptions right = orb;
  right.features = std::min(static_cast<int>(std::lround(orb.features * stereo.right_features)),
                            OrbOptions::kMaxFeatures);
  return right;
}

std::vector<StereoFeature> ExtractStereoFeatures(const cv::Mat& left, const cv::Mat& right,
                                                 const StereoCamera& camera, const OrbOptions& orb,
                                                 const StereoMatchOptions& stereo, TaskPool& pool,
                                                 RecentBoxes boxes) {
  CheckImage("left", left, camera);
  CheckImage("right", right, camera);
  orb.Check();
  stereo.Check();
  const OrbOptions right_orb = RightOrb(orb, stereo);
  const std::vector<CornerRegion> regions = LeftRegions(boxes, orb);
  std::array<OrbImage, 2> extracted;
  pool.ParallelFor(2, [&](int i) {
    extracted[i] = i == 0 ? ExtractOrb(left, orb, regions)
                          : ExtractOrb(right, right_orb, RightRegions(regions, stereo, camera));
  });
  return MatchStereo(extracted[0], extracted[1], camera, orb, stereo,
                     boxes.empty() ? std::vector<cv::Rect2d>() : boxes.back());
}

}  // namespace cvo
