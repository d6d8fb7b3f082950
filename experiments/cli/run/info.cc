// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo info.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/run.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/plausibility.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/run_files.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct InfoFlags {
  SequenceFlags sequence;
  std::string output;  // of the import
  bool quiet = false;
};

std::ptrdiff_t FramesWithTruth(const Sequence& sequence) {
  const auto& truth = sequence.groundtruth_world_from_camera;
  return std::count_if(truth.begin(), truth.end(), [](const auto& pose) { return !!pose; });
}

// Of frames whose left image is the file of the one before, byte for byte.
std::size_t CountRepeated(const Sequence& sequence) {
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < sequence.images.size(); ++i) {
    const auto &before = sequence.images[i - 1].left, &image = sequence.images[i].left;
    if (fs::file_size(before) != fs::file_size(image)) continue;
    repeated += ReadFileBytes(before) == ReadFileBytes(image) ? 1 : 0;
  }
  return repeated;
}

std::vector<std::string> Warnings(const Sequence& sequence) {
  ReadBodyTruth(sequence);  // throws Error if files contradict each other
  return FindImplausible(sequence, CountRepeated(sequence), DefaultThreads());
}

std::string DetectionsText(const Sequence& sequence) {
  const std::vector<std::string> levels = DetectorLevels(sequence.folder);
  return StrCat(sequence.detections.size(), " boxes",
                levels.empty() ? "" : "; --detections has " + Joined(levels, ", "));
}

// Whether the frame rate is assumed: the data set states no times, or the record of the import says
// so.
bool HasAssumedRate(const Sequence& sequence) {
  if (sequence.is_rate_assumed) return true;
  const fs::path import = sequence.folder / kImportRecord;
  return fs::exists(import) && ReadJson(import).value("times", "") == "nominal";
}

std::string RateText(const Sequence& sequence) {
  std::vector<double> steps_s = TimeSteps(sequence);
  double duration_s = 0.0;
  for (const double step_s : steps_s) duration_s += step_s;
  const double longest_s = steps_s.empty() ? 0.0 : *std::ranges::max_element(steps_s);
  const double rate_hz = steps_s.empty() ? 0.0 : 1.0 / Median(std::move(steps_s));
  return StrCat(ReadableNumber(rate_hz), " Hz",
                HasAssumedRate(sequence) ? " (assumed: no timestamps were given)" : "",
                ", duration ", ReadableNumber(duration_s), " s, longest gap ",
                ReadableNumber(longest_s), " s");
}

// In rectified images, corresponding points lie in the same row.
std::string RowsText(const PairCheck& pair) {
  return StrCat(ReadableNumber(pair.row_error_px), " px (median of ", pair.matches,
                " matches in frame ", pair.frame, "); median disparity ",
                ReadableNumber(pair.disparity_px), " px");
}

void PrintInfo(const Sequence& sequence, const std::optional<PairCheck>& pair) {
  const StereoCamera& camera = sequence.camera;
  const auto last_frame =
      sequence.first_frame + static_cast<std::ptrdiff_t>(sequence.images.size());
  TextTable table({"sequence", sequence.name});
  table.Add({"type", sequence.type});
  table.Add({"data set", sequence.dataset});
  table.Add({"folder", sequence.folder.string()});
  table.Add({"frames", StrCat(sequence.images.size(), " (", sequence.first_frame, " to ",
                              last_frame - 1, " of ", sequence.total_frames, ")")});
  table.Add({"rate", RateText(sequence)});
  table.Add({"images", StrCat(sequence.pair, ", ", camera.width_px, "x", camera.height_px, " px")});
  table.Add({"calibration",
             StrCat("fx ", ReadableNumber(camera.fx), ", fy ", ReadableNumber(camera.fy), ", cx ",
                    ReadableNumber(camera.cx), ", cy ", ReadableNumber(camera.cy), " px, baseline ",
                    ReadableNumber(camera.baseline_m), " m, u_right shifted by ",
                    ReadableNumber(camera.right_shift_px), " px")});
  table.Add(
      {"row error", pair ? RowsText(*pair) : "not known: too few matches in the middle frame"});
  table.Add(
      {"ground truth", StrCat(sequence.groundtruth, ", ", FramesWithTruth(sequence), " frames")});
  table.Add({"labels", StrCat(sequence.labels.size(), " boxes")});
  table.Add({"detections", DetectionsText(sequence)});
  for (const std::string& line : sequence.missing) table.Add({"missing", line});
  for (const std::string& line : Warnings(sequence)) table.Add({"note", line});
  table.Print(std::cout);
}

// Writes the user's images as a sequence to the output folder.
void Import(const InfoFlags& flags) {
  const StereoImport& stereo = flags.sequence.stereo;
  CheckStereo(stereo);
  CheckNotBelow(InputsOf(stereo), flags.output);
  CheckNewSequence(flags.output, {});
  const ImportOutcome outcome =
      ImportStereo(stereo, flags.output, Progress(flags.quiet).Reporter());
  for (const std::string& line : outcome.damaged) std::cout << "lost: " << line << '\n';
  std::cout << "written: " << flags.output << ", images "
            << (outcome.rectified ? "rectified" : "used as they are") << "\n\n";
}

int ShowInfo(const InfoFlags& flags) {
  SequenceFlags sequence_flags = flags.sequence;
  if (!flags.output.empty()) {
    Import(flags);
    sequence_flags.stereo = {};
    sequence_flags.folder = flags.output;
  }
  const SequenceRequest request = sequence_flags.Request(flags.quiet);
  if (request.type.empty() && DetectSequenceType(NormalFolder(request.folder)).empty()) {
    TextTable table({"sequence", "type"});
    const std::vector<FoundSequence> below = FindSequences(request.folder);
    for (const FoundSequence& found : below) table.Add({found.folder.string(), found.type});
    if (!below.empty()) {
      table.Print(std::cout);
      return 0;
    }
  }
  const Sequence sequence = OpenSequence(request);
  PrintInfo(sequence, CheckMiddlePair(sequence));
  return 0;
}

}  // namespace

Command AddInfoCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "info", "Describe a sequence folder: frames, rate, calibration, ground truth, missing files");
  const auto flags = std::make_shared<InfoFlags>();
  flags->sequence.AddTo(*app);
  FlagAdder{*app}("-o,--output", flags->output, "FOLDER",
                  "with --left: where to keep the sequence, in the layout of KITTI odometry, to "
                  "use it in a suite; default: the cache");
  AddQuiet(*app, flags->quiet);
  app->footer(
      "For a folder that contains several sequences, lists them.\n"
      "Examples:\n"
      "  clustervo info kitti_raw/2011_09_26/2011_09_26_drive_0001_sync\n"
      "  clustervo info --left cam0 --right cam1 --calib camchain.yaml");
  return {app, [flags] { return ShowInfo(*flags); }};
}

}  // namespace cvo
