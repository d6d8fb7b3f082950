// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shared by the layouts and OpenSequence; not for use elsewhere.

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/files/json/json_record.h"
#include "experiments/datasets/calibration/kitti_calibration.h"
#include "experiments/datasets/calibration/stereo_rig.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {

// How a data set lays out the files of a sequence.
struct SequenceLayout {
  std::string type;  // value of --type
  // Whether a folder has this layout, complete or not. No two layouts recognise the same folder.
  bool (*knows)(const std::filesystem::path& folder);
  // Whether the folder has images of both cameras; FindSequences omits those that do not.
  bool (*has_images)(const std::filesystem::path& folder);
  // Reads a sequence whose folder and name (that of the folder) are set.
  void (*read)(const SequenceRequest& request, Sequence& sequence);
  // Every key that SequenceRequest::layout may have, with its default.
  Json settings = Json::object();
};

SequenceLayout ClusterslamLayout();
SequenceLayout EurocLayout();
SequenceLayout KittiOdometryLayout();
SequenceLayout KittiRawLayout();
SequenceLayout KittiTrackingLayout();
SequenceLayout OxfordMultimotionLayout();
// Returns all of them, sorted by type.
const std::vector<SequenceLayout>& SequenceLayouts();

// Returns SequenceRequest::layout, whose keys have been checked, as a layout's record of settings.
template <JsonRecord Settings>
Settings LayoutSettings(const SequenceRequest& request) {
  return FromJson<Settings>(request.layout, "layout settings");
}

struct CameraPair {
  std::string name;  // "grey" or "colour"
  int left = 0;
  int right = 1;
  std::filesystem::path left_folder;
  std::filesystem::path right_folder;
};

// Returns the requested pair; without a request, the first pair with both folders, else the first
// with one of them, else the first. Throws Error for a pair that the data set does not have.
CameraPair ChoosePair(const SequenceRequest& request, const std::vector<CameraPair>& pairs);

// Set the images and the camera of the pair, and one timestamp per image, for all frames.
void AddImages(const CameraPair& pair, const CameraRig& rig, Sequence& sequence);
void AddTimes(const std::filesystem::path& file, std::vector<std::int64_t> times_ns,
              Sequence& sequence);

// Returns those of `all` that belong to the images: all if there is one per image, or, of a list of
// the whole recording, those with the numbers of the images, which is noted. Empty if too few.
template <typename T>
std::optional<std::vector<T>> OfImages(const std::vector<T>& all, const std::string& what,
                                       Sequence& sequence) {
  const std::size_t images = sequence.images.size();
  const auto first = static_cast<std::size_t>(sequence.first_frame);
  if (all.size() == images) return all;
  if (all.size() < first + images) return std::nullopt;
  sequence.total_frames = std::max(sequence.total_frames, static_cast<int>(all.size()));
  sequence.notes.push_back(StrCat(what, ": ", all.size(), " for ", images,
                                  " images, of which those of frames ", first, " to ",
                                  first + images - 1, " are used"));
  const auto begin = all.begin() + sequence.first_frame;
  return std::vector<T>(begin, begin + static_cast<std::ptrdiff_t>(images));
}

// Throws Error that `found`, such as "15 times", are too few for the images.
[[noreturn]] void FailTooFew(const std::filesystem::path& file, const std::string& found,
                             const Sequence& sequence);

// Returns world_from_camera of the left camera for poses of the IMU, empty or imu_0_from_imu_i.
std::vector<std::optional<RigidTransform>> CameraPoses(
    const std::vector<std::optional<RigidTransform>>& imu_poses,
    const RigidTransform& camera0_from_imu, const Sequence& sequence);

// AddBoxes reads the requested boxes. CutFrames then cuts everything to the requested frames.
struct LabelSource {
  std::filesystem::path file;  // empty: none
  int camera = 0;
};
void AddBoxes(const SequenceRequest& request, const LabelSource& own_labels, const CameraRig& rig,
              int left_camera, Sequence& sequence);
// For data sets with a single pair of cameras: boxes in files are in pixels of its left image.
void AddBoxes(const SequenceRequest& request, Sequence& sequence);
void CutFrames(const SequenceRequest& request, Sequence& sequence);

// For data sets with a single pair, "grey" or "colour", that is calibrated as a rig. AddPair throws
// Error if another pair is requested. AddRig adds a rectification if the images in the files are
// not rectified.
void AddPair(const SequenceRequest& request, const std::string& pair, StereoImages images,
             Sequence& sequence);
void AddRig(const StereoRig& rig, const std::filesystem::path& calibration, Sequence& sequence);

// Sets the ground truth from poses of the left camera as it is in the files, before rectification.
// The first of them becomes the world, also of Sequence::bodies. If Visibility says kCentre, a body
// is visible in the frames where its centre is in the image.
void AddCameraTruth(std::vector<std::optional<RigidTransform>> world_from_left, Sequence& sequence);

// Does so from poses of what carries the camera, interpolated from their own timestamps (in the
// clock of the images) to those of the images. Also sets Sequence::truth_track, and appends to
// Sequence::missing how many frames have no ground truth, and why.
void AddCameraTruth(const Trajectory& world_from_carrier, const RigidTransform& carrier_from_left,
                    const std::string& reason, Sequence& sequence);

}  // namespace cvo
