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

// Meaning of the rows of a detection network's output: one box each, as columns. Pixels are those
// of the input; if all are at most 2, they are fractions of it.
enum class OutputLayout {
  kDarknet,       // 5 + classes, one output per layer: centre and size as fractions of the input
  kYolox,         // 5 + classes: offsets in cells of 8, 16 and 32 px, logarithms of sizes
  kYoloxDecoded,  // the same, with centre and size in pixels
  kYolov5,        // 5 + classes: centre and size in pixels
  kYolov8,        // 4 + classes: the same, without objectness
  kEndToEnd,      // 6: left, top, right, bottom in pixels, score, class
};
constexpr std::array<const char*, 6> EnumNames(OutputLayout) {
  return {"darknet", "yolox", "yolox_decoded", "yolov5", "yolov8", "end2end"};
}

// Returns the output as a matrix with one box per row: N x columns, 1 x N x columns or, transposed,
// 1 x columns x N, whichever fits the number of classes. Throws Error, naming `where`, for anything
// else, such as the masks of a segmentation head.
cv::Mat RowsOf(const cv::Mat& output, int categories, const std::string& where);

// Returns the layout of such rows, for a network input of `size`: by their numbers and, where these
// leave it open, by the values of the best row. Empty if it stays open.
std::optional<OutputLayout> LayoutOf(const cv::Mat& rows, const cv::Size& size, int categories);

struct RawBox {
  ImageBox box;  // in pixels of the network's input
  int category = 0;
  double score = 0.0;  // of the best class, times objectness if the network has one
};

// Returns the boxes of rows (RowsOf) with a score of at least `min_score`. Throws Error unless each
// row has `categories` class scores.
std::vector<RawBox> DecodeRows(const cv::Mat& rows, OutputLayout layout, const cv::Size& size,
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
  std::optional<OutputLayout> layout = {};  // empty: found by LayoutOf
};

struct DetectorOptions {
  double min_score = 0.2;
  double max_overlap = 0.45;  // largest IoU of two boxes of one class that are both kept
};

// Maps the name of a COCO class to the corresponding KITTI class. Other names are returned
// unchanged.
std::string KittiClass(const std::string& name);

// A YOLO detector, in Darknet's format (v3, v4 and similar) or in ONNX as exported by YOLOX,
// YOLOv5, YOLOv8 and their successors. It runs on the CPU, with OpenCV's DNN module.
class DetectorModel {
 public:
  // Throws Error for missing or damaged files, for a network whose outputs are not boxes, and if
  // the number of names is not the network's number of classes.
  explicit DetectorModel(const DetectorFiles& files);
  ~DetectorModel();

  // Returns the detections in an 8-bit image, grey or colour (BGR), by decreasing score, in pixels
  // of the image and clipped to it.
  std::vector<Detection> Detect(const cv::Mat& image, const DetectorOptions& options);

  // Throws Error if there was no box so far although rows had high scores: then what was taken for
  // objectness is probably the score of a class, and a name is missing.
  void CheckClasses() const;

  OutputLayout layout() const;
  cv::Size input() const;

 private:
  struct Network;
  std::unique_ptr<Network> network_;
};

}  // namespace cvo
