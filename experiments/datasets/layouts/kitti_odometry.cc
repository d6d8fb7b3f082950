// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// KITTI odometry: <sequences>/<number>/{image_0..3/,times.txt,calib.txt}, poses in
// <sequences>/../poses/<number>.txt or <sequences>/poses/<number>.txt. Our synthetic scenes have
// their poses in poses.txt beside the images, with labels.txt and detections/<level>.txt.

#include "core/base/error.h"
#include "experiments/datasets/formats/timestamps.h"
#include "experiments/datasets/sequence_layout.h"
#include "experiments/datasets/sequence_parts.h"
#include "experiments/datasets/sequence_type.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

fs::path FindPoses(const fs::path& folder) {
  const fs::path parent = folder.parent_path();
  const fs::path below = fs::path("poses") / (folder.filename().string() + ".txt");
  for (const fs::path& file :
       {folder / "poses.txt", parent / below, parent.parent_path() / below}) {
    if (fs::exists(file)) return file;
  }
  return {};
}

// The file contains the poses of camera 0, relative to its first frame.
void AddTruth(Sequence& sequence) {
  const fs::path path = FindPoses(sequence.folder);
  if (path.empty()) {
    sequence.missing.emplace_back("poses: no ground truth of the camera");
    return;
  }
  const std::vector<RigidTransform> poses = ReadKittiPoses(path);
  sequence.other_files.push_back(path);
  const std::size_t frames = sequence.images.size();
  if (poses.size() > frames) {
    ThrowError(StrCat(path.string(), ":", frames + 1), StrCat(poses.size(), " poses"),
               StrCat(frames, ", as many as images"));
  }
  if (poses.size() < frames) {
    sequence.missing.push_back(StrCat(path.string(), ": poses of the last ", frames - poses.size(),
                                      " of ", frames, " frames"));
  }
  std::vector<std::optional<RigidTransform>> truth(poses.begin(), poses.end());
  truth.resize(frames);
  AddOxtsTruth(truth, RigidTransform(), sequence);
  sequence.groundtruth = "official";
}

// Replaces the name of a level of detections by the folder's own file of this level.
SequenceRequest WithLevel(const SequenceRequest& request) {
  SequenceRequest resolved = request;
  const fs::path own = request.folder / "detections" / (request.detections_file.string() + ".txt");
  if (!request.detections_file.empty() && !fs::exists(request.detections_file) &&
      fs::is_regular_file(own)) {
    resolved.detections_file = own;
  }
  return resolved;
}

bool KnowsOdometry(const fs::path& folder) {
  if (fs::exists(folder / "pose_gt.txt")) return false;  // see prepared_multimotion.cc
  return IsFolder(folder / "image_0") || IsFolder(folder / "image_1") ||
         IsFolder(folder / "image_2") || IsFolder(folder / "image_3");
}

bool OdometryHasImages(const fs::path& folder) {
  return AreFolders(folder / "image_0", folder / "image_1") ||
         AreFolders(folder / "image_2", folder / "image_3");
}

Sequence ReadKittiOdometry(const SequenceRequest& request) {
  RequireDevkitTruth(request, "KITTI odometry comes with one set of poses");
  Sequence sequence;
  sequence.folder = request.folder;
  sequence.name = request.folder.filename().string();
  const auto images = [&](const char* image) { return request.folder / image; };
  const CameraPair pair =
      ChoosePair(request, {{"grey", 0, 1, images("image_0"), images("image_1")},
                           {"colour", 2, 3, images("image_2"), images("image_3")}});

  const CalibrationFile calibration(request.folder / "calib.txt");
  const CameraRig rig(calibration, "P");
  sequence.other_files.push_back(calibration.path());
  AddImages(pair, rig, sequence);

  const fs::path times_file = request.folder / "times.txt";
  AddTimes(times_file, ReadSecondsTimes(times_file), sequence);
  AddTruth(sequence);
  const fs::path bodies = request.folder / "objects.csv";
  if (fs::exists(bodies)) sequence.other_files.push_back(bodies);
  const fs::path labels = request.folder / "labels.txt";
  AddBoxes(WithLevel(request),
           {.file = fs::exists(labels) ? labels : fs::path(), .camera = pair.left}, rig, pair.left,
           sequence);
  return sequence;
}

}  // namespace

SequenceLayout KittiOdometryLayout() {
  return {kKittiOdometry, "image_0, times.txt", KnowsOdometry, OdometryHasImages,
          ReadKittiOdometry};
}

}  // namespace cvo
