// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/sequence_parts.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "experiments/datasets/frame_range.h"
#include "experiments/datasets/image_files.h"
#include "experiments/datasets/object_boxes.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

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
  // Centres nearer than this are those of boxes around the camera's own place.
  constexpr double kMinDepth_m = 1.0;
  for (ObjectBox& box : labels) {
    if (!box.box3d) continue;
    box = ShiftBox(box, offset_m, fx, std::max(box.box3d->bottom_in_camera.z(), kMinDepth_m));
  }
}

// Without what a detector could not know, and where the labels are already: in the left image read.
void UseLabelsAsDetections(double min_score, Sequence& sequence) {
  if (sequence.labels.empty()) {
    ThrowError("option --detections", "\"labels\", but the sequence has none",
               "a sequence with labels, or --labels FILE");
  }
  if (min_score > SequenceRequest().min_score) {
    ThrowError("option --min-score", "a lowest score for labels", "a file of boxes with scores");
  }
  for (const ObjectBox& label : sequence.labels) {
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

void DropLowScores(const fs::path& file, double min_score, std::vector<ObjectBox>& boxes) {
  if (min_score <= SequenceRequest().min_score) return;
  for (const ObjectBox& box : boxes) {
    if (!box.score) {
      ThrowError(file.string(), "boxes without scores", "scores, as a lowest score is asked for");
    }
  }
  std::erase_if(boxes, [&](const ObjectBox& box) { return *box.score < min_score; });
}

}  // namespace

CameraPair ChoosePair(const SequenceRequest& request, const std::vector<CameraPair>& pairs) {
  if (!request.pair.empty()) {
    std::string names;
    for (const CameraPair& pair : pairs) {
      if (pair.name == request.pair) return pair;
      names += (names.empty() ? "" : " or ") + pair.name;
    }
    ThrowError("option --pair", "\"" + request.pair + "\"", names + " for this type of sequence");
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
  sequence.total_frames = static_cast<int>(sequence.images.size());
  sequence.camera = rig.Stereo(pair.left, pair.right, images.width_px, images.height_px);
  sequence.camera.Check();
  sequence.left_offset_m = rig.Offset_m(pair.left);
}

void AddTimes(const fs::path& file, std::vector<std::int64_t> times_ns, Sequence& sequence) {
  if (times_ns.size() != sequence.images.size()) {
    ThrowError(file.string(), StrCat(times_ns.size(), " times"),
               StrCat(sequence.images.size(), ", as many as images"));
  }
  sequence.timestamps_ns = std::move(times_ns);
  sequence.text_files.push_back(file);
}

void AddOxtsTruth(const std::vector<std::optional<RigidTransform>>& imu_poses,
                  const RigidTransform& camera0_from_imu, Sequence& sequence) {
  const RigidTransform left_from_camera0(Eigen::Quaterniond::Identity(),
                                         Eigen::Vector3d(sequence.left_offset_m, 0.0, 0.0));
  const RigidTransform left_from_imu = left_from_camera0 * camera0_from_imu;
  const RigidTransform imu_from_left = left_from_imu.Inverse();
  sequence.groundtruth_world_from_camera.clear();
  for (const std::optional<RigidTransform>& pose : imu_poses) {
    sequence.groundtruth_world_from_camera.push_back(
        pose ? std::optional(left_from_imu * *pose * imu_from_left) : std::nullopt);
  }
}

void RequireDevkitTruth(const SequenceRequest& request, const std::string& reason) {
  if (request.groundtruth == "devkit") return;
  ThrowError("option --groundtruth", "\"" + request.groundtruth + "\"", "devkit: " + reason);
}

void AddBoxes(const SequenceRequest& request, const LabelSource& own_labels, const CameraRig& rig,
              int left_camera, Sequence& sequence) {
  CheckCamera("option --labels-camera", request.labels_camera);
  CheckCamera("option --detections-camera", request.detections_camera);
  const fs::path labels_file = request.labels_file.empty() ? own_labels.file : request.labels_file;
  if (!labels_file.empty()) {
    const int camera = request.labels_camera == -1 ? own_labels.camera : request.labels_camera;
    sequence.labels = ReadLabels(labels_file, sequence.total_frames);
    MoveLabels(rig.Offset_m(camera) - rig.Offset_m(left_camera), sequence.camera.fx,
               sequence.labels);
    sequence.text_files.push_back(labels_file);
  }
  if (request.detections_file == kDetectionsFromLabels) {
    UseLabelsAsDetections(request.min_score, sequence);
  } else if (!request.detections_file.empty()) {
    const int camera = request.detections_camera == -1 ? left_camera : request.detections_camera;
    sequence.detections = ReadDetections(request.detections_file, sequence.total_frames);
    DropLowScores(request.detections_file, request.min_score, sequence.detections);
    sequence.detections_offset_m = rig.Offset_m(camera) - rig.Offset_m(left_camera);
    sequence.text_files.push_back(request.detections_file);
  }
}

void CutFrames(const SequenceRequest& request, Sequence& sequence) {
  const FrameRange range =
      ResolveFrameRange({request.begin_frame, request.end_frame}, sequence.total_frames);
  sequence.first_frame = range.begin;
  Cut(range, sequence.images);
  Cut(range, sequence.timestamps_ns);
  Cut(range, sequence.groundtruth_world_from_camera);
  CutBoxes(range, sequence.labels);
  CutBoxes(range, sequence.detections);
}

}  // namespace cvo
