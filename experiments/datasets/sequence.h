// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "experiments/calibration/rectification.h"
#include "experiments/datasets/formats/object_boxes.h"
#include "experiments/datasets/perturbation.h"
#include "experiments/metrics/objects/object_truth.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {

struct StereoPaths {
  std::filesystem::path left;
  std::filesystem::path right;
};

// A body whose poses a data set states.
struct BodyTrack {
  int id = 0;      // 1, 2, ...
  int track = -1;  // its number in the labels; -1: none
  std::string name;
  std::string category;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // of a box around its origin, along its axes
  std::vector<std::optional<BodyFrame>> frames;      // of the folder
};

// A pixel of the left image that is known to show a body, or 0, the static scene.
struct LabelledPixel {
  Eigen::Vector2d at_px;
  int body = 0;
};

// All bodies of a sequence, in the world of the camera's truth, and what tells which of them a
// pixel shows: a mask, labelled pixels, or nothing. Frames are those of the folder.
struct BodyTracks {
  reports::TruthSource truth = reports::TruthSource::kOfficial;
  reports::Visibility visible;
  double mover_travel_m = 0.2;
  std::vector<BodyTrack> bodies;           // by id
  std::function<cv::Mat(int frame)> mask;  // CV_16UC1 of ids, 0 the static scene; may be empty
  std::vector<std::vector<LabelledPixel>> pixels;  // [frame]; may be empty
};

// Where labels and detections were asked for from (SequenceRequest).
struct BoxSources {
  std::filesystem::path labels;
  std::filesystem::path detections;
  int detections_camera = -1;
  double min_score = -1e300;
};

// A stereo sequence on disk, its images still undecoded. All vectors over frames have the same
// length and start at `first_frame` of the folder.
struct Sequence {
  std::string name;     // "2011_09_26_drive_0001", "odometry_06", "tracking_0005"
  std::string type;     // "kitti-raw", "euroc", ...: the layout
  std::string dataset;  // whose recording it is: "kitti" or "other"
  std::filesystem::path folder;
  std::string pair;  // "grey" or "colour"
  int first_frame = 0;
  int total_frames = 0;  // in the folder, before --frames
  StereoCamera camera;   // left camera of the pair that is read
  // Makes the images of `camera` from those in the files; null: they are that already.
  std::shared_ptr<const Rectification> rectification;
  std::vector<StereoPaths> images;
  std::vector<std::int64_t> timestamps_ns;  // strictly increasing
  bool is_rate_assumed = false;             // no times are stated

  // Ground truth of the left camera of the pair; empty where a frame has none.
  std::string groundtruth;  // "devkit", "interpolated", "official" or "none"
  std::vector<std::optional<RigidTransform>> groundtruth_world_from_camera;
  // The same at times of its own in the images' clock, of the whole recording and in another world;
  // empty where the data set states it frame by frame.
  Trajectory truth_track;

  // A point seen from the left camera read is p_in_camera0 + (left_offset_m, 0, 0).
  double left_offset_m = 0.0;
  // In pixels of the left image read: labels with a 3D box were moved there by their own depth;
  // those without (DontCare) stay in pixels of the image they were drawn in.
  std::vector<ObjectBox> labels;
  // In pixels of the image they were detected in, where a point seen from the left camera read is
  // at p_in_camera + (detections_offset_m, 0, 0): see ShiftBox.
  std::vector<ObjectBox> detections;
  double detections_offset_m = 0.0;
  BoxSources box_sources;
  int low_scores = 0;  // boxes left out: below BoxSources::min_score
  // Where the data set states poses of bodies itself (not in labels, nor as a rendered scene).
  std::optional<BodyTracks> bodies;
  Json layout = Json::object();  // settings of its layout that were given
  // Text files that determine what was read besides the images (calibration, times, OxTS, labels,
  // detections), in a fixed order: they are part of the sequence's identity.
  std::vector<std::filesystem::path> text_files;
  Perturbation perturbation;         // done to camera and images; pixels as they are decoded
  std::vector<std::string> missing;  // what a complete folder would also hold, one line each
};

// In place of a detections file: the 2D boxes of the labels, without anything else; with
// "labels:FIRST-LAST" those of the tracks with these ids alone.
inline constexpr const char* kDetectionsFromLabels = "labels";
bool AreFromLabels(const std::string& detections);

// What a user asks for; empty means: decide from the folder.
struct SequenceRequest {
  std::filesystem::path folder = {};
  std::string type = {};               // of a SequenceLayout
  std::string dataset = {};            // "", "kitti", "other"
  std::string pair = {};               // "", "grey", "colour"
  std::string groundtruth = "devkit";  // KITTI raw: "devkit" or "interpolated"; others: "devkit"
  int begin_frame = 0;                 // half-open range; end -1: to the last
  int end_frame = -1;
  std::filesystem::path labels_file = {};  // instead of the folder's own
  int labels_camera = -1;                  // -1: image_02; in KITTI odometry the left image read
  std::filesystem::path detections_file = {};  // or a scene's level, "good"; or AreFromLabels
  int detections_camera = -1;  // image_0X the boxes were detected in; -1: the left image read
  double min_score = -1e300;   // detections below are left out
  // Of the camera (StereoCamera); empty: 0, the calibration as published.
  std::optional<double> right_shift_px = {};
  Perturbation perturbation = {};
  Json layout = Json::object();  // SequenceLayout::settings that differ from the default
};

// Reads everything but the images, and checks all of it: image files exist on both sides, in equal
// numbers and with equal sizes (from their headers). Throws Error.
Sequence OpenSequence(const SequenceRequest& request);

// Folders below `root` (or `root` itself) that hold the images of a sequence, sorted by path, with
// their type. KITTI tracking keeps several sequences in one folder: these are named <training
// folder>/<number>.
struct FoundSequence {
  std::filesystem::path folder;
  std::string type;
};
std::vector<FoundSequence> FindSequences(const std::filesystem::path& root);

}  // namespace cvo
