// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/pictures/run_images.h"

#include <array>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "experiments/datasets/load_image.h"
#include "experiments/record/job_identity.h"
#include "experiments/runner/frame_detections.h"

namespace cvo {
namespace {

constexpr std::array<const char*, 4> kDetections = {"good", "oracle", "poor",
                                                    kDetectionsFromLabels};

SequenceRequest RequestOf(const reports::OverlayRun& run, const std::string& folder) {
  SequenceRequest request;
  request.folder = folder.empty() ? run.detail.paths.sequence : folder;
  request.type = run.sequence.type;
  request.pair = run.sequence.pair;
  if (run.sequence.layout) request.layout = *run.sequence.layout;
  request.begin_frame = run.sequence.first_frame;
  request.end_frame = run.sequence.first_frame + run.sequence.frames;
  return request;
}

std::filesystem::path LabelsOf(const reports::OverlayRun& run, const std::filesystem::path& given) {
  return given.empty() ? std::filesystem::path(run.detail.paths.labels.value_or("")) : given;
}

// Candidate sources of the run's boxes: `given` if it names a file, otherwise the file that the run
// says it read, then whatever its folder may contain.
std::vector<BoxSources> SourcesOf(const reports::OverlayRun& run, const BoxSources& given) {
  if (!given.detections.empty()) return {given};
  const reports::RunPaths& paths = run.detail.paths;
  std::vector<BoxSources> sources;
  if (paths.detections) {
    sources.push_back({LabelsOf(run, given.labels), *paths.detections,
                       paths.detections_camera.value_or(given.detections_camera),
                       paths.min_score.value_or(given.min_score)});
  }
  for (const char* name : kDetections) {
    sources.push_back({given.labels, name, given.detections_camera, given.min_score});
  }
  return sources;
}

// Returns the box of a detection, with the cluster that it was associated with, if any.
reports::PixelBox WithCluster(const ImageBox& box,
                              const std::map<int, std::vector<reports::PixelBox>>& associated,
                              int frame) {
  reports::PixelBox drawn{box.left_px, box.top_px, box.right_px, box.bottom_px};
  const auto boxes = associated.find(frame);
  if (boxes == associated.end()) return drawn;
  for (const reports::PixelBox& known : boxes->second) {
    if (known.IsAt(drawn)) drawn.cluster = known.cluster;
  }
  return drawn;
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

std::optional<Sequence> FindDetections(const std::string& folder, const reports::OverlayRun& run,
                                       const BoxSources& given) {
  for (const BoxSources& source : SourcesOf(run, given)) {
    SequenceRequest request = RequestOf(run, folder);
    request.detections_file = source.detections;
    request.detections_camera = source.detections_camera;
    request.min_score = source.min_score;
    request.labels_file = source.labels;
    std::optional<Sequence> sequence;
    try {
      sequence = OpenSequence(request);
    } catch (const Error&) {
      if (!given.detections.empty()) throw;
      continue;  // the folder lacks this level, or files have moved
    }
    if (DetectionsHash(*sequence) == run.sequence.detections_hash) return sequence;
  }
  if (given.detections.empty()) return std::nullopt;
  ThrowError("--detections " + given.detections.string(), "boxes other than those of the run",
             "the run's boxes, with its --detections-camera and --min-score");
}

std::optional<Sequence> FindLabelled(const std::string& folder, const reports::OverlayRun& run,
                                     const std::filesystem::path& labels_file) {
  SequenceRequest request = RequestOf(run, folder);
  if (request.folder.empty()) return std::nullopt;
  request.labels_file = LabelsOf(run, labels_file);
  try {
    return OpenSequence(request);
  } catch (const Error&) {
    return std::nullopt;  // callers that need it report this themselves
  }
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

bool AdoptDetections(const std::optional<Sequence>& sequence, reports::OverlayRun& run) {
  // The run moved boxes of another camera by the depth of the features in them, which is not known
  // here.
  if (!sequence || sequence->detections_offset_m != 0.0) return false;
  const auto associated = std::exchange(run.detections, {});
  const auto frames = DetectionsOf(*sequence, run.classes);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const int frame = sequence->first_frame + static_cast<int>(i);
    for (const Detection& detection : frames[i]) {
      run.detections[frame].push_back(WithCluster(detection.box, associated, frame));
    }
  }
  return true;
}

}  // namespace cvo
