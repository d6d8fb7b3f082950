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

// A detection network as a user gives it.
struct DetectorFiles {
  std::filesystem::path model;    // Darknet's .cfg, or .onnx
  std::filesystem::path weights;  // Darknet's; empty: beside the model, of the same name
  std::filesystem::path names;    // of the classes, one per line
  cv::Size input = {0, 0};        // width, height in pixels; 0: of the .cfg, or 640 x 640
};

struct DetectorOptions {
  double min_score = 0.2;
  double max_overlap = 0.45;  // of two boxes of one class
};

// The class of KITTI that a class of COCO is; another class is itself.
std::string KittiClass(const std::string& name);

// Boxes of a YOLO network in Darknet's format (v3, v4 and their like) or in ONNX as YOLOX, YOLOv5
// and YOLOv8 are exported. OpenCV's DNN module runs it on the processor.
class DetectorModel {
 public:
  // Throws Error for files that are missing, damaged or without boxes, and for a list of names of
  // another length than the network has classes.
  explicit DetectorModel(const DetectorFiles& files);
  ~DetectorModel();

  // Of an 8-bit image, grey or colour (BGR): best first, inside the image, in its pixels.
  std::vector<Detection> Detect(const cv::Mat& image, const DetectorOptions& options);

  OutputLayout layout() const;
  cv::Size input() const;

 private:
  struct Network;
  std::unique_ptr<Network> network_;
};

}  // namespace cvo
