// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/clean_render.h"

#include <cmath>
#include <deque>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>

#include "core/files/text/number.h"
#include "synth/truth/flow.h"
#include "synth/truth/labels.h"
#include "synth/truth/object_table.h"
#include "synth/truth/truth.h"
#include "synth/write/image_encoding.h"

namespace cvo::synth {
namespace {

// Tasks that refer to objects of the caller. The destructor waits for all of them.
class InFlight {
 public:
  InFlight(TaskPool& pool, std::size_t limit) : pool_(pool), limit_(limit) {}
  ~InFlight() {
    while (!tickets_.empty()) {
      try {
        WaitForOldest();
      } catch (...) {  // an earlier error is already propagating
      }
    }
  }
  InFlight(const InFlight&) = delete;
  InFlight& operator=(const InFlight&) = delete;

  void Add(std::function<void()> work) {
    tickets_.push_back(pool_.Submit(std::move(work)));
    while (tickets_.size() > limit_) WaitForOldest();
  }
  void WaitForAll() {
    while (!tickets_.empty()) WaitForOldest();
  }

 private:
  void WaitForOldest() {
    const TaskPool::Ticket ticket = tickets_.front();
    tickets_.pop_front();
    pool_.Wait(ticket);
  }

  TaskPool& pool_;
  std::size_t limit_;
  std::deque<TaskPool::Ticket> tickets_;
};

// A rendered frame with what is needed to write its files.
struct DrawnFrame {
  int index = 0;  // frame number in the folder
  Rendering rendering;
  cv::Mat left;  // clean, CV_8UC1
  cv::Mat right;
  View view;
  std::optional<View> next;  // for flow
};

// Averages sub-frames over the exposure, each at the middle of its interval.
void DrawBlurred(const World& world, const MotionBlurOptions& blur, double time_s,
                 const DrawingTools& tools, cv::Mat& left, cv::Mat& right) {
  cv::Mat sums[2];
  for (int i = 0; i < blur.sub_frames; ++i) {
    const double shift_s = blur.shutter_s * ((i + 0.5) / blur.sub_frames - 0.5);
    cv::Mat images[2];
    tools.draw_images(ViewAt(world, time_s + shift_s), images[0], images[1]);
    for (int k = 0; k < 2; ++k) {
      if (i == 0) sums[k] = cv::Mat(images[k].size(), CV_32FC1, cv::Scalar(0));
      cv::add(sums[k], LumaOf(images[k]), sums[k], cv::noArray(), CV_32F);
    }
  }
  sums[0].convertTo(left, CV_8U, 1.0 / blur.sub_frames);
  sums[1].convertTo(right, CV_8U, 1.0 / blur.sub_frames);
}

DrawnFrame DrawFrame(const World& world, const CleanRender& render, const DrawingTools& tools,
                     int index) {
  const double time_s = world.Time_s(render.first_frame + index);
  DrawnFrame frame;
  frame.index = index;
  frame.view = ViewAt(world, time_s);
  frame.rendering = tools.draw(frame.view);
  if (render.motion_blur.sub_frames > 1) {
    DrawBlurred(world, render.motion_blur, time_s, tools, frame.left, frame.right);
  } else {
    frame.left = LumaOf(frame.rendering.left);
    frame.right = LumaOf(frame.rendering.right);
  }
  if (render.flow && index + 1 < render.frames) {
    frame.next = ViewAt(world, world.Time_s(render.first_frame + index + 1));
  }
  return frame;
}

void WriteFrame(const World& world, const DrawnFrame& frame, FolderBuild& out) {
  const std::string number = SixDigits(frame.index);
  out.Write("image_0/" + number + ".png", EncodePng(frame.left));
  out.Write("image_1/" + number + ".png", EncodePng(frame.right));
  out.Write("depth_0/" + number + ".tiff", EncodeDepthTiff(frame.rendering.depth));
  out.Write("instance_0/" + number + ".png", EncodeMaskPng(frame.rendering.instances));
  if (frame.next) {
    out.Write("flow_0/" + number + ".png",
              EncodeMaskPng(ComputeFlow(world.rig, frame.rendering, frame.view, *frame.next)));
  }
}

std::int64_t Time_ns(const World& world, int frame) {
  return std::llround(static_cast<double>(frame) * 1e9 / world.rate_hz);
}

// Writes the tables, relative to the first frame and its left camera.
void WriteTables(const World& world, const std::vector<FrameTruth>& truths, FolderBuild& out) {
  const RigidTransform left_from_right(Eigen::Quaterniond::Identity(),
                                       Eigen::Vector3d(world.rig.baseline_m, 0.0, 0.0));
  const RigidTransform first_from_world = truths.front().world_from_left.Inverse();
  std::string times, poses, right_poses, labels, objects = ObjectTableHeader();
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const FrameTruth& truth = truths[i];
    const auto row = static_cast<int>(i);
    times += FormatSecondsNs(Time_ns(world, truth.frame) - Time_ns(world, truths[0].frame));
    times += '\n';
    // The first pose is the identity to the last bit.
    const RigidTransform pose =
        i == 0 ? RigidTransform() : first_from_world * truth.world_from_left;
    poses += FormatKittiPose(pose);
    right_poses += FormatKittiPose(pose * left_from_right);
    labels += FormatLabels(world, truth, row);
    objects += FormatObjectRows(world, truth, row, first_from_world);
  }
  out.Write("times.txt", times);
  out.Write("calib.txt", FormatKittiCalibration(world.rig));
  out.Write("poses.txt", poses);
  out.Write("poses_right.txt", right_poses);
  out.Write("labels.txt", labels);
  out.Write("objects.csv", objects);
}

void WriteTargets(const std::vector<TargetImages>& targets, FolderBuild& out) {
  std::string corners = "frame,corner,x,y,z\n";
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const std::string number = SixDigits(static_cast<int>(i));
    out.Write("calibration/image_0/" + number + ".png", EncodePng(targets[i].left));
    out.Write("calibration/image_1/" + number + ".png", EncodePng(targets[i].right));
    for (std::size_t k = 0; k < targets[i].corners_in_left.size(); ++k) {
      const Eigen::Vector3d& p = targets[i].corners_in_left[k];
      corners += StrCat(i, ",", k, ",", FormatDouble(p.x()), ",", FormatDouble(p.y()), ",",
                        FormatDouble(p.z()), "\n");
    }
  }
  out.Write("calibration/targets.csv", corners);
}

}  // namespace

View ViewAt(const World& world, double time_s) {
  View view;
  view.world_from_left = world.camera->At(time_s).world_from_body;
  for (const Body& body : world.bodies) {
    view.world_from_body.push_back(body.motion->At(time_s).world_from_body);
  }
  return view;
}

void WriteCleanRender(const World& world, const CleanRender& render, const DrawingTools& tools,
                      TaskPool& pool, const WorkHooks& hooks, FolderBuild& out) {
  Require(render.frames > 0, "WriteCleanRender: no frames");
  constexpr std::size_t kInFlight = 4;
  std::vector<FrameTruth> truths(static_cast<std::size_t>(render.frames));
  InFlight in_flight(pool, kInFlight);
  for (int i = 0; i < render.frames; ++i) {
    hooks.ThrowIfStopped();
    in_flight.Add([&, frame = DrawFrame(world, render, tools, i)] {
      truths[static_cast<std::size_t>(frame.index)] =
          ComputeTruth(world, render.first_frame + frame.index, frame.rendering);
      WriteFrame(world, frame, out);
    });
    hooks.Report(i + 1, render.frames, "render");
  }
  in_flight.WaitForAll();
  if (tools.draw_targets) WriteTargets(tools.draw_targets(), out);
  WriteTables(world, truths, out);
}

}  // namespace cvo::synth
