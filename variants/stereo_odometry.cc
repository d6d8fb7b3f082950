// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "variants/stereo_odometry.h"

#include <utility>

#include "core/association/box_association.h"
#include "core/base/error.h"
#include "core/features/front_end.h"
#include "variants/registry.h"

namespace cvo {
namespace {

// Throws Error if the box is inverted or has a NaN.
void CheckBox(const ImageBox& box, std::size_t index) {
  if (box.left_px <= box.right_px && box.top_px <= box.bottom_px) return;
  ThrowError(StrCat("box ", index),
             StrCat("(", box.left_px, ", ", box.top_px, ") to (", box.right_px, ", ", box.bottom_px,
                    ") px"),
             "left <= right and top <= bottom");
}

// The boxes that the estimator is given, and the index of each in the caller's list.
struct Shown {
  std::vector<Detection> detections;
  std::vector<int> index;
};

Shown ShowBoxes(const std::vector<Detection>& boxes, const StereoCamera& camera) {
  Shown shown;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    CheckBox(boxes[i].box, i);
    const auto clipped = ClipToImage(boxes[i].box, camera);
    if (!clipped) continue;
    shown.detections.push_back({*clipped, boxes[i].category, boxes[i].score});
    shown.index.push_back(static_cast<int>(i));
  }
  return shown;
}

std::vector<cv::Rect2d> RegionsOf(const std::vector<Detection>& detections) {
  std::vector<cv::Rect2d> regions;
  for (const Detection& detection : detections) {
    const ImageBox& box = detection.box;
    regions.emplace_back(box.left_px, box.top_px, box.Width(), box.Height());
  }
  return regions;
}

}  // namespace

Options StereoOdometry::DefaultsOf(const std::string& variant) {
  return FindVariant(variant).defaults();
}

StereoOdometry::StereoOdometry(const StereoOdometrySetup& setup)
    : camera_(setup.camera),
      options_(setup.options.value_or(DefaultsOf(setup.variant))),
      pool_(std::make_unique<TaskPool>(setup.threads)),
      odometry_(FindVariant(setup.variant).make({camera_, options_, setup.seed}, *pool_)) {}

FrameReport StereoOdometry::Process(const cv::Mat& left, const cv::Mat& right,
                                    std::int64_t timestamp_ns,
                                    const std::vector<Detection>& boxes) {
  Shown shown = ShowBoxes(boxes, camera_);
  Remember(RegionsOf(shown.detections));
  StereoFrame frame;
  frame.timestamp_ns = timestamp_ns;
  frame.features = ExtractStereoFeatures(left, right, camera_, options_.orb, options_.stereo,
                                         *pool_, recent_boxes_);
  frame.detections = std::move(shown.detections);
  StageTimes times;
  FrameReport report = odometry_->Process(frame, times);
  for (ClusterReport& cluster : report.clusters) {
    if (cluster.detection >= 0) {
      cluster.detection = shown.index[static_cast<std::size_t>(cluster.detection)];
    }
  }
  features_ = std::move(frame.features);
  return report;
}

FrameReport StereoOdometry::Skip(std::int64_t timestamp_ns) {
  features_.clear();
  Remember({});
  return odometry_->Skip(timestamp_ns);
}

void StereoOdometry::Remember(std::vector<cv::Rect2d> boxes) {
  recent_boxes_.push_back(std::move(boxes));
  if (recent_boxes_.size() > kReserveFrames) recent_boxes_.erase(recent_boxes_.begin());
}

}  // namespace cvo
