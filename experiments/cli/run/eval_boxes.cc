// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo eval boxes: scores boxes in KITTI's file formats as KITTI's benchmarks do.
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "experiments/cli/command.h"
#include "experiments/metrics/boxes/average_precision.h"

namespace cvo {
namespace {

struct BoxFlags {
  std::string labels;
  std::string estimate;
  std::string frames;  // "A:B"; empty: all
  std::string category = "Car";
  std::optional<double> least_overlap;  // default: the benchmark's for the class
  std::string truncation = "applied";
  bool json = false;
};

// What is printed as JSON.
struct ApOfSpace {
  ApProtocol contract;
  std::vector<AveragePrecision> levels;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("contract", self.contract);
    archive.Field("levels", self.levels);
  }
};

// If there is no 3D box at all, the boxes come from a 2D detector and are only scored in the image.
std::vector<BoxSpace> SpacesOf(const std::vector<ApFrame>& frames) {
  const bool has_3d = std::any_of(frames.begin(), frames.end(), [](const ApFrame& frame) {
    return std::any_of(frame.detections.begin(), frame.detections.end(),
                       [](const ObjectBox& box) { return box.box3d.has_value(); });
  });
  if (!has_3d) return {BoxSpace::kImage};
  return {BoxSpace::kImage, BoxSpace::kBirdsEye, BoxSpace::kVolume};
}

std::vector<ApOfSpace> AveragePrecisions(const BoxFlags& flags,
                                         const std::vector<ApFrame>& frames) {
  std::vector<ApOfSpace> all;
  for (const BoxSpace space : SpacesOf(frames)) {
    ApProtocol protocol;
    protocol.category = flags.category;
    protocol.space = space;
    protocol.least_overlap = flags.least_overlap.value_or(flags.category == "Car" ? 0.7 : 0.5);
    protocol.truncation = *EnumOf<TruncationRule>(flags.truncation);
    const auto levels = EvaluateAp(frames, protocol);
    all.push_back({protocol, {levels.begin(), levels.end()}});
  }
  return all;
}

std::string Percent(double fraction) { return FormatFixed(100.0 * fraction, 2); }

void Print(const std::vector<ApOfSpace>& all, std::ostream& out) {
  const ApProtocol& contract = all.front().contract;
  out << contract.category << ", IoU > " << contract.least_overlap << ", truncation limits "
      << NameOf(contract.truncation) << ", DontCare regions in 2D only\n\n";
  TextTable table({"AP, percent", "points", "easy", "moderate", "hard"});
  for (const ApOfSpace& space : all) {
    for (const bool at_40 : {false, true}) {
      std::vector<std::string> row = {NameOf(space.contract.space), at_40 ? "40" : "11"};
      for (const AveragePrecision& level : space.levels) {
        row.push_back(Percent(at_40 ? level.ap40 : level.ap11));
      }
      table.Add(std::move(row));
    }
  }
  std::vector<std::string> counts = {"labels", ""};
  for (const AveragePrecision& level : all.front().levels) {
    counts.push_back(std::to_string(level.valid_labels));
  }
  table.Add(std::move(counts));
  table.Print(out);
}

std::size_t CountDetections(const std::vector<ApFrame>& frames) {
  std::size_t count = 0;
  for (const ApFrame& frame : frames) count += frame.detections.size();
  return count;
}

int EvaluateBoxes(const BoxFlags& flags) {
  const FrameRange range = flags.frames.empty() ? FrameRange() : ParseFrameRange(flags.frames);
  const std::vector<ApFrame> frames = ReadApFrames(flags.labels, flags.estimate, range);
  const std::vector<ApOfSpace> scores = AveragePrecisions(flags, frames);
  if (flags.json) {
    std::cout << DumpJson({{"schema_version", 1},
                           {"kind", "average precision"},
                           {"frames", frames.size()},
                           {"detections", CountDetections(frames)},
                           {"average_precision", ToJson(scores)}});
    return 0;
  }
  std::cout << frames.size() << " frames, " << CountDetections(frames)
            << " detections of all classes\n";
  Print(scores, std::cout);
  return 0;
}

}  // namespace

Command AddEvalBoxesCommand(CLI::App& eval) {
  CLI::App* app = eval.add_subcommand("boxes", "Score boxes by KITTI's average precision");
  const auto flags = std::make_shared<BoxFlags>();
  const FlagAdder add{*app};
  add("--labels", flags->labels, "FILE|FOLDER",
      "labels: a file of KITTI tracking, or a folder of KITTI object files")
      ->required();
  add("--estimate", flags->estimate, "FILE|FOLDER", "boxes to score, of the same kind")->required();
  add("--frames", flags->frames, "A:B", "score frames A to B-1");
  add("--class", flags->category, "NAME",
      "class to score; as in the benchmark, Van (for Car) and Person_sitting (for Pedestrian) "
      "count neither for nor against")
      ->check(OneOf({"Car", "Pedestrian", "Cyclist"}))
      ->capture_default_str();
  add("--iou", flags->least_overlap, "NUMBER",
      "a match needs a larger intersection over union than this; default: 0.7 for Car, "
      "otherwise 0.5, as in the benchmark")
      ->check(Within(0.0, 1.0));
  add("--truncation", flags->truncation, "RULE",
      "applied (labels truncated beyond a level's limit are ignored at that level; in "
      "tracking files that is every label with truncation 1 or 2) or ignored (no limit)")
      ->check(OneOf({"applied", "ignored"}))
      ->capture_default_str();
  app->add_flag("--json", flags->json, "print JSON, with the contract");
  app->footer(
      "Example:\n"
      "  clustervo eval boxes --labels label_02/0003.txt --estimate tracks.kitti --iou 0.25");
  return {app, [flags] { return EvaluateBoxes(*flags); }};
}

}  // namespace cvo
