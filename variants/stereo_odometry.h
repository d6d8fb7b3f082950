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
#include "core/interface/odometry.h"

namespace cvo {

struct StereoOdometrySetup {
  StereoCamera camera;  // rectified pair: intrinsics in px, baseline_m, image size
  std::string variant = "full";
  std::optional<Options> options = {};  // of front end and estimator; default: the variant's own
  std::uint64_t seed = 0;               // of the estimator's random draws
  int threads = 1;                      // results do not depend on it
};

// Stereo visual odometry that finds moving rigid bodies: front end and estimator in one object.
//
//   cvo::StereoOdometry odometry({.camera = camera});
//   for (...) {
//     const cvo::FrameReport frame = odometry.Process(left, right, timestamp_ns, boxes);
//     frame.world_from_camera;  // world = left camera of the first frame
//     frame.clusters;           // bodies: id, category, world_from_object, velocity_m_s, size
//     frame.landmarks;          // points: p_in_world and the body that each belongs to
//   }
//
// Metres, seconds, radians and pixels with centres at integers; x right, y down, z forward. Same
// input, same output, to the last bit. Bad input throws cvo::Error. Objects are independent of each
// other; one object is used by one thread at a time.
class StereoOdometry {
 public:
  // The options that a variant starts from.
  static Options DefaultsOf(const std::string& variant);

  explicit StereoOdometry(const StereoOdometrySetup& setup);

  // One rectified pair, CV_8UC1 and of the camera's size, at a time later than that of the frame
  // before. Boxes are those of rigid bodies in the left image, from any detector; without boxes no
  // body is found. They are clipped to the image; those outside of it are ignored.
  FrameReport Process(const cv::Mat& left, const cv::Mat& right, std::int64_t timestamp_ns,
                      const std::vector<Detection>& boxes = {});

  // A frame without images: camera and bodies are predicted.
  FrameReport Skip(std::int64_t timestamp_ns);

  // Corners of the last processed pair; LandmarkReport::feature is an index into them.
  const std::vector<StereoFeature>& features() const { return features_; }

  // world_from_camera of all frames so far, refined by those that came after.
  std::vector<RigidTransform> Trajectory() const { return odometry_->Trajectory(); }

  // All bodies so far with a pose per frame, refined by the frames that came after.
  std::vector<ClusterTrajectory> ClusterTrajectories() const {
    return odometry_->ClusterTrajectories();
  }

 private:
  void Remember(std::vector<cv::Rect2d> boxes);

  StereoCamera camera_;
  Options options_;
  std::unique_ptr<TaskPool> pool_;
  std::unique_ptr<Odometry> odometry_;
  std::vector<std::vector<cv::Rect2d>> recent_boxes_;  // of the last orb.reserve_frames
  std::vector<StereoFeature> features_;
};

}  // namespace cvo
