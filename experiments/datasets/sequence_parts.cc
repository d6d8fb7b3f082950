// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/sequence_parts.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/formats/object_boxes.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/sequence.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kTracksOfLabels = "labels:";

template <typename T>
void Cut(const FrameRange& range, std::vector<T>& values) {
  values.erase(values.begin() + range.end, values.end());
  values.erase(values.begin(), values.begin() + range.begin);
}

void CutBoxes(const FrameRange& range, std::vector<ObjectBox>& boxes) {
  std::erase_if(boxes, [&](const ObjectBox& box) {
    return box.frame < range.begin || box.frame >= range.end;
  });
}

void CheckCamera(const char* option, int camera) {
  if (camera < -1 || camera > 3) {
    ThrowError(option, StrCat("camera ", camera), "camera 0, 1, 2 or 3");
  }
}

void MoveLabels(double offset_m, double fx, std::vector<ObjectBox>& labels) {
  // Boxes with a nearer centre surround the camera itself.
  constexpr double kMinDepth_m = 1.0;
  for (ObjectBox& box : labels) {
    if (!box.box3d) continue;
    box = ShiftBox(box, offset_m, fx, std::max(box.box3d->bottom_in_camera.z(), kMinDepth_m));
  }
}

struct TrackRange {
  // By default also includes boxes without a track, whose id is negative.
  int first = std::numeric_limits<int>::min();
  int last = std::numeric_limits<int>::max();
};

// Parses "labels" and "labels:FIRST-LAST".
TrackRange TracksOf(const std::string& detections) {
  TrackRange range;
  if (detections == kDetectionsFromLabels) return range;
  const std::string_view ids = std::string_view(detections).substr(kTracksOfLabels.size());
  const char* const end = ids.data() + ids.size();
  const auto first = std::from_chars(ids.data(), end, range.first);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == '-') {
    const auto last = std::from_chars(first.ptr + 1, end, range.last);
    if (last.ec == std::errc() && last.ptr == end && range.first <= range.last) return range;
  }
  ThrowError("option --detections", Quoted(detections),
             "labels, or labels:FIRST-LAST with the ids of tracks, as labels:0-5");
}

// Copies only what a detector could know. The labels are in pixels of the left image read already.
void UseLabelsAsDetections(const std::string& detections, double min_score, Sequence& sequence) {
  const TrackRange tracks = TracksOf(detections);
  if (sequence.labels.empty()) {
    ThrowError("option --detections", "\"labels\", but the sequence has none",
               "a sequence with labels, or --labels FILE");
  }
  if (min_score > SequenceRequest().min_score) {
    ThrowError("option --min-score", "a lowest score for labels", "a file of boxes with scores");
  }
  for (const ObjectBox& label : sequence.labels) {
    if (label.track < tracks.first || label.track > tracks.last) continue;
    ObjectBox box;
    box.frame = label.frame;
    box.type = label.type;
    box.left_px = label.left_px;
    box.top_px = label.top_px;
    box.right_px = label.right_px;
    box.bottom_px = label.bottom_px;
    sequence.detections.push_back(box);
  }
}

bool IsInImage(const StereoCamera& camera, const Eigen::Vector3d& p_in_camera) {
  const auto z_px = camera.Project(p_in_camera);
  return z_px && z_px->x() >= 0.0 && z_px->y() >= 0.0 && z_px->x() <= camera.width_px - 1 &&
         z_px->y() <= camera.height_px - 1;
}

RigidTransform LeftFromRectified(const Sequence& sequence) {
  if (!sequence.rectification) return {};
  const Eigen::Matrix3d turn = sequence.rectification->rectified_from_left();
  return {Eigen::Matrix3d(turn.transpose()), Eigen::Vector3d::Zero()};
}

void MoveBody(const RigidTransform& first_from_world, const Sequence& sequence, TruthBody& body) {
  const bool by_centre =
      sequence.bodies->objects.contract.visible->by == reports::VisibleBy::kCentre;
  for (std::size_t i = 0; i < body.frames.size(); ++i) {
    if (!body.frames[i]) continue;
    BodyFrame& frame = *body.frames[i];
    frame.world_from_object = first_from_world * frame.world_from_object;
    const auto& world_from_camera = sequence.groundtruth_world_from_camera.at(i);
    if (!by_centre) continue;
    const Eigen::Vector3d centre = frame.world_from_object.translation();
    frame.visible =
        world_from_camera && IsInImage(sequence.camera, world_from_camera->Inverse() * centre);
  }
}

void DropLowScores(const fs::path& file, double min_score, Sequence& sequence) {
  if (min_score <= SequenceRequest().min_score) return;
  for (const ObjectBox& box : sequence.detections) {
    if (!box.score) {
      ThrowError(file.string(), "boxes without scores", "scores, as a lowest score is asked for");
    }
  }
  sequence.low_scores = static_cast<int>(std::erase_if(
      sequence.detections, [&](const ObjectBox& box) { return *box.score < min_score; }));
}

// `offset_m` is Sequence::detections_offset_m of boxes in a file.
void AddDetections(const SequenceRequest& request, double offset_m, Sequence& sequence) {
  if (AreFromLabels(request.detections_file)) {
    UseLabelsAsDetections(request.detections_file, request.min_score, sequence);
  } else if (!request.detections_file.empty()) {
    sequence.detections = ReadDetections(request.detections_file, sequence.total_frames);
    DropLowScores(request.detections_file, request.min_score, sequence);
    sequence.detections_offset_m = offset_m;
    sequence.other_files.push_back(request.detections_file);
  }
}

[[noreturn]] void FailPair(const std::string& found, const std::vector<std::string>& known) {
  ThrowError("option --pair", Quoted(found) + DidYouMean(found, known),
             Joined(known, " or ") + " for this type of sequence");
}

}  // namespace

bool AreFromLabels(const std::string& detections) {
  return detections == kDetectionsFromLabels || detections.starts_with(kTracksOfLabels);
}

CameraPair ChoosePair(const SequenceRequest& request, const std::vector<CameraPair>& pairs) {
  if (!request.pair.empty()) {
    std::vector<std::string> names;
    for (const CameraPair& pair : pairs) {
      if (pair.name == request.pair) return pair;
      names.push_back(pair.name);
    }
    FailPair(request.pair, names);
  }
  for (const CameraPair& pair : pairs) {
    if (fs::is_directory(pair.left_folder) && fs::is_directory(pair.right_folder)) return pair;
  }
  for (const CameraPair& pair : pairs) {
    if (fs::is_directory(pair.left_folder) || fs::is_directory(pair.right_folder)) return pair;
  }
  return pairs.front();
}

void AddImages(const CameraPair& pair, const CameraRig& rig, Sequence& sequence) {
  StereoImages images = ListStereoImages(pair.left_folder, pair.right_folder);
  sequence.pair = pair.name;
  sequence.images = std::move(images.paths);
  sequence.first_frame = images.first;
  sequence.total_frames = images.first + static_cast<int>(sequence.images.size());
  sequence.camera = rig.Stereo(pair.left, pair.right, images.width_px, images.height_px);
  sequence.camera.Check();
  sequence.left_offset_m = rig.Offset_m(pair.left);
}

void FailTooFew(const fs::path& file, const std::string& found, const Sequence& sequence) {
  ThrowError(file.string(), found,
             StrCat(sequence.images.size(), ", as many as images, or at least ",
                    sequence.first_frame + sequence.images.size(), ", those of all frames"));
}

void AddTimes(const fs::path& file, std::vector<std::int64_t> times_ns, Sequence& sequence) {
  auto of_images = OfImages(times_ns, file.string() + ": times", sequence);
  if (!of_images) FailTooFew(file, StrCat(times_ns.size(), " times"), sequence);
  sequence.timestamps_ns = std::move(*of_images);
  sequence.other_files.push_back(file);
}

std::vector<std::optional<RigidTransform>> CameraPoses(
    const std::vector<std::optional<RigidTransform>>& imu_poses,
    const RigidTransform& camera0_from_imu, const Sequence& sequence) {
  const RigidTransform left_from_camera0(Eigen::Quaterniond::Identity(),
                                         Eigen::Vector3d(sequence.left_offset_m, 0.0, 0.0));
  const RigidTransform left_from_imu = left_from_camera0 * camera0_from_imu;
  const RigidTransform imu_from_left = left_from_imu.Inverse();
  std::vector<std::optional<RigidTransform>> poses;
  for (const std::optional<RigidTransform>& pose : imu_poses) {
    poses.push_back(pose ? std::optional(left_from_imu * *pose * imu_from_left) : std::nullopt);
  }
  return poses;
}

void AddBoxes(const SequenceRequest& request, Sequence& sequence) {
  for (const int camera : {request.labels_camera, request.detections_camera}) {
    if (camera == -1) continue;
    ThrowError(
        camera == request.labels_camera ? "option --labels-camera" : "option --detections-camera",
        StrCat("camera ", camera), "none: this data set has one pair of cameras");
  }
  if (!request.labels_file.empty()) {
    sequence.labels = ReadLabels(request.labels_file, sequence.total_frames);
    sequence.other_files.push_back(request.labels_file);
  }
  AddDetections(request, 0.0, sequence);
}

void AddPair(const SequenceRequest& request, const std::string& pair, StereoImages images,
             Sequence& sequence) {
  if (!request.pair.empty() && request.pair != pair) {
    FailPair(request.pair, {pair});
  }
  if (images.first != 0) {
    ThrowError(images.paths[0].left.string(), StrCat("a first image with number ", images.first),
               "images from number 0 on");
  }
  sequence.pair = pair;
  sequence.images = std::move(images.paths);
  sequence.total_frames = static_cast<int>(sequence.images.size());
  sequence.camera.width_px = images.width_px;
  sequence.camera.height_px = images.height_px;
}

void AddRig(const StereoRig& rig, const fs::path& calibration, Sequence& sequence) {
  const cv::Size size(sequence.camera.width_px, sequence.camera.height_px);
  CheckSize(rig, size.width, size.height, calibration.string());
  sequence.other_files.push_back(calibration);
  if (IsRectified(rig)) {
    sequence.camera = CameraOf(rig, size.width, size.height);
  } else {
    sequence.rectification = std::make_shared<const Rectification>(rig, size);
    sequence.camera = sequence.rectification->camera();
  }
  sequence.camera.Check();
}

void AddCameraTruth(std::vector<std::optional<RigidTransform>> world_from_left,
                    Sequence& sequence) {
  const RigidTransform left_from_rectified = LeftFromRectified(sequence);
  std::optional<RigidTransform> first_from_world;
  for (std::optional<RigidTransform>& pose : world_from_left) {
    if (!pose) continue;
    *pose = *pose * left_from_rectified;
    if (!first_from_world) first_from_world = pose->Inverse();
    *pose = *first_from_world * *pose;
  }
  sequence.groundtruth_world_from_camera = std::move(world_from_left);
  if (!first_from_world) {
    sequence.bodies.reset();  // it is unknown from where they are seen
    return;
  }
  sequence.groundtruth = "official";
  if (!sequence.bodies) return;
  for (TruthBody& body : sequence.bodies->objects.bodies)
    MoveBody(*first_from_world, sequence, body);
}

void AddCameraTruth(const Trajectory& world_from_carrier, const RigidTransform& carrier_from_left,
                    const std::string& reason, Sequence& sequence) {
  constexpr std::int64_t kLongestGap_ns = 500'000'000;
  std::vector<std::optional<RigidTransform>> poses;
  for (const std::int64_t time_ns : sequence.timestamps_ns) {
    std::optional<RigidTransform> pose = InterpolatePose(world_from_carrier, time_ns);
    const auto after =
        std::ranges::lower_bound(world_from_carrier, time_ns, {}, &TimedPose::timestamp_ns);
    if (pose && after->timestamp_ns != time_ns &&
        after->timestamp_ns - (after - 1)->timestamp_ns > kLongestGap_ns) {
      pose.reset();
    }
    if (pose) *pose = *pose * carrier_from_left;
    poses.push_back(pose);
  }
  AddCameraTruth(std::move(poses), sequence);
  const auto& truth = sequence.groundtruth_world_from_camera;
  const auto without = std::ranges::count_if(truth, [](const auto& pose) { return !pose; });
  if (without > 0) {
    sequence.missing.push_back(StrCat("no ground truth of the camera for ", without, " of ",
                                      truth.size(), " frames: ", reason));
  }
  for (const TimedPose& pose : world_from_carrier) {
    sequence.truth_track.push_back({pose.timestamp_ns, pose.world_from_camera * carrier_from_left *
                                                           LeftFromRectified(sequence)});
  }
}

void AddBoxes(const SequenceRequest& request, const LabelSource& own_labels, const CameraRig& rig,
              int left_camera, Sequence& sequence) {
  CheckCamera("option --labels-camera", request.labels_camera);
  CheckCamera("option --detections-camera", request.detections_camera);
  const fs::path labels_file = request.labels_file.empty() ? own_labels.file : request.labels_file;
  if (!labels_file.empty()) {
    const int camera = request.labels_camera == -1 ? own_labels.camera : request.labels_camera;
    const int most = std::numeric_limits<int>::max();  // the data set's are of all frames
    sequence.labels =
        ReadLabels(labels_file, request.labels_file.empty() ? most : sequence.total_frames);
    const auto last = std::ranges::max_element(sequence.labels, {}, &ObjectBox::frame);
    if (last != sequence.labels.end() && last->frame >= sequence.total_frames) {
      sequence.notes.push_back(StrCat(labels_file.string(), ": labels up to frame ", last->frame,
                                      ", images up to ", sequence.total_frames - 1));
    }
    MoveLabels(rig.Offset_m(camera) - rig.Offset_m(left_camera), sequence.camera.fx,
               sequence.labels);
    sequence.other_files.push_back(labels_file);
  }
  const int camera = request.detections_camera == -1 ? left_camera : request.detections_camera;
  AddDetections(request, rig.Offset_m(camera) - rig.Offset_m(left_camera), sequence);
}

void CutFrames(const SequenceRequest& request, Sequence& sequence) {
  const int first = sequence.first_frame;  // of the images there are
  const FrameRange range =
      ResolveFrameRange({std::max(request.begin_frame, first), request.end_frame},
                        first + static_cast<int>(sequence.images.size()));
  sequence.first_frame = range.begin;
  const FrameRange of_images = {range.begin - first, range.end - first};
  Cut(of_images, sequence.images);
  Cut(of_images, sequence.timestamps_ns);
  Cut(of_images, sequence.groundtruth_world_from_camera);
  if (!sequence.velocity_world_from_camera.empty()) {
    Cut(of_images, sequence.velocity_world_from_camera);
  }
  CutBoxes(range, sequence.labels);
  CutBoxes(range, sequence.detections);
}

}  // namespace cvo
