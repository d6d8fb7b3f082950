// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/interface/frame.h"
#include "experiments/yolo/network_output.h"

namespace cvo {

// A detection network as the user specifies it.
struct DetectorFiles {
  std::filesystem::path model;    // Darknet .cfg, or .onnx
  std::filesystem::path weights;  // for Darknet; empty: beside the model, with the same name
  std::filesystem::path names;    // of the classes, one per line
  cv::Size input = {0, 0};        // width, height in pixels; 0: from the .cfg, or 640 x 640
};

struct DetectorOptions {
  double min_score = 0.2;
  double max_overlap = 0.45;  // largest IoU of two boxes of one class that are both kept
};

// Maps the name of a COCO class to the corresponding KITTI class. Other names are returned
// unchanged.
std::string KittiClass(const std::string& name);

// A YOLO detector, in Darknet's format (v3, v4 and similar) or in ONNX as exported by YOLOX, YOLOv5
// and YOLOv8. It runs on the CPU, with OpenCV's DNN module.
class DetectorModel {
 public:
  // Throws Error for missing or damaged files, for a network whose outputs are not boxes, and if
  // the number of names is not the network's number of classes.
  explicit DetectorModel(const DetectorFiles& files);
  ~DetectorModel();

  // Returns the detections in an 8-bit image, grey or colour (BGR), by decreasing score, in pixels
  // of the image and clipped to it.
  std::vector<Detection> Detect(const cv::Mat& image, const DetectorOptions& options);

  OutputLayout layout() const;
  cv::Size input() const;

 private:
  struct Network;
  std::unique_ptr<Network> network_;
};

}  // namespace cvo
