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

// Thrown if the user asked to stop. No incomplete output is left behind.
class Stopped : public Error {
 public:
  using Error::Error;
};

// Callbacks for progress, cancellation and messages of a long operation. Never called concurrently.
struct WorkHooks {
  std::function<void(int done, int total, const std::string& stage)> progress;
  std::function<bool()> stop;                      // polled every few frames
  std::function<void(const std::string&)> notice;  // one line for the user

  void Report(int done, int total, const std::string& stage) const {
    if (progress) progress(done, total, stage);
  }
  void ThrowIfStopped() const {
    if (stop && stop()) throw Stopped("stopped before the sequence was complete");
  }
};

// Images of a known target in both cameras, CV_8UC1, and its corners in the left camera's frame, m.
struct TargetImages {
  cv::Mat left;
  cv::Mat right;
  std::vector<Eigen::Vector3d> corners_in_left;
};

// The functions of a renderer, or of a substitute in tests.
struct DrawingTools {
  std::function<Rendering(const View&)> draw;
  std::function<void(const View&, cv::Mat& left, cv::Mat& right)> draw_images;
  std::function<std::vector<TargetImages>()> draw_targets;  // may be empty
};

struct CleanRender {
  int first_frame = 0;
  int frames = 0;
  bool flow = false;
  MotionBlurOptions motion_blur;
};

View ViewAt(const World& world, double time_s);

// Writes everything in a sequence that does not depend on a seed: clean images, depth, masks, flow,
// poses, tables and calibration targets. Renders on the calling thread while the pool encodes and
// writes the last few frames. Throws Stopped.
void WriteCleanRender(const World& world, const CleanRender& render, const DrawingTools& tools,
                      TaskPool& pool, const WorkHooks& hooks, FolderBuild& out);

}  // namespace cvo::synth
