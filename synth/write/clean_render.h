// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/task_pool.h"
#include "synth/render/renderer.h"
#include "synth/sensor/sensor.h"
#include "synth/write/folder_build.h"

namespace cvo::synth {

// The user asked to stop; no incomplete output is left.
class Stopped : public Error {
 public:
  using Error::Error;
};

// Progress and messages of long work. Never called at the same time.
struct WorkHooks {
  std::function<void(int done, int total, const std::string& stage)> progress;
  std::function<bool()> stop;                      // asked for each frame
  std::function<void(const std::string&)> notice;  // one line for the user

  void Report(int done, int total, const std::string& stage) const {
    if (progress) progress(done, total, stage);
  }
  void ThrowIfStopped() const {
    if (stop && stop()) throw Stopped("stopped before the sequence was complete");
  }
};

// A known target as both cameras see it, CV_8UC1, and where its corners are.
struct TargetImages {
  cv::Mat left;
  cv::Mat right;
  std::vector<Eigen::Vector3d> corners_in_left;
};

// A renderer, or a substitute in tests.
struct DrawingTools {
  std::function<Rendering(const View&)> draw;
  std::function<void(const View&, cv::Mat& left, cv::Mat& right)> draw_images;
  std::function<std::vector<TargetImages>()> draw_targets;  // may be none
};

struct CleanRender {
  int first_frame = 0;
  int frames = 0;
  bool flow = false;
  MotionBlurOptions motion_blur;
};

View ViewAt(const World& world, double time_s);

// Everything of a sequence that no seed touches: clean images, depth, masks, flow, poses, tables,
// calibration targets.
// Draws on the calling thread while the pool encodes and writes earlier frames, a few at a time.
void WriteCleanRender(const World& world, const CleanRender& render, const DrawingTools& tools,
                      TaskPool& pool, const WorkHooks& hooks, FolderBuild& out);

}  // namespace cvo::synth
