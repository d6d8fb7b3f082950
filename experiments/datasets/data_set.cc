// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/data_set.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

struct Projection {
  double focal_px, cx_px, cy_px;
};

// The rectified cameras of KITTI's five days (2011_09_26, 28, 29, 30 and 10_03). Odometry,
// tracking, object and stereo benchmarks are parts of these recordings and repeat their numbers.
constexpr std::array<Projection, 5> kKittiDays = {{{721.5377, 609.5593, 172.8540},
                                                   {707.0493, 604.0814, 180.5066},
                                                   {718.3351, 600.3891, 181.5122},
                                                   {707.0912, 601.8873, 183.1104},
                                                   {718.8560, 607.1928, 185.2157}}};

// Grey and colour pairs alike are 0.53 to 0.54 m apart.
bool IsKittiRig(const StereoCamera& camera) {
  const auto near = [](double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
  };
  constexpr double kDigits_px = 1e-4;
  return near(camera.baseline_m, 0.535, 0.01) &&
         std::any_of(kKittiDays.begin(), kKittiDays.end(), [&](const Projection& day) {
           return near(camera.fx, day.focal_px, kDigits_px) &&
                  near(camera.fy, day.focal_px, kDigits_px) &&
                  near(camera.cx, day.cx_px, kDigits_px) && near(camera.cy, day.cy_px, kDigits_px);
         });
}

}  // namespace

std::string DataSetOf(const Sequence& sequence, const std::string& named) {
  if (named == kKittiDataSet || named == kOtherDataSet) return named;
  if (!named.empty()) {
    ThrowError("option --dataset", Quoted(named), StrCat(kKittiDataSet, " or ", kOtherDataSet));
  }
  // A rendered scene may have been given KITTI's camera.
  const bool rendered = std::filesystem::exists(sequence.folder / "scene.json");
  return !rendered && IsKittiRig(sequence.camera) ? kKittiDataSet : kOtherDataSet;
}

}  // namespace cvo
