// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/detector_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/files/json/json_record.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"

namespace cvo {

namespace fs = std::filesystem;
namespace {

constexpr std::array<int, 3> kCells_px = {8, 16, 32};

constexpr int kEndToEndColumns = 6;
constexpr int kMaskColumns = 32;  // of a segmentation head, after the scores of classes

bool HasObjectness(OutputLayout layout) { return layout < OutputLayout::kYolov8; }

int ColumnsOf(OutputLayout layout, int categories) {
  if (layout == OutputLayout::kEndToEnd) return kEndToEndColumns;
  return (HasObjectness(layout) ? 5 : 4) + categories;
}

// Whether the values of the row with the best score are pixels rather than offsets in cells and
// logarithms, which are never as large.
bool HoldsPixels(const cv::Mat& rows) {
  constexpr float kLargestRaw = 12.0F;
  const auto score = [&](const float* row) {
    return row[4] * *std::max_element(row + 5, row + rows.cols);
  };
  const float* best = rows.ptr<float>(0);
  for (int i = 1; i < rows.rows; ++i) {
    if (score(rows.ptr<float>(i)) > score(best)) best = rows.ptr<float>(i);
  }
  return std::any_of(best, best + 4, [](float value) { return std::abs(value) > kLargestRaw; });
}

struct CenteredBox {
  double x, y, width, height;
};

// Decodes a box relative to its cell. The cells are ordered by size, the smallest first, then row
// by row.
CenteredBox FromCell(const CenteredBox& box, int row, const cv::Size& size) {
  for (const int cell : kCells_px) {
    const int columns = size.width / cell;
    const int count = columns * (size.height / cell);
    if (row >= count) {
      row -= count;
      continue;
    }
    return {(box.x + row % columns) * cell, (box.y + row / columns) * cell,
            std::exp(box.width) * cell, std::exp(box.height) * cell};
  }
  throw Error("FromCell: no such cell");
}

CenteredBox ToPixels(const CenteredBox& box, OutputLayout layout, int row, const cv::Size& size) {
  switch (layout) {
    case OutputLayout::kDarknet:
      return {box.x * size.width, box.y * size.height, box.width * size.width,
              box.height * size.height};
    case OutputLayout::kYolox:
      return FromCell(box, row, size);
    case OutputLayout::kEndToEnd:  // corners
      return {0.5 * (box.x + box.width), 0.5 * (box.y + box.height), box.width - box.x,
              box.height - box.y};
    case OutputLayout::kYoloxDecoded:
    case OutputLayout::kYolov5:
    case OutputLayout::kYolov8:
      return box;
  }
  throw Error("OutputLayout: not one of the enumerators");
}

// Other numbers are logarithms of scores, corners or an angle.
void CheckScore(float score) {
  if (!(score < -0.001F || score > 1.001F)) return;  // rounding
  ThrowError("model", StrCat("a score of ", score),
             "0 to 1: another --layout, or an export with the sigmoid of scores");
}

std::vector<std::string> ReadNames(const fs::path& path) {
  const TextFile file(path);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < file.size(); ++i) names.push_back(KittiClass(file.line(i)));
  if (names.empty()) ThrowError(path.string(), "no line", "the name of a class per line");
  return names;
}

// Reads a size such as "width=960" of the section [net].
int NetSize(const fs::path& cfg, const std::string& key) {
  const TextFile file(cfg);
  for (std::size_t i = 0; i < file.size(); ++i) {
    std::string line = file.line(i);
    std::erase_if(line, [](char c) { return c == ' ' || c == '\t'; });
    if (!line.starts_with(key + "=")) continue;
    const std::optional<std::int64_t> value = ParseInteger(line.substr(key.size() + 1));
    if (value && *value > 0 && *value <= 16'384) return static_cast<int>(*value);
    ThrowError(file.Where(i), Quoted(line), key + " of 1 to 16384 px");
  }
  ThrowError(cfg.string(), "no " + key, key + "=<pixels> in section [net]");
}

// Returns call(). Replaces OpenCV's exceptions, whose messages contain its own source paths and
// lines.
template <typename Call>
auto OrError(const fs::path& file, const char* expected, const Call& call) {
  try {
    return call();
  } catch (const cv::Exception& exception) {
    ThrowError(file.string(), Quoted(exception.err), expected);
  }
}

cv::dnn::Net ReadNetwork(const DetectorFiles& files) {
  if (files.model.extension() == ".onnx") {
    const std::string bytes = ReadFileBytes(files.model);
    return OrError(files.model, "an ONNX network of 32-bit numbers that OpenCV reads",
                   [&] { return cv::dnn::readNetFromONNX(bytes.data(), bytes.size()); });
  }
  if (files.model.extension() != ".cfg") {
    ThrowError(files.model.string(), Quoted(files.model.extension().string()),
               "a model .cfg (Darknet) or .onnx");
  }
  const fs::path weights_file =
      files.weights.empty() ? fs::path(files.model).replace_extension(".weights") : files.weights;
  const std::string cfg = ReadFileBytes(files.model);
  const std::string weights = ReadFileBytes(weights_file);
  constexpr std::size_t kHeaderBytes = 20;  // version and number of images seen
  if (weights.size() <= kHeaderBytes) {
    ThrowError(weights_file.string(), StrCat(weights.size(), " bytes"), "weights of Darknet");
  }
  return OrError(weights_file, "the weights of this Darknet network", [&] {
    return cv::dnn::readNetFromDarknet(cfg.data(), cfg.size(), weights.data(), weights.size());
  });
}

}  // namespace

ImageBox Letterbox::ToImage(const ImageBox& in_input) const {
  return {(in_input.left_px - offset_x_px) / scale, (in_input.top_px - offset_y_px) / scale,
          (in_input.right_px - offset_x_px) / scale, (in_input.bottom_px - offset_y_px) / scale};
}

Letterbox FillInput(const cv::Mat& image, const cv::Size& size, Placement placement,
                    cv::Mat& input) {
  Letterbox box;
  box.scale = std::min(static_cast<double>(size.width) / image.cols,
                       static_cast<double>(size.height) / image.rows);
  const cv::Size scaled(std::max(1, static_cast<int>(std::lround(box.scale * image.cols))),
                        std::max(1, static_cast<int>(std::lround(box.scale * image.rows))));
  const cv::Point corner =
      placement == Placement::kTopLeft
          ? cv::Point(0, 0)
          : cv::Point((size.width - scaled.width) / 2, (size.height - scaled.height) / 2);
  box.offset_x_px = corner.x;
  box.offset_y_px = corner.y;
  input.create(size, CV_8UC3);
  input.setTo(cv::Scalar::all(114));
  cv::resize(image, input(cv::Rect(corner, scaled)), scaled, 0.0, 0.0, cv::INTER_LINEAR);
  return box;
}

cv::Mat RowsOf(const cv::Mat& output, int categories, const std::string& where) {
  const auto fits = [&](int columns) {
    return columns == 4 + categories || columns == 5 + categories || columns == kEndToEndColumns;
  };
  const int* sizes = output.size.p;
  std::string found = "an output of";
  for (int i = 0; i < output.dims; ++i) found += StrCat(i > 0 ? " x " : " ", sizes[i]);
  if (output.type() == CV_32F && output.dims == 2 && fits(sizes[1])) return output;
  const bool is_list = output.type() == CV_32F && output.dims == 3 && sizes[0] == 1;
  if (is_list && (fits(sizes[1]) || fits(sizes[2]))) {
    const cv::Mat plane(sizes[1], sizes[2], CV_32F, const_cast<uchar*>(output.data));
    // More boxes than columns, if either could be.
    return fits(sizes[2]) && (!fits(sizes[1]) || sizes[1] >= sizes[2]) ? plane : cv::Mat(plane.t());
  }
  if (is_list && (fits(sizes[1] - kMaskColumns) || fits(sizes[2] - kMaskColumns))) {
    found += ", as of a segmentation head";
  }
  if (output.dims >= 4) found += ", as of masks or of heads that are not decoded";
  ThrowError(where, found,
             StrCat("boxes of ", categories, " classes, as many as names: rows of ", 4 + categories,
                    " or ", 5 + categories, " numbers, or of 6 (end-to-end)"));
}

std::optional<OutputLayout> LayoutOf(const cv::Mat& rows, const cv::Size& size, int categories) {
  const auto count = [&](int cell) { return (size.width / cell) * (size.height / cell); };
  const int cells = count(8) + count(16) + count(32);
  // Some networks have a level of smaller or larger cells as well, or three boxes per cell.
  const auto fits = [&](int boxes) { return rows.rows == boxes || rows.rows == 3 * boxes; };
  const bool by_cell = fits(cells) || fits(cells + count(4)) || fits(cells + count(64));
  if (rows.cols == 4 + categories && by_cell) return OutputLayout::kYolov8;
  if (rows.cols == 5 + categories && by_cell) {
    const bool pixels = HoldsPixels(rows);
    if (rows.rows == cells) return pixels ? OutputLayout::kYoloxDecoded : OutputLayout::kYolox;
    return pixels || rows.rows == 3 * cells ? std::optional(OutputLayout::kYolov5) : std::nullopt;
  }
  const bool either = rows.cols == 4 + categories || rows.cols == 5 + categories;
  return rows.cols == kEndToEndColumns && !either ? std::optional(OutputLayout::kEndToEnd)
                                                  : std::nullopt;
}

std::vector<RawBox> DecodeRows(const cv::Mat& rows, OutputLayout layout, const cv::Size& size,
                               int categories, double min_score) {
  const int columns = ColumnsOf(layout, categories);
  if (rows.cols != columns) {
    ThrowError("model", StrCat(rows.cols - columns + categories, " classes"),
               StrCat(categories, ", as many as names"));
  }
  const bool end_to_end = layout == OutputLayout::kEndToEnd;
  const int first = end_to_end ? 4 : columns - categories;
  // Darknet's class scores already include objectness.
  const bool times_objectness = HasObjectness(layout) && layout != OutputLayout::kDarknet;
  double largest = 0.0;
  std::vector<RawBox> boxes;
  for (int i = 0; i < rows.rows; ++i) {
    const float* row = rows.ptr<float>(i);
    for (int k = 0; k < 4; ++k) largest = std::max(largest, static_cast<double>(row[k]));
    const float* best = end_to_end ? row + 4 : std::max_element(row + first, row + rows.cols);
    std::for_each(row + (times_objectness ? 4 : first), end_to_end ? row + 5 : row + columns,
                  CheckScore);
    const double score = *best * (times_objectness ? static_cast<double>(row[4]) : 1.0);
    if (!(score >= min_score)) continue;
    const auto category = end_to_end ? std::lround(row[5]) : best - (row + first);
    if (category < 0 || category >= categories || (end_to_end && std::floor(row[5]) != row[5])) {
      ThrowError("model", StrCat("class ", row[5]), StrCat("0 to ", categories - 1));
    }
    const CenteredBox box = ToPixels({row[0], row[1], row[2], row[3]}, layout, i, size);
    boxes.push_back({{box.x - 0.5 * box.width, box.y - 0.5 * box.height, box.x + 0.5 * box.width,
                      box.y + 0.5 * box.height},
                     static_cast<int>(category),
                     score});
  }
  constexpr double kLargestFraction = 2.0;
  const bool in_px = layout != OutputLayout::kDarknet && layout != OutputLayout::kYolox;
  if (in_px && largest <= kLargestFraction) {
    for (auto& [box, category, score] : boxes) {
      box = {box.left_px * size.width, box.top_px * size.height, box.right_px * size.width,
             box.bottom_px * size.height};
    }
  }
  return boxes;
}

std::vector<RawBox> SuppressOverlaps(std::vector<RawBox> boxes, double max_overlap) {
  std::ranges::stable_sort(boxes, std::ranges::greater(), &RawBox::score);
  std::vector<RawBox> kept;
  for (const RawBox& box : boxes) {
    const bool hidden = std::ranges::any_of(kept, [&](const RawBox& better) {
      return better.category == box.category &&
             IntersectionOverUnion(better.box, box.box) > max_overlap;
    });
    if (!hidden) kept.push_back(box);
  }
  return kept;
}

std::string KittiClass(const std::string& name) {
  static const std::map<std::string, std::string> kClasses = {
      {"car", "Car"},           {"truck", "Truck"},        {"bus", "Bus"},
      {"train", "Tram"},        {"person", "Pedestrian"},  {"bicycle", "Cyclist"},
      {"motorbike", "Cyclist"}, {"motorcycle", "Cyclist"}, {"chair", "Chair"},
      {"sports ball", "Ball"}};
  const auto found = kClasses.find(name);
  return found == kClasses.end() ? name : found->second;
}

struct DetectorModel::Network {
  DetectorFiles files;
  cv::Size size;
  std::vector<std::string> names;
  cv::dnn::Net net;
  std::vector<std::string> outputs;
  OutputLayout layout = OutputLayout::kDarknet;
  bool any_box = false;  // so far
  float best = 0.0F;     // of what may be objectness or the score of a class, so far

  bool IsDarknet() const { return files.model.extension() == ".cfg"; }
  // YOLOX was trained on values of 0 to 255 in BGR order.
  bool IsYolox() const {
    return layout == OutputLayout::kYolox || layout == OutputLayout::kYoloxDecoded;
  }

  std::vector<cv::Mat> Forward(const cv::Mat& input) {
    net.setInput(cv::dnn::blobFromImage(input, IsYolox() ? 1.0 : 1.0 / 255.0, cv::Size(),
                                        cv::Scalar(), !IsYolox()));
    std::vector<cv::Mat> results;
    OrError(files.model, "a network that runs on such an input",
            [&] { return net.forward(results, outputs), 0; });
    return results;
  }

  std::vector<RawBox> Boxes(const cv::Mat& input, double min_score) {
    const int categories = static_cast<int>(names.size());
    std::vector<RawBox> boxes;
    for (const cv::Mat& output : Forward(input)) {
      const cv::Mat rows = IsDarknet() ? output : RowsOf(output, categories, files.model.string());
      const auto more = DecodeRows(rows, layout, size, categories, min_score);
      for (int i = 0; HasObjectness(layout) && i < rows.rows; ++i) {
        const float* row = rows.ptr<float>(i);
        best = std::max(best, *std::max_element(row + 4, row + rows.cols));
      }
      boxes.insert(boxes.end(), more.begin(), more.end());
      any_box = any_box || !more.empty();
    }
    return boxes;
  }

  // Determines the layout of the outputs by running the network once on an empty image.
  void FindLayout() {
    const cv::Mat empty(size, CV_8UC3, cv::Scalar::all(0));
    const int categories = static_cast<int>(names.size());
    for (const cv::Mat& output : Forward(empty)) {
      if (IsDarknet() && output.dims == 2) continue;
      const cv::Mat rows = RowsOf(output, categories, files.model.string());
      const auto found = IsDarknet() ? std::nullopt : LayoutOf(rows, size, categories);
      if (!found && !files.layout) {
        ThrowError(files.model.string(), StrCat(rows.rows, " rows of ", rows.cols, " numbers"),
                   StrCat("boxes of YOLO for an --input of ", size.width, "x", size.height,
                          ", or --layout NAME that tells what they are"));
      }
      layout = files.layout ? *files.layout : *found;
    }
    Boxes(empty, 2.0);
  }
};

DetectorModel::DetectorModel(const DetectorFiles& files) : network_(new Network) {
  // Problems are reported once, by the exception.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  Network& network = *network_;
  network.files = files;
  network.names = ReadNames(files.names);
  network.net = ReadNetwork(files);
  network.net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
  network.net.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
  network.outputs = network.net.getUnconnectedOutLayersNames();
  network.size = files.input;
  if (network.size.empty()) {
    constexpr int kOnnxSize_px = 640;
    network.size = network.IsDarknet()
                       ? cv::Size(NetSize(files.model, "width"), NetSize(files.model, "height"))
                       : cv::Size(kOnnxSize_px, kOnnxSize_px);
  }
  network.FindLayout();
}

DetectorModel::~DetectorModel() = default;

std::vector<Detection> DetectorModel::Detect(const cv::Mat& image, const DetectorOptions& options) {
  Network& network = *network_;
  cv::Mat colour = image;
  if (image.channels() == 1) cv::cvtColor(image, colour, cv::COLOR_GRAY2BGR);
  cv::Mat input;
  const Letterbox letterbox = FillInput(
      colour, network.size, network.IsYolox() ? Placement::kTopLeft : Placement::kCentered, input);
  std::vector<Detection> detections;
  for (const RawBox& raw :
       SuppressOverlaps(network.Boxes(input, options.min_score), options.max_overlap)) {
    const ImageBox box = letterbox.ToImage(raw.box);
    const ImageBox inside = {std::max(0.0, box.left_px), std::max(0.0, box.top_px),
                             std::min(image.cols - 1.0, box.right_px),
                             std::min(image.rows - 1.0, box.bottom_px)};
    if (!(inside.Width() > 0.0) || !(inside.Height() > 0.0)) continue;
    Detection detection;
    detection.box = inside;
    detection.category = network.names.at(static_cast<std::size_t>(raw.category));
    detection.score = raw.score;
    detections.push_back(std::move(detection));
  }
  return detections;
}

void DetectorModel::CheckClasses() const {
  const Network& network = *network_;
  const std::size_t names = network.names.size();
  if (network.any_box || network.best < 0.5F || network.IsDarknet() || network.files.layout) return;
  ThrowError(network.files.model.string(),
             StrCat("no box, but scores up to ", network.best, ", as of ",
                    NameOf(OutputLayout::kYolov8), " with ", names + 1, " classes"),
             StrCat("as many names as classes (", network.files.names.string(), " has ", names,
                    "), or --layout ", NameOf(network.layout)));
}

OutputLayout DetectorModel::layout() const { return network_->layout; }
cv::Size DetectorModel::input() const { return network_->size; }

}  // namespace cvo
