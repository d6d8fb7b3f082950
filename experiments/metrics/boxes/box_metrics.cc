// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "core/base/error.h"
#include "experiments/datasets/formats/object_boxes.h"
#include "experiments/datasets/images.h"
#include "experiments/metrics/boxes/average_precision.h"

namespace cvo {

namespace {

namespace fs = std::filesystem;

using Frames = std::map<int, ApFrame>;

Frames ReadTracking(const fs::path& label_file, const fs::path& detection_file, bool tracks) {
  constexpr int kAnyFrame = std::numeric_limits<int>::max();
  Frames frames;
  for (const ObjectBox& box : ReadLabels(label_file, kAnyFrame)) {
    frames[box.frame].labels.push_back(box);
  }
  for (const ObjectBox& box :
       tracks ? ReadTracks(detection_file, kAnyFrame) : ReadDetections(detection_file, kAnyFrame)) {
    frames[box.frame].detections.push_back(box);
  }
  return frames;
}

Frames ReadObjects(const fs::path& label_folder, const fs::path& detection_folder) {
  const auto labels = NumberedFiles(label_folder, ".txt");
  const auto detections = NumberedFiles(detection_folder, ".txt");
  for (const auto& [number, file] : detections) {
    if (!labels.contains(number)) {
      ThrowError(file.string(), StrCat("detections of image ", number),
                 "one that has a label file in " + label_folder.string());
    }
  }
  Frames frames;
  for (const auto& [number, file] : labels) {
    const int index = static_cast<int>(frames.size());
    ApFrame frame{ReadObjectFile(file, index), {}};
    const auto found = detections.find(number);
    if (found != detections.end()) frame.detections = ReadObjectFile(found->second, index);
    frames.emplace(index, std::move(frame));
  }
  return frames;
}

}  // namespace

void CheckScores(const std::vector<ApFrame>& frames, const std::string& where) {
  std::ptrdiff_t with = 0;
  std::ptrdiff_t all = 0;
  for (const ApFrame& frame : frames) {
    all += std::ssize(frame.detections);
    with += std::ranges::count_if(frame.detections, [](const auto& box) { return !!box.score; });
  }
  if (with != 0 && with != all) {
    ThrowError(where, StrCat("scores of ", with, " of ", all, " detections"), "of all or of none");
  }
}

std::vector<ApFrame> ReadApFrames(const fs::path& labels, const fs::path& detections,
                                  const FrameRange& range, bool tracks) {
  const bool folders = fs::is_directory(labels);
  if (folders != fs::is_directory(detections)) {
    ThrowError(detections.string(), folders ? "a file" : "a folder",
               (folders ? "a folder, as " : "a file, as ") + labels.string());
  }
  const Frames all =
      folders ? ReadObjects(labels, detections) : ReadTracking(labels, detections, tracks);
  if (all.empty()) ThrowError(labels.string(), "no label", "at least one");
  const FrameRange within = ResolveFrameRange(range, all.rbegin()->first + 1);
  std::vector<ApFrame> frames;
  for (const auto& [number, frame] : all) {
    if (number >= within.begin && number < within.end) frames.push_back(frame);
  }
  return frames;
}

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
