// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/pictures/run_images.h"

#include <array>
#include <optional>

#include "core/base/error.h"
#include "experiments/datasets/images.h"
#include "experiments/runner/frame_detections.h"
#include "experiments/runner/identity.h"

namespace cvo {
namespace {

constexpr std::array<const char*, 4> kDetections = {"good", "oracle", "poor",
                                                    kDetectionsFromLabels};

SequenceRequest RequestOf(const reports::OverlayRun& run, const std::string& folder) {
  SequenceRequest request;
  request.folder = folder.empty() ? run.detail.timing.paths.sequence : folder;
  request.type = run.sequence.type;
  request.pair = run.sequence.pair;
  if (run.sequence.layout) request.layout = *run.sequence.layout;
  request.begin_frame = run.sequence.first_frame;
  request.end_frame = run.sequence.first_frame + run.sequence.frames;
  return request;
}

// Candidate sources of the run's boxes: the file that the run says it read, then whatever its
// folder may contain.
std::vector<BoxSources> SourcesOf(const reports::RunPaths& paths) {
  const std::string labels = paths.labels.value_or("");
  std::vector<BoxSources> sources;
  if (paths.detections) {
    sources.push_back({labels, *paths.detections, paths.detections_camera.value_or(-1),
                       paths.min_score.value_or(BoxSources().min_score)});
  }
  for (const char* name : kDetections) sources.push_back({labels, name});
  return sources;
}

Sequence OpenImages(const reports::OverlayRun& run, const std::string& folder) {
  const SequenceRequest request = RequestOf(run, folder);
  if (request.folder.empty()) {
    ThrowError("the images of " + run.sequence.name, "no folder in the run's timing.json",
               "a folder, or --sequence FOLDER");
  }
  try {
    return OpenSequence(request);
  } catch (const Error& error) {
    if (!folder.empty()) throw;
    throw Error(StrCat("the images of ", run.sequence.name,
                       " are not in the folder that the run read them from: ", error.what(),
                       "; give their folder with --sequence FOLDER"));
  }
}

}  // namespace

RunImages::RunImages(const reports::OverlayRun& run, const std::string& folder)
    : sequence_(OpenImages(run, folder)) {
  const StereoCamera& camera = sequence_.camera;
  if (camera.width_px != run.sequence.camera.width_px ||
      camera.height_px != run.sequence.camera.height_px) {
    ThrowError(sequence_.folder.string(),
               StrCat("images of ", camera.width_px, "x", camera.height_px, " pixels"),
               StrCat(run.sequence.camera.width_px, "x", run.sequence.camera.height_px,
                      ", as the run of ", run.sequence.name, " had"));
  }
}

cv::Mat RunImages::Left(int frame) const {
  const auto index = static_cast<std::size_t>(frame - sequence_.first_frame);
  return LoadFrameImage(sequence_, index, 0).grey;
}

std::optional<Sequence> FindDetections(const std::string& folder, const reports::OverlayRun& run) {
  for (const BoxSources& source : SourcesOf(run.detail.timing.paths)) {
    SequenceRequest request = RequestOf(run, folder);
    request.detections_file = source.detections;
    request.detections_camera = source.detections_camera;
    request.min_score = source.min_score;
    request.labels_file = source.labels;
    try {
      Sequence sequence = OpenSequence(request);
      if (DetectionsHash(sequence) == run.sequence.detections_hash) return sequence;
    } catch (const Error&) {  // the folder lacks this level, or files have moved
    }
  }
  return std::nullopt;
}

std::vector<std::vector<Detection>> DetectionsOf(const Sequence& sequence,
                                                 const std::vector<std::string>& classes) {
  std::vector<std::vector<Detection>> detections;
  for (const std::vector<ObjectBox>& boxes : DetectionsByFrame(sequence)) {
    DetectionCounts counts;
    detections.push_back(DetectionsOfFrame(boxes, {sequence.camera, 0.0}, {}, classes, counts));
  }
  return detections;
}

bool AddDetections(const std::string& folder, reports::OverlayRun& run) {
  const std::optional<Sequence> sequence = FindDetections(folder, run);
  if (!sequence) return false;
  const auto frames = DetectionsOf(*sequence, run.classes);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const Detection& detection : frames[i]) {
      const ImageBox& box = detection.box;
      run.detections[sequence->first_frame + static_cast<int>(i)].push_back(
          {box.left_px, box.top_px, box.right_px, box.bottom_px});
    }
  }
  return true;
}

}  // namespace cvo
