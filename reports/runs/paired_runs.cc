// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/paired_runs.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "reports/statistics/estimate.h"
#include "reports/statistics/position_errors.h"
#include "reports/tables/cells.h"

namespace cvo::reports {
namespace {

// Errors in the frames that both runs have.
struct CommonErrors {
  std::vector<double> errors_m;
  std::vector<double> reference_m;
};

// Calls `act` with the indices of each frame that both have. `shift` and `reference_shift` convert
// their frames to a common numbering.
template <typename Act>
void ForCommonFrames(const std::vector<int>& frames, int shift, const std::vector<int>& reference,
                     int reference_shift, const Act& act) {
  for (std::size_t i = 0, k = 0; i < frames.size() && k < reference.size();) {
    const int frame = frames[i] + shift;
    const int other = reference[k] + reference_shift;
    if (frame == other) act(i, k);
    if (frame <= other) ++i;
    if (other <= frame) ++k;
  }
}

CommonErrors CommonBodyErrors(const FrameErrors& errors, int shift, const FrameErrors& reference,
                              int reference_shift) {
  CommonErrors common;
  ForCommonFrames(errors.frames, shift, reference.frames, reference_shift,
                  [&](std::size_t i, std::size_t k) {
                    common.errors_m.push_back(errors.position_m[i]);
                    common.reference_m.push_back(reference.position_m[k]);
                  });
  return common;
}

// Aligns each run to the truth over the same frames: otherwise what one of them did in other frames
// would affect its errors in these.
CommonErrors CommonCameraErrors(const CameraPositions& run, const CameraPositions& reference) {
  CameraPositions here;
  CameraPositions there;
  const auto add = [](const CameraPositions& from, std::size_t i, CameraPositions& to) {
    to.estimated_m.push_back(from.estimated_m[i]);
    to.truth_m.push_back(from.truth_m[i]);
  };
  ForCommonFrames(run.frames, 0, reference.frames, 0, [&](std::size_t i, std::size_t k) {
    add(run, i, here);
    add(reference, k, there);
  });
  return {AlignedErrors(here.estimated_m, here.truth_m),
          AlignedErrors(there.estimated_m, there.truth_m)};
}

// Blocks take the place of bodies in the samples, because resampling happens within a single scene.
std::vector<Sample> BlocksOf(const CommonErrors& common) {
  const std::size_t length = BlockLength(common.errors_m.size());
  std::vector<Sample> blocks;
  for (std::size_t i = 0; i < common.errors_m.size(); ++i) {
    if (i % length == 0) {
      const std::string number = StrCat(blocks.size());
      blocks.push_back({"",
                        "",
                        std::string(8 - std::min<std::size_t>(number.size(), 8), '0') + number,
                        "",
                        {0.0, 0.0},
                        {0.0, 0.0}});
    }
    Sample& block = blocks.back();
    block.value.sum += common.errors_m[i];
    block.reference.sum += common.reference_m[i];
    block.value.weight += 1.0;
    block.reference.weight += 1.0;
  }
  return blocks;
}

void AddPair(const std::string& what, const std::string& metric, const CommonErrors& common,
             const RunToCompare& run, const RunToCompare& reference,
             std::vector<PairedComparison>& comparisons) {
  const std::vector<Sample> blocks = BlocksOf(common);
  const auto estimate = EstimateDifference(blocks, Within::kMean);
  if (!estimate) return;
  const std::string meaning = StrCat(
      "95 %, bootstrap over ", blocks.size(), " blocks of ", BlockLength(common.errors_m.size()),
      " consecutive frames of this sequence: says nothing about other scenes");
  comparisons.push_back(
      {run.name, what, metric, "m", common.errors_m.size(),
       DifferenceOf(*estimate, reference.name, meaning, "frames that both estimate"), ""});
}

// Only metrics of tables are paired, of bodies that move and of bodies that stay put. Any more of
// them would reduce each other's significance.
bool IsPaired(const BodyMetric& metric) {
  const std::vector<std::string> usual = ObjectMetrics();
  return !metric.form.causal && !metric.predicted() &&
         std::find(usual.begin(), usual.end(), MetricName({metric.form.id})) != usual.end();
}

}  // namespace

std::size_t BlockLength(std::size_t frames) {
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(frames)))));
}

CameraPositions CameraPositionsOf(const RunDetail& detail) {
  CameraPositions camera;
  const auto position = [](const Pose& pose) { return Position{pose[0], pose[1], pose[2]}; };
  for (const CameraFrame& frame : detail.camera) {
    if (!frame.truth || frame.status == "skipped") continue;
    camera.frames.push_back(frame.frame);
    camera.estimated_m.push_back(position(frame.world_from_camera));
    camera.truth_m.push_back(position(*frame.truth));
  }
  return camera;
}

std::vector<PairedComparison> PairByFrame(const RunToCompare& run, const RunToCompare& reference) {
  std::vector<PairedComparison> comparisons;
  AddPair("camera", "camera_ate_mean", CommonCameraErrors(run.camera, reference.camera), run,
          reference, comparisons);
  if (!run.summary.bodies || !reference.summary.bodies) return comparisons;
  for (const BodyRow& body : run.summary.bodies->refined) {
    const BodyRow* other = FindBy(reference.summary.bodies->refined, &BodyRow::id, body.id);
    if (other == nullptr) continue;
    AddPair(body.name, body.mover ? "object_ate" : "object_standing_ate",
            CommonBodyErrors(body.errors, run.summary.sequence.first_frame, other->errors,
                             reference.summary.sequence.first_frame),
            run, reference, comparisons);
  }
  return comparisons;
}

std::vector<PairedComparison> PairByBody(const RunToCompare& run, const RunToCompare& reference,
                                         const std::vector<ComparedMetric>& metrics) {
  std::vector<PairedComparison> comparisons;
  for (const ComparedMetric& metric : metrics) {
    const std::optional<BodyMetric> body_metric = FindBodyMetric(metric.name);
    if (!body_metric || !IsPaired(*body_metric) || !metric.differing.empty()) continue;
    std::vector<Sample> samples;
    for (const BodyRow& body : BodiesOf(*body_metric, run.summary)) {
      const BodyRow* other =
          FindBy(BodiesOf(*body_metric, reference.summary), &BodyRow::id, body.id);
      const auto pair = other == nullptr ? std::nullopt : PairOf(*body_metric, body, *other);
      if (!pair) continue;
      samples.push_back({"", "", StrCat("body ", body.id), "", pair->first, pair->second});
    }
    const auto estimate = EstimateDifference(samples, body_metric->within());
    if (!estimate) continue;
    const std::string meaning = StrCat("95 %, bootstrap over ", samples.size(),
                                       " bodies of one scene: says nothing about other scenes");
    comparisons.push_back(
        {run.name, metric.name, metric.name, metric.unit, 0,
         DifferenceOf(*estimate, reference.name, meaning, PairingText(*body_metric)), ""});
  }
  return comparisons;
}

}  // namespace cvo::reports
