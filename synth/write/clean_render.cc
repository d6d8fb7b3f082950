// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <memory>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/text/number.h"
#include "synth/truth/truth.h"
#include "synth/write/dataset.h"

// Without its deprecated types, which OpenCV has too.
#define TIFF_DISABLE_DEPRECATED
#include <tiffio.h>

namespace cvo::synth {
namespace {

// A file in memory for libtiff.
struct MemoryFile {
  std::string bytes;
  std::size_t position = 0;
};

MemoryFile& FileOf(thandle_t handle) { return *static_cast<MemoryFile*>(handle); }

tmsize_t Read(thandle_t handle, void* out, tmsize_t size) {
  MemoryFile& file = FileOf(handle);
  const std::size_t left = file.bytes.size() - std::min(file.position, file.bytes.size());
  const std::size_t count = std::min(static_cast<std::size_t>(size), left);
  std::memcpy(out, file.bytes.data() + file.position, count);
  file.position += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t Write(thandle_t handle, void* in, tmsize_t size) {
  MemoryFile& file = FileOf(handle);
  const auto count = static_cast<std::size_t>(size);
  if (file.bytes.size() < file.position + count) file.bytes.resize(file.position + count);
  std::memcpy(file.bytes.data() + file.position, in, count);
  file.position += count;
  return size;
}

toff_t Seek(thandle_t handle, toff_t offset, int whence) {
  MemoryFile& file = FileOf(handle);
  const std::size_t base = whence == SEEK_SET   ? 0
                           : whence == SEEK_CUR ? file.position
                                                : file.bytes.size();
  file.position = base + offset;
  return file.position;
}

toff_t Size(thandle_t handle) { return FileOf(handle).bytes.size(); }
int Close(thandle_t) { return 0; }

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
  frame.rendering = tools.draw(ViewAt(world, time_s));
  if (render.motion_blur.sub_frames > 1) {
    DrawBlurred(world, render.motion_blur, time_s, tools, frame.left, frame.right);
  } else {
    frame.left = LumaOf(frame.rendering.left);
    frame.right = LumaOf(frame.rendering.right);
  }
  return frame;
}

void WriteFrame(const DrawnFrame& frame, FolderBuild& out) {
  const std::string number = SixDigits(frame.index);
  out.Write("image_0/" + number + ".png", EncodePng(frame.left));
  out.Write("image_1/" + number + ".png", EncodePng(frame.right));
  out.Write("depth_0/" + number + ".tiff", EncodeDepthTiff(frame.rendering.depth));
  out.Write("instance_0/" + number + ".png", EncodeMaskPng(frame.rendering.instances));
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

}  // namespace

std::string EncodePng(const cv::Mat& image) {
  return EncodeImage(
      ".png", image,
      {cv::IMWRITE_PNG_COMPRESSION, 1, cv::IMWRITE_PNG_STRATEGY, cv::IMWRITE_PNG_STRATEGY_RLE});
}

std::string EncodeMaskPng(const cv::Mat& image) {
  return EncodeImage(".png", image, {cv::IMWRITE_PNG_COMPRESSION, 1});
}

std::string EncodeDepthTiff(const cv::Mat& depth) {
  Require(depth.type() == CV_32FC1, "EncodeDepthTiff: depth must be CV_32FC1");
  const cv::Mat rows = depth.isContinuous() ? depth : depth.clone();
  MemoryFile file;
  std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(
      TIFFClientOpen("depth", "w", &file, Read, Write, Seek, Close, Size, nullptr, nullptr),
      TIFFClose);
  Require(tiff != nullptr, "TIFF: libtiff cannot start a file");
  TIFF* out = tiff.get();
  TIFFSetField(out, TIFFTAG_IMAGEWIDTH, rows.cols);
  TIFFSetField(out, TIFFTAG_IMAGELENGTH, rows.rows);
  TIFFSetField(out, TIFFTAG_BITSPERSAMPLE, 32);
  TIFFSetField(out, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(out, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  TIFFSetField(out, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(out, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(out, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFSetField(out, TIFFTAG_PREDICTOR, PREDICTOR_FLOATINGPOINT);
  TIFFSetField(out, TIFFTAG_ZIPQUALITY, 3);
  TIFFSetField(out, TIFFTAG_ROWSPERSTRIP, rows.rows);
  // A copy, because the predictor modifies the data in place.
  std::vector<float> copy(rows.begin<float>(), rows.end<float>());
  const auto size = static_cast<tmsize_t>(copy.size() * sizeof(float));
  Require(TIFFWriteEncodedStrip(out, 0, copy.data(), size) == size && TIFFFlush(out) == 1,
          "TIFF: libtiff cannot encode an image");
  tiff.reset();
  return std::move(file.bytes);
}

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
      WriteFrame(frame, out);
    });
    hooks.Report(i + 1, render.frames, "render");
  }
  in_flight.WaitForAll();
  WriteTables(world, truths, out);
}

}  // namespace cvo::synth
