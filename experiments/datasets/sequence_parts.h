// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the layouts share: between them and OpenSequence, not for others.

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/calibration/kitti_calibration.h"
#include "experiments/calibration/stereo_rig.h"
#include "experiments/datasets/image_files.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {

struct CameraPair {
  std::string name;  // "grey" or "colour"
  int left = 0;
  int right = 1;
  std::filesystem::path left_folder;
  std::filesystem::path right_folder;
};

// The pair that was asked for; else the first of which both folders exist; else the first of which
// one exists. Throws Error for a pair that the data set does not have.
CameraPair ChoosePair(const SequenceRequest& request, const std::vector<CameraPair>& pairs);

// Images and camera of the pair, and one time per image, over all frames.
void AddImages(const CameraPair& pair, const CameraRig& rig, Sequence& sequence);
void AddTimes(const std::filesystem::path& file, std::vector<std::int64_t> times_ns,
              Sequence& sequence);

// Ground truth from OxTS: pose i, empty or imu_0_from_imu_i, belongs to frame i.
void AddOxtsTruth(const std::vector<std::optional<RigidTransform>>& imu_poses,
                  const RigidTransform& camera0_from_imu, Sequence& sequence);

// Throws Error unless `groundtruth` is "devkit"; `reason` says why the data set has no other.
void RequireDevkitTruth(const SequenceRequest& request, const std::string& reason);

// Reads the boxes that were asked for; then cuts everything to the frames that were asked for.
struct LabelSource {
  std::filesystem::path file;  // empty: none
  int camera = 0;
};
void AddBoxes(const SequenceRequest& request, const LabelSource& own_labels, const CameraRig& rig,
              int left_camera, Sequence& sequence);
// Where there is one pair of cameras: boxes of files are in pixels of its left image.
void AddBoxes(const SequenceRequest& request, Sequence& sequence);
void CutFrames(const SequenceRequest& request, Sequence& sequence);

// Of data sets with one pair, "grey" or "colour", that is calibrated as a rig: with a rectification
// where the images in the files are not rectified. Throws Error if another pair is asked for.
void AddPair(const SequenceRequest& request, const std::string& pair, StereoImages images,
             Sequence& sequence);
void AddRig(const StereoRig& rig, const std::filesystem::path& calibration, Sequence& sequence);

// Poses of the left camera as it is in the files. The first of them becomes the world, also that of
// Sequence::bodies, whose frames are made visible if Visibility says kCentre and it is in the
// image.
void AddCameraTruth(std::vector<std::optional<RigidTransform>> world_from_left, Sequence& sequence);

// Adds to Sequence::missing how many of the frames have no truth, and why.
void StateFramesWithoutTruth(const std::string& reason, Sequence& sequence);

// Both, from poses of what carries the camera, at times of their own in the images' clock: they are
// interpolated to the images.
void AddCameraTruth(const Trajectory& world_from_carrier, const RigidTransform& carrier_from_left,
                    const std::string& reason, Sequence& sequence);

}  // namespace cvo
