// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// KITTI odometry: <sequences>/<number>/{image_0..3/,times.txt,calib.txt}, poses in
// <sequences>/../poses/<number>.txt or <sequences>/poses/<number>.txt. Our synthetic scenes have
// their poses in poses.txt beside the images, with labels.txt and detections/<level>.txt.
//
// KITTI raw, synced and rectified: <date>/<drive>_sync/{image_00..03,oxts}/{data/,timestamps.txt}
// and <date>/calib_*.txt.
//
// KITTI tracking: <training>/{image_02,image_03}/<number>/ and one file per sequence in
// <training>/{calib,oxts,label_02}/<number>.txt. A sequence is addressed as <training>/<number> or
// <training>/image_02/<number>.

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/sequence.h"
#include "experiments/datasets/sequence_parts.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

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
void AddOdometryTruth(Sequence& sequence) {
  const fs::path path = FindPoses(sequence.folder);
  if (path.empty()) {
    sequence.missing.emplace_back("poses: no ground truth of the camera");
    return;
  }
  const std::vector<RigidTransform> poses = ReadKittiPoses(path);
  sequence.other_files.push_back(path);
  const std::size_t frames = sequence.images.size();
  const auto of_images = OfImages(poses, path.string() + ": poses", sequence);
  if (poses.empty() || (!of_images && sequence.first_frame > 0)) {
    FailTooFew(path, StrCat(poses.size(), " poses"), sequence);
  }
  if (poses.size() < frames) {
    sequence.missing.push_back(StrCat(path.string(), ": poses of the last ", frames - poses.size(),
                                      " of ", frames, " frames"));
  }
  if (poses.size() + 1 == frames) {
    sequence.notes.push_back(path.string() + ": one pose less than images: is the first missing?");
  }
  const std::vector<RigidTransform>& used = of_images ? *of_images : poses;
  std::vector<std::optional<RigidTransform>> truth(used.begin(), used.end());
  truth.resize(frames);
  sequence.groundtruth_world_from_camera = CameraPoses(truth, RigidTransform(), sequence);
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

// The folders of the images of cameras 0 to 3.
using CameraFolders = std::array<fs::path, 4>;

bool HasAny(const CameraFolders& folders) {
  return std::any_of(folders.begin(), folders.end(), IsFolder);
}

bool HasPair(const CameraFolders& folders) {
  return AreFolders(folders[0], folders[1]) || AreFolders(folders[2], folders[3]);
}

CameraPair ChooseCameras(const SequenceRequest& request, const CameraFolders& folders) {
  return ChoosePair(
      request, {{"grey", 0, 1, folders[0], folders[1]}, {"colour", 2, 3, folders[2], folders[3]}});
}

CameraFolders OdometryFolders(const fs::path& folder) {
  return {folder / "image_0", folder / "image_1", folder / "image_2", folder / "image_3"};
}
bool KnowsOdometry(const fs::path& folder) { return HasAny(OdometryFolders(folder)); }
bool OdometryHasImages(const fs::path& folder) { return HasPair(OdometryFolders(folder)); }

void ReadKittiOdometry(const SequenceRequest& request, Sequence& sequence) {
  const CameraPair pair = ChooseCameras(request, OdometryFolders(request.folder));
  const CalibrationFile calibration(request.folder / "calib.txt");
  const CameraRig rig(calibration, "P");
  sequence.other_files.push_back(calibration.path());
  AddImages(pair, rig, sequence);

  const fs::path times_file = request.folder / "times.txt";
  ImageTimes times = ReadTimes(times_file);
  AddTimes(times_file, std::move(times.ns), sequence);
  if (!times.note.empty()) sequence.notes.push_back(times.note);
  AddOdometryTruth(sequence);
  const fs::path bodies = request.folder / "objects.csv";
  if (fs::exists(bodies)) sequence.other_files.push_back(bodies);
  const fs::path labels = request.folder / "labels.txt";
  AddBoxes(WithLevel(request),
           {.file = fs::exists(labels) ? labels : fs::path(), .camera = pair.left}, rig, pair.left,
           sequence);
}

// Takes packet i as the ground truth of image i, as the devkit does.
void AddOxtsTruth(const std::vector<OxtsPacket>& packets, const RigidTransform& camera0_from_imu,
                  Sequence& sequence) {
  const std::vector<RigidTransform> poses = ImuPoses(packets);
  sequence.groundtruth_world_from_camera =
      CameraPoses({poses.begin(), poses.end()}, camera0_from_imu, sequence);
  sequence.groundtruth = "devkit";
}

std::string DriveName(const fs::path& folder) {
  std::string name = folder.filename().string();
  if (name.ends_with("_extract")) {
    ThrowError(folder.string(), "an unrectified drive (_extract)", "a rectified one (_sync)");
  }
  constexpr std::string_view kSuffix = "_sync";
  if (name.ends_with(kSuffix)) name.resize(name.size() - kSuffix.size());
  return name;
}

void CheckRectifiedSize(const CalibrationFile& file, int camera, const StereoCamera& image) {
  const std::string key = StrCat("S_rect_0", camera);
  if (!file.Has(key)) return;
  const std::vector<double> size = file.Numbers(key, 2);
  if (size[0] == image.width_px && size[1] == image.height_px) return;
  ThrowError(file.Where(key), StrCat(size[0], "x", size[1], " pixels"),
             StrCat(image.width_px, "x", image.height_px, ", the size of the images"));
}

RigidTransform ReadSplitTransform(const fs::path& path) {
  const CalibrationFile file(path);
  const std::vector<double> t = file.Numbers("T", 3);
  return {file.Rotation("R"), Eigen::Vector3d(t[0], t[1], t[2])};
}

RigidTransform ReadCamera0FromImu(const fs::path& date_folder, const CalibrationFile& cameras,
                                  Sequence& sequence) {
  const fs::path velo_to_cam = date_folder / "calib_velo_to_cam.txt";
  const fs::path imu_to_velo = date_folder / "calib_imu_to_velo.txt";
  sequence.other_files.push_back(velo_to_cam);
  sequence.other_files.push_back(imu_to_velo);
  const RigidTransform rectification(cameras.Rotation("R_rect_00"), Eigen::Vector3d::Zero());
  return rectification * ReadSplitTransform(velo_to_cam) * ReadSplitTransform(imu_to_velo);
}

void AddRawTruth(const fs::path& date_folder, const CalibrationFile& cameras, Sequence& sequence) {
  const fs::path folder = sequence.folder / "oxts/data";
  for (const fs::path& needed :
       {folder, date_folder / "calib_velo_to_cam.txt", date_folder / "calib_imu_to_velo.txt"}) {
    std::error_code ignored;
    if (fs::exists(needed) && !fs::is_empty(needed, ignored)) continue;
    sequence.missing.push_back(needed.string() + ": no ground truth of the camera");
    return;
  }
  const std::map<std::int64_t, fs::path> files = NumberedFiles(folder, ".txt");
  std::vector<OxtsPacket> packets;
  for (std::size_t i = 0; i < sequence.images.size(); ++i) {
    const auto file = files.find(sequence.first_frame + static_cast<std::int64_t>(i));
    if (file == files.end()) {
      sequence.missing.push_back(StrCat(folder.string(), ": no packet of frame ",
                                        sequence.first_frame + i, ": no ground truth"));
      return;
    }
    packets.push_back(ReadOxtsPacket(file->second));
    sequence.other_files.push_back(file->second);
  }
  const RigidTransform camera0_from_imu = ReadCamera0FromImu(date_folder, cameras, sequence);
  AddOxtsTruth(packets, camera0_from_imu, sequence);
  const fs::path times_file = folder.parent_path() / "timestamps.txt";
  if (!fs::exists(times_file)) return;
  sequence.other_files.push_back(times_file);
  const auto times_ns = OfImages(ReadDateTimes(times_file), times_file.string(), sequence);
  if (!times_ns) return;
  const std::vector<RigidTransform> poses = ImuPosesByVelocity(packets, *times_ns);
  sequence.velocity_world_from_camera =
      CameraPoses({poses.begin(), poses.end()}, camera0_from_imu, sequence);
}

CameraFolders RawFolders(const fs::path& folder) {
  return {folder / "image_00/data", folder / "image_01/data", folder / "image_02/data",
          folder / "image_03/data"};
}
bool KnowsRaw(const fs::path& folder) { return HasAny(RawFolders(folder)); }
bool RawHasImages(const fs::path& folder) { return HasPair(RawFolders(folder)); }

void ReadKittiRaw(const SequenceRequest& request, Sequence& sequence) {
  sequence.name = DriveName(request.folder);
  const CameraPair pair = ChooseCameras(request, RawFolders(request.folder));
  const fs::path date_folder = request.folder.parent_path();
  const CalibrationFile cameras(date_folder / "calib_cam_to_cam.txt");
  const CameraRig rig(cameras, "P_rect_0");
  sequence.other_files.push_back(cameras.path());
  AddImages(pair, rig, sequence);
  CheckRectifiedSize(cameras, pair.left, sequence.camera);

  const fs::path times_file = pair.left_folder.parent_path() / "timestamps.txt";
  AddTimes(times_file, ReadDateTimes(times_file), sequence);
  AddRawTruth(date_folder, cameras, sequence);
  AddBoxes(request, {.file = {}, .camera = 2}, rig, pair.left, sequence);
}

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

void AddTrackingTruth(const fs::path& oxts_file, const CalibrationFile& calibration,
                      Sequence& sequence) {
  if (!fs::exists(oxts_file)) {
    sequence.missing.push_back(oxts_file.string() + ": no ground truth of the camera");
    return;
  }
  sequence.other_files.push_back(oxts_file);
  const std::vector<OxtsPacket> packets = ReadOxtsPackets(oxts_file);
  const auto of_images = OfImages(packets, oxts_file.string() + ": packets", sequence);
  if (!of_images) {
    sequence.missing.push_back(oxts_file.string() + ": too few packets: no ground truth");
    return;
  }
  AddOxtsTruth(*of_images, ReadCamera0FromImu(calibration), sequence);
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

void ReadKittiTracking(const SequenceRequest& request, Sequence& sequence) {
  const std::string number = request.folder.filename().string();
  const fs::path set_folder = SetFolder(request.folder);
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
  AddTrackingTruth(set_folder / "oxts" / (number + ".txt"), calibration, sequence);

  LabelSource labels = {set_folder / "label_02" / (number + ".txt"), 2};
  if (!fs::exists(labels.file)) {
    if (request.labels_file.empty())
      sequence.missing.push_back(labels.file.string() + ": no labels");
    labels.file.clear();
  }
  AddBoxes(request, labels, rig, pair.left, sequence);
}

}  // namespace

SequenceLayout KittiOdometryLayout() {
  return {kKittiOdometry, KnowsOdometry, OdometryHasImages, ReadKittiOdometry};
}

SequenceLayout KittiRawLayout() { return {"kitti-raw", KnowsRaw, RawHasImages, ReadKittiRaw}; }

SequenceLayout KittiTrackingLayout() {
  return {"kitti-tracking", KnowsTracking, TrackingHasImages, ReadKittiTracking};
}

}  // namespace cvo
