// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/kitti_ap/box_metrics.h"

#include <algorithm>
#include <array>

#include "experiments/metrics/kitti_ap/average_precision.h"

namespace cvo {
namespace {

using enum reports::MetricId;

struct SpaceMetrics {
  BoxSpace space;
  std::array<reports::MetricId, 3> levels;
};
constexpr std::array<SpaceMetrics, 2> kSpaces = {
    {{BoxSpace::kBirdsEye, {kBoxApBvEasy, kBoxApBvModerate, kBoxApBvHard}},
     {BoxSpace::kVolume, {kBoxAp3dEasy, kBoxAp3dModerate, kBoxAp3dHard}}}};

std::vector<ApFrame> FramesOf(const Sequence& sequence, const std::vector<ObjectBox>& boxes) {
  std::vector<ApFrame> frames(sequence.images.size());
  const auto frame_of = [&](const ObjectBox& box) -> ApFrame& {
    return frames.at(static_cast<std::size_t>(box.frame - sequence.first_frame));
  };
  for (const ObjectBox& label : sequence.labels) frame_of(label).labels.push_back(label);
  for (const ObjectBox& box : boxes) frame_of(box).detections.push_back(box);
  return frames;
}

}  // namespace

bool TellsBoxes(const Sequence& sequence) {
  return std::any_of(sequence.labels.begin(), sequence.labels.end(), [](const ObjectBox& label) {
    return label.type == ApProtocol().category && label.box3d.has_value();
  });
}

std::vector<Metric> BoxMetrics(const Sequence& sequence, const std::vector<ObjectBox>& boxes) {
  if (!TellsBoxes(sequence)) return {};
  ApProtocol protocol;
  protocol.least_overlap = 0.25;
  const std::vector<ApFrame> frames = FramesOf(sequence, boxes);
  std::vector<Metric> metrics;
  for (const SpaceMetrics& space : kSpaces) {
    protocol.space = space.space;
    for (const AveragePrecision& level : EvaluateAp(frames, protocol)) {
      if (level.valid_labels == 0) continue;
      const reports::MetricId id = space.levels.at(static_cast<std::size_t>(level.level));
      Metric metric = MakeMetric({id}, level.ap11, level.valid_labels);
      metric.contract.subject = reports::Subject::kCars;
      metric.contract.truth = reports::TruthSource::kLabels;
      metric.left_out = "nothing";
      metrics.push_back(std::move(metric));
    }
  }
  return metrics;
}

}  // namespace cvo
