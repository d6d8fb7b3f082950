// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/association/box_association.h"
#include "core/interface/frame.h"

namespace cvo {

// Placement of an image in a network's input: the scale is the same in x and y, and the rest is
// filled.
struct Letterbox {
  double scale = 1.0;  // p_in_input = scale * p_in_image + offset
  double offset_x_px = 0.0;
  double offset_y_px = 0.0;

  // Maps a box in the input to pixels of the image.
  ImageBox ToImage(const ImageBox& in_input) const;
};

enum class Placement { kCentered, kTopLeft };

// Makes `input`, of the given size, from a CV_8UC3 image. The rest is filled with grey level 114.
Letterbox FillInput(const cv::Mat& image, const cv::Size& size, Placement placement,
                    cv::Mat& input);

// Meaning of the rows of a detection network's output.
enum class OutputLayout {
  kDarknet,  // N x (5 + classes), one per layer: centre and size as fractions of the input
  kYolox,    // 1 x N x (5 + classes): offsets in cells of 8, 16 and 32 px, logarithms of sizes
  kYolov5,   // 1 x 3N x (5 + classes): centre and size in pixels of the input
  kYolov8    // 1 x (4 + classes) x N: as kYolov5, but transposed and without objectness
};
constexpr std::array<const char*, 4> EnumNames(OutputLayout) {
  return {"darknet", "yolox", "yolov5", "yolov8"};
}

// Returns the layout of an output with these sizes, for a network input of `size`. Empty if it is
// none of the known ones.
std::optional<OutputLayout> LayoutOf(const std::vector<int>& output_sizes, const cv::Size& size);

struct RawBox {
  ImageBox box;  // in pixels of the network's input
  int category = 0;
  double score = 0.0;  // of the best class, times objectness if the network has one
};

// Returns the boxes with a score of at least `min_score`. Throws Error unless each row has
// `categories` class scores.
std::vector<RawBox> DecodeOutput(const cv::Mat& output, OutputLayout layout, const cv::Size& size,
                                 int categories, double min_score);

// Non-maximum suppression: of boxes of one class that overlap by more than `max_overlap`
// (intersection over union), keeps the one with the highest score. Sorted by decreasing score.
std::vector<RawBox> SuppressOverlaps(std::vector<RawBox> boxes, double max_overlap);

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
