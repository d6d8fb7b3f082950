// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/reports/run_images.h"

#include <array>
#include <optional>

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
  request.folder = folder.empty() ? run.detail.sequence_folder : folder;
  request.type = run.sequence.type;
  request.pair = run.sequence.pair;
  if (run.sequence.layout) request.layout = *run.sequence.layout;
  request.begin_frame = run.sequence.first_frame;
  request.end_frame = run.sequence.first_frame + run.sequence.frames;
  return request;
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

bool AdoptDetections(const std::string& folder, reports::OverlayRun& run) {
  for (const char* name : kDetections) {
    SequenceRequest request = RequestOf(run, folder);
    request.detections_file = name;
    std::optional<Sequence> sequence;
    try {
      sequence = OpenSequence(request);
    } catch (const Error&) {
      continue;  // a folder without this level
    }
    // Boxes of another camera were moved by what the run saw in them.
    if (DetectionsHash(*sequence) != run.sequence.detections_hash ||
        sequence->detections_offset_m != 0.0) {
      continue;
    }
    run.detections.clear();
    const auto frames = DetectionsByFrame(*sequence);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      DetectionCounts counts;
      for (const Detection& detection :
           DetectionsOfFrame(frames[i], {sequence->camera, 0.0}, {}, run.classes, counts)) {
        const ImageBox& box = detection.box;
        run.detections[sequence->first_frame + static_cast<int>(i)].push_back(
            {box.left_px, box.top_px, box.right_px, box.bottom_px});
      }
    }
    return true;
  }
  return false;
}

}  // namespace cvo
