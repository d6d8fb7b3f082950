// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo eval boxes: scores boxes in KITTI's file formats as KITTI's benchmarks do.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "experiments/cli/command.h"
#include "experiments/metrics/boxes/average_precision.h"
#include "experiments/metrics/boxes/tracking_scores.h"

namespace cvo {
namespace {

struct BoxFlags {
  std::vector<std::string> labels;  // of each sequence
  std::vector<std::string> estimate;
  std::string frames;  // "A:B"; empty: all
  std::string score = "ap";
  std::string category = "Car";
  std::optional<double> least_overlap;  // default: the benchmark's for the class
  std::string truncation = "applied";
};

using Boxes = std::vector<ObjectBox> ApFrame::*;

template <typename Has>
bool AnyDetection(const std::vector<ApFrame>& frames, const Has& has) {
  return std::ranges::any_of(
      frames, [&](const ApFrame& frame) { return std::ranges::any_of(frame.detections, has); });
}

// The frames of all sequences, whose tracks get numbers of their own.
std::vector<ApFrame> ReadSequences(const BoxFlags& flags, const FrameRange& range) {
  std::vector<ApFrame> all;
  int tracks = 0;
  for (std::size_t i = 0; i < flags.labels.size(); ++i) {
    const int first = tracks;
    std::vector<ApFrame> frames =
        ReadApFrames(flags.labels[i], flags.estimate[i], range, flags.score == "tracking");
    CheckScores(frames, flags.estimate[i]);
    for (ApFrame& frame : frames) {
      for (const Boxes boxes : {&ApFrame::labels, &ApFrame::detections}) {
        for (ObjectBox& box : frame.*boxes) {
          if (box.track >= 0) box.track += first;
          tracks = std::max(tracks, box.track + 1);
        }
      }
      all.push_back(std::move(frame));
    }
  }
  CheckScores(all, "--estimate");
  return all;
}

// If there is no 3D box at all, the boxes come from a 2D detector and are only scored in the image;
// if none is in the image, they are only scored in 3D.
std::vector<BoxSpace> SpacesOf(const std::vector<ApFrame>& frames) {
  if (!AnyDetection(frames, [](const ObjectBox& box) { return !!box.box3d; })) {
    return {BoxSpace::kImage};
  }
  if (!AnyDetection(frames, &ObjectBox::IsInImage)) return {BoxSpace::kBirdsEye, BoxSpace::kVolume};
  return {BoxSpace::kImage, BoxSpace::kBirdsEye, BoxSpace::kVolume};
}

// Returns "8 Car, 2 Van".
std::string ClassesText(const std::vector<ApFrame>& frames, Boxes boxes) {
  std::map<std::string, int> counts;
  for (const ApFrame& frame : frames) {
    for (const ObjectBox& box : frame.*boxes) ++counts[box.type];
  }
  const auto text = [](const auto& of_type) { return StrCat(of_type.second, " ", of_type.first); };
  return counts.empty() ? "none" : Joined(counts, ", ", text);
}

// Without a label, no score tells anything.
void RefuseNoLabel(const BoxFlags& flags, const std::vector<ApFrame>& frames, bool any) {
  if (any) return;
  ThrowError(Joined(flags.labels, ", "), "labels: " + ClassesText(frames, &ApFrame::labels),
             StrCat("at least one of ", flags.category, " that the benchmark counts"));
}

std::string Percent(double fraction) { return FormatFixed(100.0 * fraction, 2); }

void PrintAveragePrecisions(const BoxFlags& flags, const std::vector<ApFrame>& frames,
                            std::ostream& out) {
  ApProtocol protocol;
  protocol.category = flags.category;
  protocol.least_overlap = flags.least_overlap.value_or(flags.category == "Car" ? 0.7 : 0.5);
  protocol.truncation = *EnumOf<TruncationRule>(flags.truncation);
  TextTable table({"AP, percent", "points", "easy", "moderate", "hard"});
  std::vector<std::string> counts = {"labels", ""};
  bool few = false;
  for (const BoxSpace space : SpacesOf(frames)) {
    protocol.space = space;
    const auto levels = EvaluateAp(frames, protocol);
    RefuseNoLabel(flags, frames, levels.back().valid_labels > 0);
    for (const bool at_40 : {false, true}) {
      std::vector<std::string> row = {NameOf(space), at_40 ? "40" : "11"};
      for (const AveragePrecision& level : levels) {
        row.push_back(Percent(at_40 ? level.ap40 : level.ap11));
      }
      table.Add(std::move(row));
    }
    if (counts.size() > 2) continue;
    for (const AveragePrecision& level : levels) {
      counts.push_back(std::to_string(level.valid_labels));
      few = few || level.valid_labels < static_cast<int>(kRecallSlots);
    }
  }
  table.Add(std::move(counts));
  out << flags.category << ", IoU > " << protocol.least_overlap << ", truncation limits "
      << flags.truncation << ", DontCare regions in 2D only\n";
  if (few) {
    out << "fewer than " << kRecallSlots << " labels, of which KITTI's devkit would leave recall "
        << "points empty: each point takes the score that reaches it\n";
  }
  out << '\n';
  table.Print(out);
}

// The overlap is used as the similarity.
void PrintTrackingScores(const BoxFlags& flags, const std::vector<ApFrame>& frames,
                         std::ostream& out) {
  TextTable table({"percent", "HOTA", "DetA", "AssA", "LocA", "MOTA", "MOTP", "IDF1", "switches",
                   "fragments", "missed", "false"});
  for (const BoxSpace space : SpacesOf(frames)) {
    if (space == BoxSpace::kBirdsEye) continue;
    const TrackedSequence sequence = CountedBoxes(frames, flags.category, space);
    RefuseNoLabel(flags, frames, sequence.truth_count > 0);
    const HotaScores hota = EvaluateHota(sequence);
    const ClearScores clear = EvaluateClear(sequence);
    table.Add({NameOf(space), Percent(hota.hota), Percent(hota.det_a), Percent(hota.ass_a),
               Percent(hota.loc_a), Percent(clear.mota), Percent(clear.motp),
               Percent(EvaluateIdentities(sequence).idf1), std::to_string(clear.switches),
               std::to_string(clear.fragments), std::to_string(clear.missed),
               std::to_string(clear.false_boxes)});
  }
  out << "matches: intersection over union of at least 0.5 (HOTA, DetA, AssA, LocA: averaged over "
         "thresholds); the image boxes decide which labels and detections count\n\n";
  table.Print(out);
}

int EvaluateBoxes(const BoxFlags& flags) {
  const FrameRange range = flags.frames.empty() ? FrameRange() : ParseFrameRange(flags.frames);
  const bool tracks = flags.score == "tracking";
  for (const std::string& labels : flags.labels) {
    if (!tracks || !std::filesystem::is_directory(labels)) continue;
    ThrowError(labels, "a folder", "a file of KITTI tracking: object files have no tracks");
  }
  const std::vector<ApFrame> frames = ReadSequences(flags, range);
  std::ostringstream scores;
  if (tracks) {
    PrintTrackingScores(flags, frames, scores);
  } else {
    PrintAveragePrecisions(flags, frames, scores);
  }
  std::cout << Counted(frames.size(), "frame")
            << " with boxes; detections: " << ClassesText(frames, &ApFrame::detections) << '\n';
  if (SpacesOf(frames).front() != BoxSpace::kImage) {
    std::cout << "no detection has a box in the image: they count by their 3D boxes alone\n";
  }
  std::cout << scores.str();
  return 0;
}

}  // namespace

Command AddEvalBoxesCommand(CLI::App& eval) {
  CLI::App* app = eval.add_subcommand(
      "boxes", "Score boxes by KITTI's average precision, or tracks by HOTA, CLEAR and IDF1");
  const auto flags = std::make_shared<BoxFlags>();
  const FlagAdder add{*app};
  add("--labels", flags->labels, "FILE|FOLDER ...",
      "labels: a file of KITTI tracking, or a folder of KITTI object files; of several sequences: "
      "scores are over all of their frames")
      ->required();
  add("--estimate", flags->estimate, "FILE|FOLDER ...",
      "boxes to score, of the same kind and in the same order")
      ->required();
  add("--frames", flags->frames, "A:B", "score frames A to B-1");
  add("--score", flags->score, "NAME",
      "ap (average precision), or tracking (HOTA, CLEAR and IDF1, as TrackEval does on KITTI)")
      ->check(OneOf({"ap", "tracking"}))
      ->capture_default_str();
  add("--class", flags->category, "NAME",
      "class to score; as in the benchmark, Van (for Car) and Person_sitting (for Pedestrian) "
      "count neither for nor against")
      ->check(OneOf({"Car", "Pedestrian", "Cyclist"}))
      ->capture_default_str();
  add("--iou", flags->least_overlap, "NUMBER",
      "ap: a match needs a larger intersection over union than this; default: 0.7 for Car, "
      "otherwise 0.5, as in the benchmark")
      ->check(Within(0.0, 1.0));
  add("--truncation", flags->truncation, "RULE",
      "ap: applied (labels truncated beyond a level's limit are ignored at that level; in "
      "tracking files that is every label with truncation 1 or 2) or ignored (no limit)")
      ->check(OneOf({"applied", "ignored"}))
      ->capture_default_str();
  app->footer(
      "Example:\n"
      "  clustervo eval boxes --labels label_02/0003.txt --estimate tracks.kitti --iou 0.25");
  app->final_callback([app, flags] {
    if (flags->labels.size() != flags->estimate.size()) {
      throw UsageError(StrCat("--estimate: ", flags->estimate.size(), " given, expected ",
                              flags->labels.size(), ", as of --labels"));
    }
    if (flags->score == "ap") return;
    RefuseFlags(*app, {"--iou", "--truncation"}, "applies to --score ap");
  });
  return {app, [flags] { return EvaluateBoxes(*flags); }};
}

}  // namespace cvo
