// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/sequence_flags.h"

#include "experiments/cli/command.h"
#include "experiments/datasets/frame_range.h"

namespace cvo {

void SequenceFlags::AddTruthTo(CLI::App& app) {
  const auto add = [&app](const char* flag, auto& value, const char* kind, const char* meaning) {
    return app.add_option(flag, value, meaning)->type_name(kind);
  };
  add("--type", type, "NAME",
      "kitti-raw, kitti-odometry or kitti-tracking; default: detected from the folder's contents");
  add("--dataset", dataset, "NAME",
      "recorded data set, kitti or other, which selects the known corrections; default: kitti if "
      "the calibration is KITTI's");
  add("--pair", pair, "NAME",
      "images to read, grey or colour; default: grey if present, else colour");
  add("--frames", frames, "A:B", "frames A to B-1, counted from 0; default: all");
  add("--labels", labels, "FILE", "KITTI label file to use instead of the folder's own");
  add("--labels-camera", labels_camera, "X",
      "camera (image_0X) in which the labels were drawn; default: 2, for KITTI odometry the left "
      "camera in use");
}

void SequenceFlags::AddTo(CLI::App& app) {
  app.add_option(
         "SEQUENCE", folder,
         "folder of a KITTI raw drive (synced and rectified), of a KITTI odometry sequence, "
         "or <training>/<number> of KITTI tracking")
      ->type_name("")
      ->required();
  const auto add = [&app](const char* flag, auto& value, const char* kind, const char* meaning) {
    return app.add_option(flag, value, meaning)->type_name(kind);
  };
  AddTruthTo(app);
  add("--groundtruth", groundtruth, "NAME",
      "KITTI raw: devkit (OxTS packets as recorded) or interpolated (OxTS interpolated to image "
      "times)")
      ->capture_default_str();
  add("--detections", detections, "FILE|labels|none",
      "source of 2D boxes: a file in KITTI format (track ids are ignored), a detector level of a "
      "synthetic scene (oracle, good, poor), the 2D boxes of the labels, or none");
  add("--detections-camera", detections_camera, "X",
      "camera (image_0X) in which the boxes were detected; default: the left camera in use");
  AddRightShift(app, right_shift_px);
  add("--min-score", min_score, "SCORE", "minimum score of a detection; default: none")
      ->check(FiniteProblem);
}

void AddRightShift(CLI::App& app, std::optional<double>& right_shift_px) {
  app.add_option("--right-shift", right_shift_px,
                 "rectification error: offset of u_right to the right; default: 0.16 for KITTI's "
                 "grey images, else 0")
      ->type_name("PX")
      ->check(FiniteProblem);
}

SequenceRequest SequenceFlags::Request() const {
  SequenceRequest request;
  request.folder = folder;
  request.type = type;
  request.dataset = dataset;
  request.pair = pair;
  request.groundtruth = groundtruth;
  if (!frames.empty()) {
    const FrameRange range = ParseFrameRange(frames);
    request.begin_frame = range.begin;
    request.end_frame = range.end;
  }
  request.labels_file = labels;
  request.labels_camera = labels_camera;
  if (detections != "none") request.detections_file = detections;
  request.detections_camera = detections_camera;
  request.min_score = min_score;
  request.right_shift_px = right_shift_px;
  return request;
}

}  // namespace cvo
