// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <memory>

#include "core/base/error.h"
#include "core/files/json.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/sequence_flags.h"
#include "experiments/cli/run/text_table.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/plausibility.h"
#include "experiments/datasets/sequence.h"
#include "experiments/datasets/sequence_type.h"
#include "experiments/record/result_file.h"

namespace cvo {
namespace {

struct Rate {
  double duration_s = 0.0;
  double median_hz = 0.0;
  double longest_gap_s = 0.0;
};

Rate RateOf(const std::vector<std::int64_t>& timestamps_ns) {
  Rate rate;
  if (timestamps_ns.size() < 2) return rate;
  std::vector<double> gaps_s;
  for (std::size_t i = 1; i < timestamps_ns.size(); ++i) {
    gaps_s.push_back(1e-9 * static_cast<double>(timestamps_ns[i] - timestamps_ns[i - 1]));
  }
  std::sort(gaps_s.begin(), gaps_s.end());
  rate.duration_s = 1e-9 * static_cast<double>(timestamps_ns.back() - timestamps_ns.front());
  rate.median_hz = 1.0 / gaps_s[gaps_s.size() / 2];
  rate.longest_gap_s = gaps_s.back();
  return rate;
}

std::ptrdiff_t FramesWithTruth(const Sequence& sequence) {
  const auto& truth = sequence.groundtruth_world_from_camera;
  return std::count_if(truth.begin(), truth.end(), [](const auto& pose) { return !!pose; });
}

std::vector<std::string> Warnings(const Sequence& sequence) {
  const std::unique_ptr<BodyTruthReader> bodies = ReadBodyTruth(sequence);
  return FindImplausible(sequence, bodies ? &bodies->objects() : nullptr);
}

Json InfoJson(const Sequence& sequence) {
  const Rate rate = RateOf(sequence.timestamps_ns);
  const StereoCamera& camera = sequence.camera;
  return {{"name", sequence.name},
          {"type", sequence.type},
          {"dataset", sequence.dataset},
          {"folder", sequence.folder.string()},
          {"pair", sequence.pair},
          {"first_frame", sequence.first_frame},
          {"frames", sequence.images.size()},
          {"total_frames", sequence.total_frames},
          {"duration_s", rate.duration_s},
          {"median_rate_hz", rate.median_hz},
          {"longest_gap_s", rate.longest_gap_s},
          {"camera", ToJson(CameraOf(camera))},
          {"groundtruth", sequence.groundtruth},
          {"groundtruth_frames", FramesWithTruth(sequence)},
          {"labels", sequence.labels.size()},
          {"detections", sequence.detections.size()},
          {"missing", sequence.missing},
          {"warnings", Warnings(sequence)}};
}

void PrintInfo(const Sequence& sequence) {
  const Rate rate = RateOf(sequence.timestamps_ns);
  const StereoCamera& camera = sequence.camera;
  const auto last_frame =
      sequence.first_frame + static_cast<std::ptrdiff_t>(sequence.images.size());
  TextTable table({"sequence", sequence.name});
  table.Add({"type", sequence.type});
  table.Add({"data set", sequence.dataset});
  table.Add({"folder", sequence.folder.string()});
  table.Add({"frames", StrCat(sequence.images.size(), " (", sequence.first_frame, " to ",
                              last_frame - 1, " of ", sequence.total_frames, ")")});
  table.Add(
      {"rate", StrCat(ReadableNumber(rate.median_hz), " Hz, ", ReadableNumber(rate.duration_s),
                      " s, longest gap ", ReadableNumber(rate.longest_gap_s), " s")});
  table.Add({"images", StrCat(sequence.pair, ", ", camera.width_px, "x", camera.height_px, " px")});
  table.Add({"calibration",
             StrCat("fx ", ReadableNumber(camera.fx), ", fy ", ReadableNumber(camera.fy), ", cx ",
                    ReadableNumber(camera.cx), ", cy ", ReadableNumber(camera.cy), " px, baseline ",
                    ReadableNumber(camera.baseline_m), " m, u_right shifted by ",
                    ReadableNumber(camera.right_shift_px), " px")});
  table.Add(
      {"ground truth", StrCat(sequence.groundtruth, ", ", FramesWithTruth(sequence), " frames")});
  table.Add({"labels", StrCat(sequence.labels.size(), " boxes")});
  table.Add({"detections", StrCat(sequence.detections.size(), " boxes")});
  for (const std::string& line : sequence.missing) table.Add({"missing", line});
  for (const std::string& line : Warnings(sequence)) table.Add({"hardly true", line});
  table.Print(std::cout);
}

// Several sequences below the folder: their list.
int ListSequences(const std::vector<FoundSequence>& found, bool json) {
  if (json) {
    Json list = Json::array();
    for (const FoundSequence& sequence : found) {
      list.push_back({{"folder", sequence.folder.string()}, {"type", sequence.type}});
    }
    std::cout << DumpJson(list);
    return 0;
  }
  TextTable table({"sequence", "type"});
  for (const FoundSequence& sequence : found) {
    table.Add({sequence.folder.string(), sequence.type});
  }
  table.Print(std::cout);
  return 0;
}

int ShowInfo(const SequenceFlags& flags, bool json) {
  const SequenceRequest request = flags.Request();
  if (request.type.empty() && DetectSequenceType(NormalFolder(request.folder)).empty()) {
    const std::vector<FoundSequence> found = FindSequences(request.folder);
    if (!found.empty()) return ListSequences(found, json);
  }
  const Sequence sequence = OpenSequence(request);
  if (json) {
    std::cout << DumpJson(InfoJson(sequence));
  } else {
    PrintInfo(sequence);
  }
  return 0;
}

}  // namespace

Command AddInfoCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "info", "Describe a sequence folder: frames, rate, calibration, ground truth, missing files");
  const auto flags = std::make_shared<SequenceFlags>();
  const auto json = std::make_shared<bool>(false);
  flags->AddTo(*app);
  app->add_flag("--json", *json, "print JSON");
  app->footer(
      "For a folder that contains several sequences, lists them.\n"
      "Example: clustervo info kitti_raw/2011_09_26/2011_09_26_drive_0001_sync");
  return {app, [flags, json] { return ShowInfo(*flags, *json); }};
}

}  // namespace cvo
