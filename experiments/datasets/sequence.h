// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/options.h"
#include "core/files/json/json.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"
#include "experiments/datasets/calibration/stereo_rig.h"
#include "experiments/datasets/formats/object_boxes.h"
#include "experiments/metrics/objects/object_matching.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {

struct Sequence;

// Degradations of the images and the calibration of a sequence, applied before a run to measure how
// its error depends on them. Random choices are determined by `seed` and the frame's number in its
// folder, so a larger rate drops the same frames and additional ones. The first frame read is
// neither dropped nor replaced.
struct Perturbation {
  double blur_px = 0.0;
  double gain = 1.0;
  double gamma = 1.0;
  double noise = 0.0;
  int jpeg_quality = 100;
  double drop_rate = 0.0;
  double repeat_rate = 0.0;
  int right_late_rows = 0;
  int right_late_frames = 0;
  double focal_error = 0.0;
  double baseline_error = 0.0;
  double disparity_error_px = 0.0;
  std::uint64_t seed = 0;  // not an option: the seed of the job

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    constexpr const char* kNone = "the default changes nothing";
    visit.Field("blur_px", self.blur_px,
                FieldInfo{"px", 0, 20, "std of a Gaussian blur of both images", kNone});
    visit.Field("gain", self.gain, FieldInfo{"1", 0.01, 10, "factor on grey levels", kNone});
    visit.Field("gamma", self.gamma,
                FieldInfo{"1", 0.1, 10, "exponent on grey levels, after the gain", kNone});
    visit.Field("noise", self.noise,
                FieldInfo{"grey level", 0, 100, "std of Gaussian noise per pixel", kNone});
    visit.Field("jpeg_quality", self.jpeg_quality,
                FieldInfo{"1", 1, 100, "compression as JPEG; 100: none", kNone});
    visit.Field("drop_rate", self.drop_rate,
                FieldInfo{"1", 0, 1, "part of the frames whose images are missing", kNone});
    visit.Field("repeat_rate", self.repeat_rate,
                FieldInfo{"1", 0, 1, "part of the frames that show the images before", kNone});
    visit.Field("right_late_rows", self.right_late_rows,
                FieldInfo{"px", -20, 20, "rows by which the right image is lower", kNone});
    visit.Field("right_late_frames", self.right_late_frames,
                FieldInfo{"1", 0, 10, "frames by which the right image is late", kNone});
    visit.Field("focal_error", self.focal_error,
                FieldInfo{"1", -0.5, 0.5, "error of the focal length, part of it", kNone});
    visit.Field("baseline_error", self.baseline_error,
                FieldInfo{"1", -0.5, 0.5, "error of the baseline, part of it", kNone});
    visit.Field("disparity_error_px", self.disparity_error_px,
                FieldInfo{"px", -5, 5, "error of every disparity", kNone});
  }
};

// Returns the options that differ from their defaults, and the seed if there are any. Returns {}
// for no perturbation.
Json PerturbationToJson(const Perturbation& perturbation);
// Parses an object such as {"blur_px": 1.5}. Throws Error naming a key that is unknown or out of
// range.
Perturbation ParsePerturbation(const Json& json, const std::string& where);

// Perturbs the camera and the choice of the image files that frames are read from.
void PerturbSequence(const Perturbation& perturbation, Sequence& sequence);
// Whether the images of this frame are withheld.
bool IsDropped(const Sequence& sequence, std::size_t index);
// Perturbs the pixels of the frame's left (0) or right (1) image.
void PerturbImage(const Sequence& sequence, std::size_t index, int side, cv::Mat& grey);

struct StereoPaths {
  std::filesystem::path left;
  std::filesystem::path right;
};

// A pixel of the left image that is known to show a body, or the static scene (body 0).
struct LabelledPixel {
  Eigen::Vector2d at_px;
  int body = 0;
};

// The bodies of a sequence whose poses are known, in the world of the camera's ground truth, and
// what tells which of them a pixel shows: a mask, labelled pixels, or nothing. Frames are counted
// from the start of the folder. Of the objects, times and poses of the camera are not set.
struct BodyTracks {
  ObjectTruth objects;
  std::function<cv::Mat(int frame)> mask;  // CV_16UC1 of body ids, 0: static scene; may be empty
  std::vector<std::vector<LabelledPixel>> pixels;  // [frame]; may be empty
};

// The requested sources of labels and detections (see SequenceRequest).
struct BoxSources {
  std::filesystem::path labels;
  std::filesystem::path detections;
  int detections_camera = -1;
  double min_score = -1e300;
};

// A stereo sequence on disk, whose images are not yet decoded. All vectors with one element per
// frame have the same length and start at `first_frame` of the folder.
struct Sequence {
  std::string name;     // "2011_09_26_drive_0001", "odometry_06", "tracking_0005"
  std::string type;     // the layout: "kitti-raw", "euroc", ...
  std::string dataset;  // the origin of the recording: "kitti" or "other"
  std::filesystem::path folder;
  std::string pair;  // "grey" or "colour"
  int first_frame = 0;
  int total_frames = 0;  // of the folder, before --frames is applied
  StereoCamera camera;   // left camera of the pair that is read
  // Transforms the images in the files to those of `camera`; null if they are rectified already.
  std::shared_ptr<const Rectification> rectification;
  std::vector<StereoPaths> images;
  std::vector<std::int64_t> timestamps_ns;  // strictly increasing
  bool is_rate_assumed = false;             // the data set states no timestamps

  // Ground truth of the left camera of the pair; empty for frames without ground truth.
  std::string groundtruth;  // "devkit", "official" or "none"
  std::vector<std::optional<RigidTransform>> groundtruth_world_from_camera;
  // The same attitudes, with positions integrated from measured velocities; empty if there are
  // none.
  std::vector<std::optional<RigidTransform>> velocity_world_from_camera;
  // The same ground truth at its own timestamps, in the clock of the images, over the whole
  // recording and in another world. Empty if the data set states it frame by frame.
  Trajectory truth_track;

  // In the frame of the left camera read, a point is at p_in_camera0 + (left_offset_m, 0, 0).
  double left_offset_m = 0.0;
  // In pixels of the left image read. Labels with a 3D box were moved there by the depth of their
  // box; those without (DontCare) stay in pixels of the image they were drawn in.
  std::vector<ObjectBox> labels;
  // In pixels of the image they were detected in. In the frame of that image's camera, a point is
  // at p_in_camera + (detections_offset_m, 0, 0), with p_in_camera in the left camera read: see
  // ShiftBox.
  std::vector<ObjectBox> detections;
  double detections_offset_m = 0.0;
  BoxSources box_sources;
  int low_scores = 0;  // number of boxes dropped: below BoxSources::min_score
  // Set if the data set states poses of bodies itself (neither in labels nor as a rendered scene).
  std::optional<BodyTracks> bodies;
  Json layout = Json::object();  // settings of its layout that were given
  // The files besides the images that determine what was read (calibration, times, OxTS, labels,
  // detections, masks), in a fixed order. They are part of the sequence's identity. Masks of a
  // rendered scene are not among them: its manifest holds their hashes.
  std::vector<std::filesystem::path> other_files;
  Perturbation perturbation;         // applied to the camera and file choice; to pixels on decoding
  std::vector<std::string> notes;    // what was inferred or left out on reading, one line each
  std::vector<std::string> missing;  // what a complete folder would also contain, one line each
};

// Given in place of a detections file, uses the 2D boxes and classes of the labels as detections;
// "labels:FIRST-LAST" uses only those of the tracks with these ids.
inline constexpr const char* kDetectionsFromLabels = "labels";
bool AreFromLabels(const std::string& detections);

// What a user requests. An empty field means that it is decided from the folder.
struct SequenceRequest {
  std::filesystem::path folder = {};
  std::string type = {};  // SequenceLayout::type
  std::string pair = {};  // "", "grey", "colour"
  int begin_frame = 0;    // half-open range; end -1: to the last frame
  int end_frame = -1;
  std::filesystem::path labels_file = {};  // replaces the folder's own file
  int labels_camera = -1;                  // -1: image_02, or in KITTI odometry the left image read
  std::filesystem::path detections_file = {};  // or a level of a scene ("good"), or AreFromLabels
  int detections_camera = -1;  // image_0X the boxes were detected in; -1: the left image read
  double min_score = -1e300;   // detections with a lower score are dropped
  // StereoCamera::right_shift_px. Empty: 0, the calibration as published.
  std::optional<double> right_shift_px = {};
  Perturbation perturbation = {};
  Json layout = Json::object();  // SequenceLayout::settings that differ from their defaults
};

// Reads everything but the images, and checks all of it. The image files must exist on both sides,
// in equal numbers and with equal sizes (from their headers). Throws Error.
Sequence OpenSequence(const SequenceRequest& request);

// FindSequences returns the folders below `root` (or `root` itself) that contain the images of a
// sequence, sorted by path, with their type. KITTI tracking keeps several sequences in one folder;
// these are returned as <training folder>/<number>. Throws Error if `root` does not exist.
struct FoundSequence {
  std::filesystem::path folder;
  std::string type;
};
std::vector<FoundSequence> FindSequences(const std::filesystem::path& root);

// Frames begin, ..., end - 1, counted from zero. An end of -1 means up to the last frame.
struct FrameRange {
  int begin = 0;
  int end = -1;
};

// Parses "A:B", "A:", ":B" or ":". Throws Error for anything else and for empty ranges.
FrameRange ParseFrameRange(std::string_view text);

// Returns the range within a sequence of `total` frames, with its end filled in. Throws Error if
// the range is empty or exceeds the sequence.
FrameRange ResolveFrameRange(const FrameRange& range, int total);

constexpr const char* kKittiOdometry = "kitti-odometry";

// Returns the type of the sequence in a folder, complete or not; "" if there is none.
std::string DetectSequenceType(const std::filesystem::path& folder);

// Whether the folder is a sequence with images of both cameras.
bool HasImages(const std::filesystem::path& folder);

// Does not throw: a folder that cannot be read counts as absent.
bool IsFolder(const std::filesystem::path& path);
// Whether both folders of a pair exist.
bool AreFolders(const std::filesystem::path& left, const std::filesystem::path& right);

// Whether a folder contains several KITTI tracking sequences.
bool IsTrackingSet(const std::filesystem::path& folder);

// Removes ".", ".." and a trailing slash, so that the folder has a name and a parent.
std::filesystem::path NormalFolder(const std::filesystem::path& folder);

}  // namespace cvo
