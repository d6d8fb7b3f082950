// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/base/task_pool.h"
#include "experiments/datasets/formats/scene_truth.h"
#include "experiments/datasets/scene_check/check_scene.h"
#include "experiments/datasets/sequence.h"

// What the groups of checks of CheckScene share.

namespace cvo {

// The folder of a rendered scene, with everything read except its images.
struct SceneFolder {
  std::filesystem::path path;
  Sequence sequence;
  std::vector<RigidTransform> world_from_left;  // [frame]
  std::vector<std::vector<SceneBody>> bodies;   // [frame][id - 1]
  std::vector<int> image_frames;                // frames whose images are compared, ascending

  int frame_count() const { return static_cast<int>(sequence.images.size()); }
  cv::Size size() const { return {sequence.camera.width_px, sequence.camera.height_px}; }
  // Returns <path>/<folder>/<frame as %06d><extension>.
  std::filesystem::path FileOf(const char* folder, int frame, const char* extension) const;
  cv::Mat Depth(int frame) const { return ReadDepth(FileOf("depth_0", frame, ".tiff"), size()); }
  cv::Mat Instances(int frame) const {
    return ReadInstances(FileOf("instance_0", frame, ".png"), size());
  }
};

// The largest figure seen so far, and where it was seen. NaN is larger than any number.
struct Worst {
  double figure = 0.0;
  std::string where;

  void Add(double candidate, const std::string& place);
  // Returns the check that the largest figure is at most `limit`.
  SceneCheck AtMost(const std::string& name, const std::string& unit, double limit) const;
};

// Returns results[i] = work(i), computed on all threads of the pool.
template <typename Result, typename Work>
std::vector<Result> ForAll(int count, TaskPool& pool, const Work& work) {
  std::vector<Result> results(static_cast<std::size_t>(count));
  pool.ParallelFor(count, [&](int i) { results[static_cast<std::size_t>(i)] = work(i); });
  return results;
}

// Returns the point at a pixel, in the left camera. The pixel's depth must be positive.
Eigen::Vector3d PointAt(const StereoCamera& camera, const cv::Mat& depth, int u, int v);

// The groups. Each throws Error for a file that it cannot read.

// Compares the right images with those predicted from the left images and depth.
std::vector<SceneCheck> CheckStereo(const SceneFolder& scene, TaskPool& pool);
// Compares the poses of both cameras, and the velocities of bodies with their poses.
std::vector<SceneCheck> CheckPoses(const SceneFolder& scene, TaskPool& pool);
// Compares masks with 3D boxes, depth, visible boxes and pixel counts, in all frames.
std::vector<SceneCheck> CheckMasks(const SceneFolder& scene, TaskPool& pool);

}  // namespace cvo
