// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <opencv2/core/utility.hpp>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/json/json_record.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/run.h"
#include "experiments/datasets/detector_model.h"

namespace cvo {
namespace {

struct DetectFlags {
  SequenceFlags sequence;
  DetectorFiles files;
  DetectorOptions options;
  std::string input;
  std::string output;
  int threads = 1;
};

// Parses an input size such as "960x320". The network's layers halve it up to five times, so both
// must be multiples of 32.
cv::Size ParseInput(const std::string& text) {
  constexpr int kStep_px = 32;
  constexpr std::int64_t kMost_px = 4096;
  const std::size_t cross = text.find('x');
  const auto width = ParseInteger(text.substr(0, cross));
  const auto height =
      cross == std::string::npos ? std::nullopt : ParseInteger(text.substr(cross + 1));
  const auto fits = [](const std::optional<std::int64_t>& px) {
    return px && *px > 0 && *px <= kMost_px && *px % kStep_px == 0;
  };
  if (!fits(width) || !fits(height)) {
    throw UsageError(StrCat("--input: found ", Quoted(text),
                            ", expected WIDTHxHEIGHT in multiples of ", kStep_px, " px up to ",
                            kMost_px));
  }
  return {static_cast<int>(*width), static_cast<int>(*height)};
}

// A row in the format of KITTI tracking results, without track, 3D box and angles.
std::string Row(int frame, const Detection& detection) {
  std::string category = detection.category;
  std::replace(category.begin(), category.end(), ' ', '_');
  std::string row = StrCat(frame, " -1 ", category, " -1 -1 -10");
  const ImageBox& box = detection.box;
  for (const double px : {box.left_px, box.top_px, box.right_px, box.bottom_px}) {
    row += " " + FormatFixed(px, 2);
  }
  return row + " -1 -1 -1 -1000 -1000 -1000 -10 " + FormatFixed(detection.score, 4) + "\n";
}

struct Outcome {
  std::string rows;
  std::size_t boxes = 0;
  std::size_t images_skipped = 0;
  double network_s = 0.0;
};

Outcome DetectAll(const Sequence& sequence, DetectorModel& model, const DetectorOptions& options) {
  using Clock = std::chrono::steady_clock;
  Outcome outcome;
  Progress progress(false);
  for (std::size_t i = 0; i < sequence.images.size(); ++i) {
    // Throws if the file cannot be read: this must not look like an image without boxes.
    const std::string bytes = ReadFileBytes(sequence.images[i].left);
    cv::Mat image = DecodeImage(bytes, cv::IMREAD_COLOR);
    if (image.empty()) {
      progress.Note(sequence.images[i].left.string() + ": cannot be decoded, no boxes");
      ++outcome.images_skipped;
    } else {
      if (sequence.rectification) image = sequence.rectification->Left(image);
      const Clock::time_point start = Clock::now();
      const std::vector<Detection> found = model.Detect(image, options);
      outcome.network_s += std::chrono::duration<double>(Clock::now() - start).count();
      outcome.boxes += found.size();
      for (const Detection& detection : found) {
        outcome.rows += Row(sequence.first_frame + static_cast<int>(i), detection);
      }
    }
    progress.Report(i + 1, sequence.images.size());
  }
  return outcome;
}

int DetectBoxes(DetectFlags& flags) {
  if (!flags.input.empty()) flags.files.input = ParseInput(flags.input);
  flags.files.layout = EnumOf<OutputLayout>(flags.sequence.layout_flag);
  if (flags.files.layout) flags.sequence.layout_flag.clear();
  const Sequence sequence = OpenSequence(flags.sequence.Request());
  std::vector<std::filesystem::path> read = FoldersOf(sequence);
  read.insert(read.end(), {flags.files.model, flags.files.weights, flags.files.names});
  CheckOutputFile(flags.output, read);
  cv::setNumThreads(flags.threads);
  DetectorModel model(flags.files);
  const Outcome outcome = DetectAll(sequence, model, flags.options);
  model.CheckClasses();
  WriteOutputFile(flags.output, outcome.rows, read);
  const std::size_t frames = sequence.images.size() - outcome.images_skipped;
  std::cout << sequence.name << ": " << outcome.boxes << " boxes in " << frames << " frames";
  if (outcome.images_skipped > 0) std::cout << ", " << outcome.images_skipped << " skipped";
  if (outcome.boxes == 0) {
    std::cout << "\nno box has the minimum score (--min-score " << flags.options.min_score
              << "): are --names, --input and the layout those of the network?";
  }
  std::cout << "\nnetwork: " << NameOf(model.layout()) << ", input " << model.input().width << "x"
            << model.input().height << " px, "
            << FrameRateText(static_cast<double>(frames) / std::max(1e-9, outcome.network_s))
            << "\nwritten: " << flags.output << '\n';
  return 0;
}

}  // namespace

Command AddDetectCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "detect", "Find 2D boxes in the left images of a sequence with a YOLO network");
  const auto flags = std::make_shared<DetectFlags>();
  const FlagAdder add{*app};
  add("SEQUENCE", flags->sequence.folder, "", "folder of a sequence, as for run")->required();
  flags->sequence.AddLayoutTo(*app);
  add("--pair", flags->sequence.pair, "NAME",
      "images to read, grey or colour; default: grey if present, otherwise colour");
  add("--frames", flags->sequence.frames, "A:B", "frames A to B-1, counted from 0; default: all");
  add("--model", flags->files.model, "FILE", "network: Darknet .cfg, or .onnx")->required();
  add("--weights", flags->files.weights, "FILE",
      "Darknet weights; default: beside the .cfg, with the same name");
  add("--names", flags->files.names, "FILE", "names of the classes, one per line")->required();
  add("--input", flags->input, "WxH",
      "size of the network's input; default: that of the .cfg, or 640x640");
  add("--min-score", flags->options.min_score, "SCORE", "minimum score of a box")
      ->check(Within(0.0, 1.0))
      ->capture_default_str();
  add("--max-overlap", flags->options.max_overlap, "NUMBER",
      "non-maximum suppression: of boxes of the same class that overlap by more than this "
      "intersection over union, only the best is kept")
      ->check(Within(0.0, 1.0))
      ->capture_default_str();
  add("-t,--threads", flags->threads, "N", "threads of the network")
      ->check(Within(1, 256))
      ->capture_default_str();
  add("-o,--output", flags->output, "FILE", "file to write, in KITTI tracking's format")
      ->required();
  app->footer(
      "The layout of a network's output is found by its sizes and values. Where these leave it "
      "open,\n--layout NAME states it: yolox, yolox_decoded, yolov5, yolov8 or end2end.\n"
      "COCO's classes become KITTI's (car: Car, person: Pedestrian). No network is included.\n"
      "Example: clustervo detect drive_0013 --model yolov3.cfg --names coco.names -o boxes.txt\n"
      "         clustervo run drive_0013 -o results/0013 --variant full --detections boxes.txt");
  return {app, [flags] { return DetectBoxes(*flags); }};
}

}  // namespace cvo
