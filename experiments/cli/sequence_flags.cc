// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/sequence_flags.h"

#include "experiments/datasets/frame_range.h"

namespace cvo {

void SequenceFlags::AddTo(CLI::App& app) {
  app.add_option(
         "SEQUENCE", folder,
         "folder of a KITTI raw drive (synced and rectified), a KITTI odometry sequence, or "
         "<training>/<number> of KITTI tracking")
      ->required();
  app.add_option("--type", type,
                 "kitti-raw, kitti-odometry or kitti-tracking; default: as the "
                 "folder looks");
  app.add_option("--pair", pair, "images to read: grey or colour; default: grey where there is");
  app.add_option("--groundtruth", groundtruth,
                 "KITTI raw: devkit (OxTS packets as they stand) or interpolated (OxTS at the "
                 "image's time)")
      ->capture_default_str();
  app.add_option("--frames", frames, "A:B reads frames A to B-1, counted from 0; default: all");
  app.add_option("--labels", labels, "KITTI label file in place of the folder's own");
  app.add_option("--labels-camera", labels_camera,
                 "number X of the image_0X the labels were drawn in; default: 2, or the left image "
                 "for KITTI odometry");
  app.add_option("--detections", detections, "file of 2D boxes in KITTI format");
  app.add_option("--detections-camera", detections_camera,
                 "number X of the image_0X the boxes were detected in; default: the left image");
  app.add_option("--min-score", min_score,
                 "leave out detections with a lower score; default: none");
}

SequenceRequest SequenceFlags::Request() const {
  SequenceRequest request;
  request.folder = folder;
  request.type = type;
  request.pair = pair;
  request.groundtruth = groundtruth;
  if (!frames.empty()) {
    const FrameRange range = ParseFrameRange(frames);
    request.begin_frame = range.begin;
    request.end_frame = range.end;
  }
  request.labels_file = labels;
  request.labels_camera = labels_camera;
  request.detections_file = detections;
  request.detections_camera = detections_camera;
  request.min_score = min_score;
  return request;
}

}  // namespace cvo
