// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo eval trajectory: trajectories of any system against a file or a sequence.
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/text/number.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "experiments/cli/run/run.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/system_run.h"
#include "experiments/suite/build_plan.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct TrajectoryFlags {
  std::string groundtruth;
  std::string estimate;
  bool json = false;
  SequenceFlags sequence;  // scored against its own truth; without a folder: two files
  double max_time_difference_s = 1e-9 * static_cast<double>(kDefaultAssociation_ns);
  std::string objects;
  std::string name;
  std::string output;
  double right_shift_px = 0.0;
};

int EvaluateFiles(const TrajectoryFlags& flags) {
  std::vector<PlotInput> inputs = {ReadPlotInput(flags.groundtruth), ReadPlotInput(flags.estimate)};
  MakeComparable(inputs);
  const Trajectory& truth = inputs[0].poses;
  const Trajectory& estimate = inputs[1].poses;
  const TimeAssociation association = AssociateByTime(
      truth, estimate, static_cast<std::int64_t>(std::llround(1e9 * flags.max_time_difference_s)));
  const std::size_t matched = association.pairs.size();
  if (matched < 2) {
    ThrowError(flags.estimate, StrCat(matched, " poses that match one of the truth"),
               StrCat("2 or more within ", flags.max_time_difference_s, " s"));
  }
  OptionalPoses true_poses;
  for (const TimedPose& pose : truth) true_poses.emplace_back(pose.world_from_camera);
  std::vector<Metric> metrics = EvaluateCamera(
      true_poses, PosesAtFrames(association, truth.size(), estimate), reports::TruthSource::kFile);
  StatePoses(reports::PoseTime::kFile, 0.0, metrics);
  for (const PlotInput& input : inputs) {
    if (input.left_out > 0) {
      std::cerr << "note: " << input.path << ": " << input.left_out << " rows of NaN left out\n";
    }
    if (input.has_rotations) continue;
    std::cerr << "note: " << input.path << ": quaternions that are all zero or all the same, so no "
              << "metric of rotations\n";
    std::erase_if(metrics, [](const Metric& metric) {
      return !metric.name.starts_with("camera_ate") && metric.name != "camera_coverage" &&
             metric.name != "camera_path_error";
    });
  }
  if (flags.json) {
    std::cout << DumpJson({{"schema_version", 2},
                           {"kind", "evaluation"},
                           {"matched", matched},
                           {"unmatched_groundtruth", association.unmatched_a},
                           {"unmatched_estimate", association.unmatched_b},
                           {"metrics", ToJson(metrics)}});
    return 0;
  }
  std::cout << matched << " poses matched, unmatched: " << association.unmatched_a
            << " of the ground truth, " << association.unmatched_b << " of the estimate\n\n";
  PrintMetrics(metrics, std::cout);
  return 0;
}

constexpr const char* kResult = "result.json";

// Throws Error for the folder of a run: its result would be lost, and its other files would be
// taken for those of the system.
void RefuseRunFolder(const fs::path& folder) {
  for (const std::string& name : RunFileNames()) {
    if (name == kResult || !fs::exists(folder / name)) continue;
    ThrowError(folder.string(), name + " of a run", "a folder without");
  }
}

void PrintOutcome(const Sequence& sequence, const TrajectoryFlags& flags,
                  const SystemOutcome& outcome) {
  const auto frames = static_cast<int>(sequence.images.size());
  std::cout << sequence.name << ": poses of " << frames - outcome.frames_without_camera << " of "
            << frames << " frames";
  if (!flags.objects.empty()) {
    std::cout << ", objects in " << outcome.object_frames << " object-frames";
    if (outcome.object_frames_left_out > 0) {
      std::cout << ", " << outcome.object_frames_left_out << " of them in frames without a pose";
    }
  }
  std::cout << '\n';
  if (outcome.metrics.empty()) {
    std::cout << "no metrics: the sequence has no ground truth\n";
    return;
  }
  std::cout << '\n';
  PrintMetrics(outcome.metrics, std::cout);
  if (!flags.objects.empty() && outcome.bodies.empty()) {
    std::cout << "\nobjects not scored: the sequence has no ground truth of its bodies\n";
  }
  if (outcome.bodies.empty()) return;
  std::cout << "\nbodies:\n";
  PrintBodies(outcome.bodies, outcome.metrics, std::cout);
}

int EvaluateSequence(const TrajectoryFlags& flags) {
  const std::string& estimate = flags.estimate;
  const Sequence sequence = OpenSequence(flags.sequence.Request());
  std::unique_ptr<const OutputFolder> output;
  if (!flags.output.empty()) {
    RefuseRunFolder(flags.output);
    std::vector<fs::path> read = FoldersOf(sequence);
    read.insert(read.end(), {estimate, flags.objects});
    output.reset(new OutputFolder(OpenOutput(flags.output, {kResult}, read)));
  }
  RequireAsRendered(sequence);
  const std::string name = flags.name.empty() ? fs::path(estimate).stem().string() : flags.name;
  SystemRequest request{sequence, "", {name, estimate, flags.objects}, 0, flags.right_shift_px};
  if (flags.json || output) {
    ReadSystem(sequence, request.files);  // reports bad files before the images are hashed
    const std::vector<ImageHashes> images = HashImages(sequence);
    request.content = ContentHash(sequence, images);
    request.images = ImagesHash(images);
  }
  const SystemOutcome outcome = ScoreSystem(request);
  if (output) WriteFilesAtomically(output->path(), {{kResult, outcome.result}});
  if (flags.json) {
    std::cout << outcome.result;
  } else {
    PrintOutcome(sequence, flags, outcome);
  }
  return 0;
}

// Flags that have a meaning only with a sequence, or only with two files.
const std::vector<std::string> kOfSequence = {"--type",   "--pair",          "--frames",
                                              "--labels", "--labels-camera", "--objects",
                                              "--name",   "--output",        "--right-shift"};
const std::vector<std::string> kOfFiles = {"--max-time-difference"};

void CheckUsage(const CLI::App& app, const TrajectoryFlags& flags) {
  if (app.count("--sequence") > 0) {
    RefuseFlags(
        app, kOfFiles,
        "applies to two files; a sequence has its own ground truth, times and tolerance, 0.02 s");
    return;
  }
  if (flags.groundtruth.empty()) {
    throw CLI::ValidationError("--groundtruth is required unless --sequence is given");
  }
  RefuseFlags(app, kOfSequence, "needs --sequence");
}

Command AddTrajectoryCommand(CLI::App& eval) {
  CLI::App* app = eval.add_subcommand(
      "trajectory", "Score a trajectory file, or the results of another system on a sequence");
  const auto flags = std::make_shared<TrajectoryFlags>();
  const FlagAdder add{*app};
  add("--groundtruth", flags->groundtruth, "FILE",
      "ground truth: a file in the format of TUM, KITTI or EuRoC");
  add("--estimate", flags->estimate, "FILE", "trajectory file")->required();
  add("--sequence", flags->sequence.folder, "FOLDER",
      "use the ground truth of this sequence instead of a file");
  app->add_flag("--json", flags->json, "print JSON, with the contract of each metric");
  flags->sequence.AddTruthTo(*app);
  add("--max-time-difference", flags->max_time_difference_s, "SECONDS",
      "maximum time difference of matching TUM poses")
      ->check(Within(0.0, 1e6))
      ->capture_default_str();
  add("--objects", flags->objects, "FILE|FOLDER",
      "KITTI tracking rows with 3D boxes, or a folder of <id>.tum files");
  add("--name", flags->name, "NAME", "name of the system; default: the estimate's file name");
  add("-o,--output", flags->output, "FOLDER", "folder for result.json, in the format of a run");
  add("--right-shift", flags->right_shift_px, "PX",
      "rectification correction applied to the system's input; default: 0, as published")
      ->check(Within(-100.0, 100.0));
  for (const std::string& flag : kOfSequence) app->get_option(flag)->group("With --sequence");
  app->footer(
      "Poses are world_from_camera. For ATE, the estimate is aligned by SE(3) over "
      "positions.\nWith --sequence, camera and objects are scored in the same way as a run. "
      "Objects are KITTI\ntracking rows with 3D boxes in rectified camera 0, or a folder of "
      "<id>.tum files with\nworld_from_object. They have no landmarks and are therefore matched to "
      "ground-truth bodies by\ndistance, as the contracts state; unlike in run, velocities are "
      "differences of their poses.\n"
      "Examples:\n"
      "  clustervo eval trajectory --groundtruth poses/06.txt --estimate OUT/camera.kitti\n"
      "  clustervo eval trajectory --sequence scenes/indoor_1 --estimate cam.tum \\\n"
      "      --objects tracks.kitti --name other -o results/other_indoor_1");
  app->final_callback([app, flags] { CheckUsage(*app, *flags); });
  return {app, [flags] {
            return flags->sequence.folder.empty() ? EvaluateFiles(*flags)
                                                  : EvaluateSequence(*flags);
          }};
}

}  // namespace

Command AddEvalCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand("eval", "Score trajectories or boxes of any system");
  return Group(*app, {AddTrajectoryCommand(*app), AddEvalBoxesCommand(*app)});
}

}  // namespace cvo
