// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// KITTI raw, synced and rectified: <date>/<drive>_sync/{image_00..03,oxts}/{data/,timestamps.txt}
// and <date>/calib_*.txt.

#include <algorithm>

#include "core/base/error.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/oxts.h"
#include "experiments/datasets/formats/timestamps.h"
#include "experiments/datasets/image_files.h"
#include "experiments/datasets/sequence_layout.h"
#include "experiments/datasets/sequence_parts.h"
#include "experiments/datasets/sequence_type.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

using ImuTruth = std::vector<std::optional<RigidTransform>>;

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

// Takes packet i as the ground truth of image i.
ImuTruth DevkitTruth(const std::vector<RigidTransform>& poses, const fs::path& oxts_data,
                     const Sequence& sequence) {
  if (poses.size() != sequence.images.size()) {
    ThrowError(oxts_data.string(), StrCat(poses.size(), " packets"),
               StrCat(sequence.images.size(), ", as many as images"));
  }
  return {poses.begin(), poses.end()};
}

ImuTruth InterpolatedTruth(const std::vector<RigidTransform>& poses, const fs::path& oxts_folder,
                           Sequence& sequence) {
  const fs::path times_file = oxts_folder / "timestamps.txt";
  const std::vector<std::int64_t> times_ns = ReadDateTimes(times_file);
  sequence.other_files.push_back(times_file);
  if (times_ns.size() != poses.size()) {
    ThrowError(times_file.string(), StrCat(times_ns.size(), " times"),
               StrCat(poses.size(), ", as many as packets in ", (oxts_folder / "data").string()));
  }
  Trajectory packets;
  for (std::size_t i = 0; i < poses.size(); ++i) packets.push_back({times_ns[i], poses[i]});
  ImuTruth truth;
  for (const std::int64_t time_ns : sequence.timestamps_ns) {
    truth.push_back(InterpolatePose(packets, time_ns));
  }
  const auto outside =
      std::count_if(truth.begin(), truth.end(), [](const auto& pose) { return !pose; });
  if (outside > 0) {
    sequence.missing.push_back(StrCat("oxts: no ground truth for ", outside, " of ", truth.size(),
                                      " images, taken before the first or after the last packet"));
  }
  return truth;
}

void AddTruth(const SequenceRequest& request, const fs::path& date_folder,
              const CalibrationFile& cameras, Sequence& sequence) {
  const bool interpolated = request.groundtruth == "interpolated";
  if (!interpolated && request.groundtruth != "devkit") {
    ThrowError(
        "option --groundtruth",
        Quoted(request.groundtruth) + DidYouMean(request.groundtruth, {"devkit", "interpolated"}),
        "devkit or interpolated");
  }
  const fs::path oxts_folder = sequence.folder / "oxts";
  if (!fs::exists(oxts_folder) && !interpolated) {
    sequence.missing.emplace_back("oxts: no ground truth of the camera");
    return;
  }
  std::vector<OxtsPacket> packets;
  for (const fs::path& path : ListNumberedFiles(oxts_folder / "data", {"", ".txt"})) {
    packets.push_back(ReadOxtsPacket(path));
    sequence.other_files.push_back(path);
  }
  const std::vector<RigidTransform> poses = ImuPoses(packets);
  const ImuTruth truth = interpolated ? InterpolatedTruth(poses, oxts_folder, sequence)
                                      : DevkitTruth(poses, oxts_folder / "data", sequence);
  AddOxtsTruth(truth, ReadCamera0FromImu(date_folder, cameras, sequence), sequence);
  sequence.groundtruth = request.groundtruth;
}

bool KnowsRaw(const fs::path& folder) {
  return IsFolder(folder / "image_00/data") || IsFolder(folder / "image_01/data") ||
         IsFolder(folder / "image_02/data") || IsFolder(folder / "image_03/data");
}

bool RawHasImages(const fs::path& folder) {
  return AreFolders(folder / "image_00/data", folder / "image_01/data") ||
         AreFolders(folder / "image_02/data", folder / "image_03/data");
}

Sequence ReadKittiRaw(const SequenceRequest& request) {
  Sequence sequence;
  sequence.folder = request.folder;
  sequence.name = DriveName(request.folder);
  const auto data = [&](const char* image) { return request.folder / image / "data"; };
  const CameraPair pair =
      ChoosePair(request, {{"grey", 0, 1, data("image_00"), data("image_01")},
                           {"colour", 2, 3, data("image_02"), data("image_03")}});

  const fs::path date_folder = request.folder.parent_path();
  const CalibrationFile cameras(date_folder / "calib_cam_to_cam.txt");
  const CameraRig rig(cameras, "P_rect_0");
  sequence.other_files.push_back(cameras.path());
  AddImages(pair, rig, sequence);
  CheckRectifiedSize(cameras, pair.left, sequence.camera);

  const fs::path times_file = pair.left_folder.parent_path() / "timestamps.txt";
  AddTimes(times_file, ReadDateTimes(times_file), sequence);
  AddTruth(request, date_folder, cameras, sequence);
  AddBoxes(request, {.file = {}, .camera = 2}, rig, pair.left, sequence);
  return sequence;
}

}  // namespace

SequenceLayout KittiRawLayout() {
  return {"kitti-raw", "image_00/data, oxts", KnowsRaw, RawHasImages, ReadKittiRaw};
}

}  // namespace cvo
