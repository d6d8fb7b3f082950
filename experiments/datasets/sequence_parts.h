// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the readers share: between them and OpenSequence, not for others.

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/datasets/kitti_calibration.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

Sequence ReadKittiRaw(const SequenceRequest& request);
Sequence ReadKittiOdometry(const SequenceRequest& request);
Sequence ReadKittiTracking(const SequenceRequest& request);

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
void CutFrames(const SequenceRequest& request, Sequence& sequence);

}  // namespace cvo
