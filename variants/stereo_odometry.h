// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/task_pool.h"
#include "core/interface/frame.h"

namespace cvo {

struct StereoOdometrySetup {
  StereoCamera camera;  // rectified pair: intrinsics in px, baseline_m, image size
  std::string variant = "full";
  std::optional<Options> options = {};  // of front end and estimator; default: those of the variant
  std::uint64_t seed = 0;               // of the estimator's random numbers
  int threads = 1;                      // results do not depend on it
};

// Stereo visual odometry with moving rigid bodies: front end and estimator in one object.
//
//   cvo::StereoOdometry odometry({.camera = camera});
//   for (...) {
//     const cvo::FrameReport frame = odometry.Process(left, right, timestamp_ns, boxes);
//     frame.world_from_camera;  // world = left camera of the first frame
//     frame.clusters;           // bodies: id, category, world_from_object, velocity_m_s, size
//     frame.landmarks;          // points: p_in_world and the body that each belongs to
//   }
//
// Units are metres, seconds, radians and pixels, with pixel centres at integers. Camera axes are
// x right, y down, z forward. The same input gives the same output, to the last bit. Throws
// cvo::Error on invalid input. Objects are independent of each other; each may be used by only one
// thread at a time.
class StereoOdometry {
 public:
  // Returns the options that a variant starts from.
  static Options DefaultsOf(const std::string& variant);

  explicit StereoOdometry(const StereoOdometrySetup& setup);

  // Processes one rectified pair, which must be CV_8UC1, of the camera's size, and later than the
  // previous frame. `boxes` are detections of rigid bodies in the left image, from any detector;
  // without them, no body is found. Boxes are clipped to the image; those outside it are ignored.
  FrameReport Process(const cv::Mat& left, const cv::Mat& right, std::int64_t timestamp_ns,
                      const std::vector<Detection>& boxes = {});

  // Processes a frame without images: camera and bodies are predicted.
  FrameReport Skip(std::int64_t timestamp_ns);

  // The corners of the last processed pair, into which LandmarkReport::feature is an index. Empty
  // after Skip.
  const std::vector<StereoFeature>& features() const { return features_; }

  // Returns world_from_camera of all frames so far, refined by later frames.
  std::vector<RigidTransform> Trajectory() const { return odometry_->Trajectory(); }

  // Returns all bodies so far with one pose per frame, refined by later frames.
  std::vector<ClusterTrajectory> ClusterTrajectories() const {
    return odometry_->ClusterTrajectories();
  }

 private:
  void Remember(std::vector<cv::Rect2d> boxes);

  StereoCamera camera_;
  Options options_;
  std::unique_ptr<TaskPool> pool_;
  std::unique_ptr<Odometry> odometry_;
  std::vector<std::vector<cv::Rect2d>> recent_boxes_;  // of the last kReserveFrames frames
  std::vector<StereoFeature> features_;
};

}  // namespace cvo
