// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// KITTI tracking: <training>/{image_02,image_03}/<number>/ and one file per sequence in
// <training>/{calib,oxts,label_02}/<number>.txt. A sequence is addressed as <training>/<number> or
// <training>/image_02/<number>.

#include "core/base/error.h"
#include "experiments/datasets/formats/oxts.h"
#include "experiments/datasets/formats/timestamps.h"
#include "experiments/datasets/sequence_layout.h"
#include "experiments/datasets/sequence_parts.h"
#include "experiments/datasets/sequence_type.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Returns "tracking_0005", or "tracking_testing_0005" for the test set, which uses the same
// numbers.
std::string SequenceName(const fs::path& set_folder, const std::string& number) {
  return (set_folder.filename() == "testing" ? "tracking_testing_" : "tracking_") + number;
}

RigidTransform ReadCamera0FromImu(const CalibrationFile& file) {
  const RigidTransform rectification(file.Rotation(file.FirstOf({"R0_rect", "R_rect"})),
                                     Eigen::Vector3d::Zero());
  return rectification * file.Transform(file.FirstOf({"Tr_velo_to_cam", "Tr_velo_cam"})) *
         file.Transform(file.FirstOf({"Tr_imu_to_velo", "Tr_imu_velo"}));
}

void AddTruth(const fs::path& oxts_file, const CalibrationFile& calibration, Sequence& sequence) {
  if (!fs::exists(oxts_file)) {
    sequence.missing.push_back(oxts_file.string() + ": no ground truth of the camera");
    return;
  }
  const std::vector<RigidTransform> poses = ImuPoses(ReadOxtsPackets(oxts_file));
  if (poses.size() != sequence.images.size()) {
    ThrowError(oxts_file.string(), StrCat(poses.size(), " packets"),
               StrCat(sequence.images.size(), ", as many as images"));
  }
  sequence.other_files.push_back(oxts_file);
  AddOxtsTruth({poses.begin(), poses.end()}, ReadCamera0FromImu(calibration), sequence);
  sequence.groundtruth = "devkit";
}

// Returns the folder of the set, for <training>/<number> as well as <training>/image_02/<number>.
fs::path SetFolder(const fs::path& folder) {
  const fs::path parent = folder.parent_path();
  return parent.filename().string().starts_with("image_0") ? parent.parent_path() : parent;
}

bool TrackingHasImages(const fs::path& folder) {
  const fs::path set_folder = SetFolder(folder);
  return AreFolders(set_folder / "image_02" / folder.filename(),
                    set_folder / "image_03" / folder.filename());
}

bool KnowsTracking(const fs::path& folder) {
  const std::string number = folder.filename().string();
  if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) return false;
  const fs::path set_folder = SetFolder(folder);
  return IsTrackingSet(set_folder) && (IsFolder(set_folder / "image_02" / number) ||
                                       fs::exists(set_folder / "calib" / (number + ".txt")));
}

Sequence ReadKittiTracking(const SequenceRequest& request) {
  RequireDevkitTruth(request, "KITTI tracking has no timestamps to interpolate at");
  const std::string number = request.folder.filename().string();
  const fs::path set_folder = SetFolder(request.folder);
  Sequence sequence;
  sequence.folder = set_folder / number;
  sequence.name = SequenceName(set_folder, number);
  const CameraPair pair = ChoosePair(request, {{"colour", 2, 3, set_folder / "image_02" / number,
                                                set_folder / "image_03" / number}});

  const CalibrationFile calibration(set_folder / "calib" / (number + ".txt"));
  const CameraRig rig(calibration, "P");
  sequence.other_files.push_back(calibration.path());
  AddImages(pair, rig, sequence);
  sequence.timestamps_ns = NominalTimes(sequence.images.size());
  sequence.is_rate_assumed = true;
  AddTruth(set_folder / "oxts" / (number + ".txt"), calibration, sequence);

  LabelSource labels = {set_folder / "label_02" / (number + ".txt"), 2};
  if (!fs::exists(labels.file)) {
    if (request.labels_file.empty())
      sequence.missing.push_back(labels.file.string() + ": no labels");
    labels.file.clear();
  }
  AddBoxes(request, labels, rig, pair.left, sequence);
  return sequence;
}

}  // namespace

SequenceLayout KittiTrackingLayout() {
  return {"kitti-tracking", "<training>/<number>", KnowsTracking, TrackingHasImages,
          ReadKittiTracking};
}

}  // namespace cvo
