// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/eval_boxes.h"
#include "experiments/cli/run/eval_clock.h"
#include "experiments/cli/run/eval_sequence.h"
#include "experiments/cli/run/run_summary.h"
#include "experiments/metrics/association.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/trajectory.h"

namespace cvo {
namespace {

struct EvalFlags {
  std::string groundtruth;
  std::string estimate;
  std::string format;
  double max_time_difference_s = 1e-9 * static_cast<double>(kDefaultAssociation_ns);
  bool json = false;
  EvalSequence sequence;  // scored against its own truth; without a folder: two files
  EvalBoxes boxes;        // scored instead, if wanted
  EvalClock clock;        // estimated instead, if wanted
};

// True and estimated poses, one each per pose of the ground truth.
struct PairedPoses {
  std::vector<std::optional<RigidTransform>> truth;
  std::vector<std::optional<RigidTransform>> estimate;
  std::size_t matched = 0;
  std::size_t unmatched_truth = 0;
  std::size_t unmatched_estimate = 0;
};

std::string FormatOfBoth(const EvalFlags& flags) {
  if (!flags.format.empty()) return flags.format;
  const std::string truth = DetectPoseFormat(flags.groundtruth);
  const std::string estimate = DetectPoseFormat(flags.estimate);
  if (truth != estimate) {
    ThrowError(flags.estimate, "a trajectory in " + estimate + " format",
               truth + " as in " + flags.groundtruth);
  }
  return truth;
}

PairedPoses PairTum(const EvalFlags& flags) {
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

PairedPoses PairKitti(const EvalFlags& flags) {
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

int EvaluateFiles(const EvalFlags& flags) {
  const PairedPoses poses = FormatOfBoth(flags) == "tum" ? PairTum(flags) : PairKitti(flags);
  if (poses.matched < 2) {
    ThrowError(flags.estimate, StrCat(poses.matched, " poses that match one of the truth"),
               StrCat("2 or more within ", flags.max_time_difference_s, " s"));
  }
  if (poses.matched < poses.unmatched_estimate) {
    std::cerr << StrCat("clustervo: note: only ", poses.matched, " of ",
                        poses.matched + poses.unmatched_estimate, " poses of ", flags.estimate,
                        " match one of the truth within ", flags.max_time_difference_s, " s\n");
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

// Checks that all flags belong to the same mode: two files, a sequence and an estimate, or boxes.
void CheckUsage(const CLI::App& app, const EvalFlags& flags) {
  const auto refuse = [&](const std::string& flag, const char* why) {
    if (app.count(flag) > 0) throw CLI::ValidationError(flag, why);
  };
  flags.boxes.CheckUsage(app);
  if (flags.boxes.wanted()) {
    if (flags.sequence.flags.labels.empty()) {
      throw CLI::ValidationError("--labels is required with --ap and --tracking");
    }
    std::vector<std::string> others = EvalSequence::FlagNames();
    others.insert(others.end(), {"--groundtruth", "--sequence", "--format", "--max-time-difference",
                                 "--clock-offset"});
    for (const std::string& flag : others) {
      if (flag != "--labels" && flag != "--frames") refuse(flag, "does not apply to boxes");
    }
    return;
  }
  if (flags.clock.wanted()) {
    for (const char* flag : {"--format", "--max-time-difference", "--objects", "--name", "--output",
                             "--right-shift"}) {
      refuse(flag, "does not apply with --clock-offset");
    }
  }
  if (app.count("--sequence") > 0) {
    refuse("--format",
           "applies to two files; with --sequence the format follows from the number of columns");
    refuse("--max-time-difference", "applies to two files; with --sequence it is 0.02 s");
    return;
  }
  if (flags.groundtruth.empty()) {
    throw CLI::ValidationError(
        "--groundtruth is required unless --sequence, --ap or --tracking is given");
  }
  for (const std::string& flag : EvalSequence::FlagNames()) refuse(flag, "needs --sequence");
}

int Evaluate(const CLI::App& app, EvalFlags& flags) {
  if (flags.boxes.wanted()) {
    const SequenceFlags& part = flags.sequence.flags;
    return EvaluateBoxes(flags.boxes, {part.labels, flags.estimate, part.frames}, flags.json);
  }
  if (app.count("--sequence") == 0) {
    return flags.clock.wanted()
               ? EvaluateClock(flags.clock, flags.groundtruth, flags.estimate, flags.json)
               : EvaluateFiles(flags);
  }
  if (!flags.groundtruth.empty()) flags.sequence.flags.groundtruth = flags.groundtruth;
  if (flags.clock.wanted()) {
    return EvaluateClock(flags.clock, flags.sequence.flags.Request(), flags.estimate, flags.json);
  }
  return EvaluateSequence(flags.sequence, flags.estimate, flags.json);
}

}  // namespace

Command AddEvalCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "eval", "Score a trajectory file, boxes, or the results of another system on a sequence");
  const auto flags = std::make_shared<EvalFlags>();
  app->add_option("--groundtruth", flags->groundtruth,
                  "trajectory file with the ground truth; with --sequence on KITTI raw: devkit or "
                  "interpolated")
      ->type_name("FILE");
  app->add_option("--estimate", flags->estimate,
                  "trajectory file to score; with --ap and --tracking: boxes")
      ->type_name("FILE")
      ->required();
  app->add_option("--format", flags->format,
                  "tum (time tx ty tz qx qy qz qw) or kitti (12 numbers); default: from the number "
                  "of columns")
      ->check(OneOf({"tum", "kitti"}));
  app->add_option("--max-time-difference", flags->max_time_difference_s,
                  "maximum time difference of matching TUM poses, in seconds")
      ->check(CLI::Range(0.0, 1e6).description(""))
      ->check(FiniteProblem)
      ->capture_default_str();
  app->add_flag("--json", flags->json, "print JSON, with the contract of each metric");
  flags->sequence.AddTo(*app);
  flags->clock.AddTo(*app);
  flags->boxes.AddTo(*app);
  app->footer(
      "Poses are world_from_camera. For ATE, the estimate is aligned by SE(3) over "
      "positions.\nWith --sequence, camera and objects are scored in the same way as a run. "
      "Objects are KITTI\ntracking rows with 3D boxes in rectified camera 0, or a folder of "
      "<id>.tum files with\nworld_from_object. They have no landmarks and are therefore matched to "
      "ground-truth bodies by\ndistance, as the contracts state; unlike in run, velocities are "
      "differences of their poses.\n"
      "Examples:\n"
      "  clustervo eval --groundtruth poses/06.txt --estimate OUT/camera.kitti\n"
      "  clustervo eval --sequence scenes/indoor_1 --estimate cam.tum --objects tracks.kitti \\\n"
      "      --name other -o results/other_indoor_1\n"
      "  clustervo eval --ap --labels label_02/0003.txt --estimate tracks.kitti --iou 0.25");
  app->final_callback([app, flags] { CheckUsage(*app, *flags); });
  return {app, [app, flags] { return Evaluate(*app, *flags); }};
}

}  // namespace cvo
