// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The groups of checks that CheckScene runs. Each throws Error for a file that it cannot read.

#include <filesystem>
#include <vector>

#include "core/base/task_pool.h"
#include "experiments/scene_check/report.h"
#include "experiments/scene_check/scene_folder.h"

namespace cvo {

// Compares every file of the folder with the manifest.
std::vector<SceneCheck> CheckFiles(const std::filesystem::path& folder, TaskPool& pool);
// Compares the right images with those predicted from the left images and depth.
std::vector<SceneCheck> CheckStereo(const SceneFolder& scene, TaskPool& pool);
// Check the poses of cameras and bodies against each other and against images, depth and flow.
std::vector<SceneCheck> CheckPoses(const SceneFolder& scene, TaskPool& pool);
std::vector<SceneCheck> CheckMotion(const SceneFolder& scene, TaskPool& pool);
std::vector<SceneCheck> CheckFlow(const SceneFolder& scene, TaskPool& pool);
// Compares masks with 3D boxes, depth, visible boxes and pixel counts, in all frames.
std::vector<SceneCheck> CheckMasks(const SceneFolder& scene, TaskPool& pool);
// Compare labels.txt and detections/*.txt with objects.csv.
std::vector<SceneCheck> CheckLabels(const SceneFolder& scene, TaskPool& pool);
std::vector<SceneCheck> CheckDetections(const SceneFolder& scene, TaskPool& pool);
// Compares the corners found on the calibration targets with their projection through calib.txt.
std::vector<SceneCheck> CheckTargets(const SceneFolder& scene, TaskPool& pool);
// Checks what our own front end finds in the images.
std::vector<SceneCheck> CheckFeatures(const SceneFolder& scene, TaskPool& pool);

}  // namespace cvo
