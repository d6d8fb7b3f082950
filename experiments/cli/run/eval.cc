// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo eval trajectory and eval clock: trajectories of any system against a file or a
// sequence.
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
#include "experiments/cli/run/run.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/clock_offset.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/system_run.h"
#include "experiments/suite/plan_inputs.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Flags of eval trajectory and, up to `sequence`, of eval clock.
struct TrajectoryFlags {
  std::string groundtruth;  // a file, or which truth of a KITTI raw drive
  std::string estimate;
  bool json = false;
  SequenceFlags sequence;  // scored against its own truth; without a folder: two files
  double most_s = 1.0;     // of the clock offset
  std::string format;
  double max_time_difference_s = 1e-9 * static_cast<double>(kDefaultAssociation_ns);
  std::string objects;
  std::string name;
  std::string output;
  double right_shift_px = 0.0;

  SequenceRequest Request() const {
    SequenceFlags of = sequence;
    if (!groundtruth.empty()) of.groundtruth = groundtruth;
    return of.Request();
  }
};

// True and estimated poses, one each per pose of the ground truth.
struct PairedPoses {
  std::vector<std::optional<RigidTransform>> truth;
  std::vector<std::optional<RigidTransform>> estimate;
  std::size_t matched = 0;
  std::size_t unmatched_truth = 0;
  std::size_t unmatched_estimate = 0;
};

std::string FormatOfBoth(const TrajectoryFlags& flags) {
  if (!flags.format.empty()) return flags.format;
  const std::string truth = DetectPoseFormat(flags.groundtruth);
  const std::string estimate = DetectPoseFormat(flags.estimate);
  if (truth != estimate) {
    ThrowError(flags.estimate, "a trajectory in " + estimate + " format",
               truth + " as in " + flags.groundtruth);
  }
  return truth;
}

PairedPoses PairTum(const TrajectoryFlags& flags) {
  const Trajectory truth = ReadTumTrajectory(flags.groundtruth);
  const Trajectory estimate = ReadTumTrajectory(flags.estimate);
  const auto tolerance_ns =
      static_cast<std::int64_t>(std::llround(1e9 * flags.max_time_difference_s));
  const TimeAssociation association = AssociateByTime(truth, estimate, tolerance_ns);
  PairedPoses poses;
  for (const TimedPose& pose : truth) poses.truth.emplace_back(pose.world_from_camera);
  poses.estimate = PosesAtFrames(association, truth.size(), estimate);
  poses.matched = association.pairs.size();
  poses.unmatched_truth = association.unmatched_a;
  poses.unmatched_estimate = association.unmatched_b;
  return poses;
}

PairedPoses PairKitti(const TrajectoryFlags& flags) {
  const std::vector<RigidTransform> truth = ReadKittiPoses(flags.groundtruth);
  const std::vector<RigidTransform> estimate = ReadKittiPoses(flags.estimate);
  if (truth.size() != estimate.size()) {
    ThrowError(flags.estimate, StrCat(estimate.size(), " poses"),
               StrCat(truth.size(), ", one per line of ", flags.groundtruth,
                      " (KITTI files have no times to match by)"));
  }
  PairedPoses poses;
  poses.truth.assign(truth.begin(), truth.end());
  poses.estimate.assign(estimate.begin(), estimate.end());
  poses.matched = truth.size();
  return poses;
}

int EvaluateFiles(const TrajectoryFlags& flags) {
  const PairedPoses poses = FormatOfBoth(flags) == "tum" ? PairTum(flags) : PairKitti(flags);
  if (poses.matched < 2) {
    ThrowError(flags.estimate, StrCat(poses.matched, " poses that match one of the truth"),
               StrCat("2 or more within ", flags.max_time_difference_s, " s"));
  }
  if (poses.matched < poses.unmatched_estimate) {
    PrintNotice(StrCat("note: only ", poses.matched, " of ",
                       poses.matched + poses.unmatched_estimate, " poses of ", flags.estimate,
                       " match one of the truth within ", flags.max_time_difference_s, " s"));
  }
  std::vector<Metric> metrics =
      EvaluateCamera(poses.truth, poses.estimate, reports::TruthSource::kFile);
  StatePoses(reports::PoseTime::kFile, 0.0, metrics);
  if (flags.json) {
    std::cout << DumpJson({{"schema_version", 2},
                           {"kind", "evaluation"},
                           {"matched", poses.matched},
                           {"unmatched_groundtruth", poses.unmatched_truth},
                           {"unmatched_estimate", poses.unmatched_estimate},
                           {"metrics", ToJson(metrics)}});
    return 0;
  }
  std::cout << poses.matched << " poses matched, unmatched: " << poses.unmatched_truth
            << " of the ground truth, " << poses.unmatched_estimate << " of the estimate\n\n";
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
  const Sequence sequence = OpenSequence(flags.Request());
  std::unique_ptr<const OutputFolder> output;
  if (!flags.output.empty()) {
    RefuseRunFolder(flags.output);
    std::vector<fs::path> read = FoldersOf(sequence);
    read.insert(read.end(), {estimate, flags.objects});
    output.reset(new OutputFolder(OpenOutput(flags.output, {kResult}, read)));
  }
  RequireAsRendered(sequence, HashesByReading);
  const std::string name = flags.name.empty() ? fs::path(estimate).stem().string() : flags.name;
  SystemRequest request{sequence, "", {name, estimate, flags.objects}, 0, flags.right_shift_px};
  if (flags.json || output) {
    ReadSystem(sequence, request.files);  // reports bad files before the images are hashed
    request.content = ContentHash(sequence, HashImages(sequence));
  }
  const SystemOutcome outcome =
      output ? ScoreSystem(request, output->path()) : ScoreSystem(request);
  if (flags.json) {
    std::cout << outcome.result;
  } else {
    PrintOutcome(sequence, flags, outcome);
  }
  return 0;
}

Trajectory ReadTimed(const std::string& path) {
  if (DetectPoseFormat(path) != "tum") {
    ThrowError(path, "a trajectory in kitti format", "tum: clocks are compared by times");
  }
  return ReadTumTrajectory(path);
}

Trajectory AtFrames(const OptionalPoses& poses, const Sequence& sequence) {
  Trajectory trajectory;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (poses[i]) trajectory.push_back({sequence.timestamps_ns[i], *poses[i]});
  }
  return trajectory;
}

int Print(const ClockOffset& clock, bool json) {
  if (json) {
    std::cout << DumpJson(
        {{"schema_version", 1}, {"kind", "clock offset"}, {"clock", ToJson(clock)}});
    return 0;
  }
  std::cout << "clock offset (ground truth minus estimate): " << (clock.offset_s > 0.0 ? "+" : "")
            << FormatFixed(clock.offset_s, 5) << " s, standard deviation "
            << FormatFixed(clock.deviation_s, 5) << " s\n"
            << "rotation rates of " << clock.pairs
            << " pairs of consecutive poses: " << FormatFixed(100.0 * clock.explained, 1)
            << " % explained, residual " << FormatFixed(clock.residual_rad_per_s, 5) << " rad/s\n";
  return 0;
}

int EstimateClock(const TrajectoryFlags& flags) {
  if (flags.sequence.folder.empty()) {
    return Print(
        EstimateClockOffset(ReadTimed(flags.groundtruth), ReadTimed(flags.estimate), flags.most_s),
        flags.json);
  }
  const Sequence sequence = OpenSequence(flags.Request());
  const Trajectory truth = sequence.truth_track.empty()
                               ? AtFrames(sequence.groundtruth_world_from_camera, sequence)
                               : sequence.truth_track;
  if (truth.empty()) ThrowError(sequence.folder.string(), "no ground truth of the camera", "one");
  const SystemEstimate system = ReadSystem(sequence, {"", flags.estimate, ""});
  return Print(EstimateClockOffset(truth, AtFrames(system.objects.world_from_camera, sequence),
                                   flags.most_s),
               flags.json);
}

// Flags that have a meaning only with a sequence, or only with two files.
const std::vector<std::string> kOfSequence = {
    "--type",          "--dataset", "--pair", "--frames", "--labels",
    "--labels-camera", "--objects", "--name", "--output", "--right-shift"};
const std::vector<std::string> kOfFiles = {"--format", "--max-time-difference"};

void CheckUsage(const CLI::App& app, const TrajectoryFlags& flags) {
  if (app.count("--sequence") > 0) {
    RefuseFlags(app, kOfFiles,
                "applies to two files; a sequence has its own times and tolerance, 0.02 s");
    return;
  }
  if (flags.groundtruth.empty()) {
    throw CLI::ValidationError("--groundtruth is required unless --sequence is given");
  }
  RefuseFlags(app, kOfSequence, "needs --sequence");
}

void AddInputs(CLI::App& app, TrajectoryFlags& flags) {
  const FlagAdder add{app};
  add("--groundtruth", flags.groundtruth, "FILE",
      "trajectory file with the ground truth; with --sequence on KITTI raw: devkit or "
      "interpolated");
  add("--estimate", flags.estimate, "FILE", "trajectory file")->required();
  add("--sequence", flags.sequence.folder, "FOLDER",
      "use the ground truth of this sequence instead of a file");
  app.add_flag("--json", flags.json, "print JSON, with the contract of each metric");
  flags.sequence.AddTruthTo(app);
}

Command AddTrajectoryCommand(CLI::App& eval) {
  CLI::App* app = eval.add_subcommand(
      "trajectory", "Score a trajectory file, or the results of another system on a sequence");
  const auto flags = std::make_shared<TrajectoryFlags>();
  const FlagAdder add{*app};
  AddInputs(*app, *flags);
  add("--format", flags->format, "NAME",
      "tum (time tx ty tz qx qy qz qw) or kitti (12 numbers); default: from the number of columns")
      ->check(OneOf({"tum", "kitti"}));
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

Command AddClockCommand(CLI::App& eval) {
  CLI::App* app = eval.add_subcommand("clock",
                                      "Estimate from rotation rates how far the clock of the "
                                      "ground truth is ahead of an estimate's");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<TrajectoryFlags>();
  AddInputs(*app, *flags);
  add("--within", flags->most_s, "SECONDS", "search from -SECONDS to SECONDS (0.01 to 10)")
      ->check(Within(0.01, kMostClockOffset_s))
      ->capture_default_str();
  app->final_callback([app, flags] { CheckUsage(*app, *flags); });
  return {app, [flags] { return EstimateClock(*flags); }};
}

}  // namespace

Command AddEvalCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "eval", "Score trajectories or boxes, or compare clocks, of any system");
  return Group(*app,
               {AddTrajectoryCommand(*app), AddEvalBoxesCommand(*app), AddClockCommand(*app)});
}

}  // namespace cvo
