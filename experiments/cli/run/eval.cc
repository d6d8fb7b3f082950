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
#include "core/base/lists.h"
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
#include "reports/figures/figure_style.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct TrajectoryFlags {
  std::string groundtruth;
  std::vector<std::string> estimates;
  std::vector<std::string> files;  // the ground truth, then estimates
  std::string align = "se3";
  std::string up = "y";
  double time_offset_s = 0.0;
  bool json = false;
  std::string plot;
  SequenceFlags sequence;  // scored against its own truth; without a folder: two files
  double max_time_difference_s = 1e-9 * static_cast<double>(kDefaultAssociation_ns);
  std::string objects;
  std::string name;
  std::string output;
  double right_shift_px = 0.0;
};

std::vector<Metric> MetricsOf(const PlotReference& truth, const PlotInput& input,
                              const PlotTrack& track, TrajectoryAlignment alignment) {
  OptionalPoses poses;
  for (const TimedPose& pose : truth.poses) poses.emplace_back(pose.world_from_camera);
  std::vector<Metric> metrics = EvaluateCamera(
      poses, PosesAtFrames(track.matches, poses.size(), input.poses), reports::TruthSource::kFile);
  StatePoses(reports::PoseTime::kFile, 0.0, metrics);
  std::erase_if(metrics, [&](const Metric& metric) {
    const bool ate = metric.name.starts_with("camera_ate");
    if (ate) return alignment != TrajectoryAlignment::kSe3;  // which its contract states
    return track.errors_deg.empty() && metric.name != "camera_coverage" &&
           metric.name != "camera_path_error";
  });
  return metrics;
}

Json EvaluationJson(const PlotTrack& track, const std::vector<Metric>& metrics,
                    TrajectoryAlignment alignment) {
  return {{"matched", track.matches.pairs.size()},
          {"unmatched_groundtruth", track.matches.unmatched_a},
          {"unmatched_estimate", track.matches.unmatched_b},
          {"alignment", NameOf(alignment)},
          {"scale", track.scale},
          {"rms_m", RootMeanSquare(track.errors_m).value()},
          {"metrics", ToJson(metrics)}};
}

// Prints a column per trajectory.
void PrintEvaluations(const std::vector<PlotTrack>& tracks,
                      const std::vector<std::vector<Metric>>& all) {
  std::vector<std::string> header = {"metric"};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    header.push_back(tracks[i].name);
    for (const Metric& metric : all[i]) AddOnce(metric.name, names);
  }
  header.emplace_back("unit");
  TextTable table(header);
  for (const std::string& name : names) {
    std::vector<std::string> row = {name};
    std::string unit;
    for (const std::vector<Metric>& metrics : all) {
      const Metric* metric = FindMetric(metrics, name);
      row.push_back(metric == nullptr ? "-" : ReadableNumber(metric->value));
      if (metric != nullptr) unit = NameOf(metric->unit);
    }
    row.push_back(unit);
    table.Add(std::move(row));
  }
  table.Print(std::cout);
}

int EvaluateFiles(const TrajectoryFlags& flags) {
  std::vector<PlotInput> inputs;
  std::string notes;
  for (const std::string& file : flags.estimates) inputs.push_back(ReadPlotInput(file, notes));
  inputs.push_back(ReadPlotInput(flags.groundtruth, notes));
  MakeComparable(inputs);
  const PlotReference truth = {inputs.back().name, inputs.back().poses, true, false,
                               inputs.back().has_rotations};
  inputs.pop_back();
  const PlotMatching matching = {
      ParseTrajectoryAlignment(flags.align), flags.up == "z",
      static_cast<std::int64_t>(std::llround(1e9 * flags.max_time_difference_s)),
      static_cast<std::int64_t>(std::llround(1e9 * flags.time_offset_s))};
  std::vector<PlotTrack> tracks;
  std::vector<std::vector<Metric>> metrics;
  Json evaluations = Json::array();
  for (const PlotInput& input : inputs) {
    tracks.push_back(MatchTrack(truth, input, matching));
    metrics.push_back(MetricsOf(truth, input, tracks.back(), matching.alignment));
    evaluations.push_back(EvaluationJson(tracks.back(), metrics.back(), matching.alignment));
    evaluations.back()["estimate"] = input.name;
  }
  std::cerr << notes;
  if (!flags.plot.empty()) {
    std::vector<fs::path> read(flags.estimates.begin(), flags.estimates.end());
    read.emplace_back(flags.groundtruth);
    const reports::Figure figure = TrajectoryFigure({inputs, truth, matching, tracks, ""});
    WriteOutputFile(flags.plot, FigureFile(figure, {}, FormatOfFigure("--plot", flags.plot)), read);
  }
  if (flags.json) {
    Json json = {{"schema_version", 2}, {"kind", "evaluation"}};
    if (inputs.size() == 1) {
      json.update(evaluations[0]);
    } else {
      json["estimates"] = std::move(evaluations);
    }
    std::cout << DumpJson(json);
    return 0;
  }
  for (const PlotTrack& track : tracks) {
    std::cout << track.name << ": " << track.matches.pairs.size()
              << " poses matched, unmatched: " << track.matches.unmatched_a
              << " of the ground truth, " << track.matches.unmatched_b << " of the estimate\n";
  }
  std::cout << '\n' << reports::Capitalised(DescriptionOf(matching.alignment)) << ":\n";
  PrintTracks(tracks);
  std::cout << '\n';
  PrintEvaluations(tracks, metrics);
  return 0;
}

constexpr const char* kResult = "result.json";

// Throws Error for the folder of a suite or of a run: its result would be lost, and its other files
// would be taken for those of the system.
void RefuseRunFolder(const fs::path& folder) {
  CheckPlaceOfRun(folder);
  for (const std::string& name : RunFileNames()) {
    if (name == kResult || !fs::exists(folder / name)) continue;
    ThrowError(folder.string(), name + " of a run", "a folder without");
  }
  const fs::path result = folder / kResult;
  if (fs::exists(result) && !ReadJson(result).contains("system")) {
    ThrowError(result.string(), "the result of a run", "a folder without, or one of a system");
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
  const std::string& estimate = flags.estimates.front();
  const Sequence sequence = OpenSequence(flags.sequence.Request());
  std::unique_ptr<const OutputFolder> output;
  if (!flags.output.empty()) {
    RefuseRunFolder(flags.output);
    std::vector<fs::path> read = FoldersOf(sequence);
    read.insert(read.end(), {estimate, flags.objects});
    output.reset(new OutputFolder(OpenOutput(flags.output, {kResult}, read)));  // NOLINT: immovable
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
const std::vector<std::string> kOfFiles = {"--max-time-difference", "--align", "--time-offset",
                                           "--up", "--plot"};

// Sorts the files given without a flag, and refuses flags of the other mode.
void CheckUsage(const CLI::App& app, TrajectoryFlags& flags) {
  const bool of_sequence = app.count("--sequence") > 0;
  std::vector<std::string>& files = flags.files;
  if (!of_sequence && flags.groundtruth.empty() && !files.empty()) {
    flags.groundtruth = files.front();
    files.erase(files.begin());
  }
  flags.estimates.insert(flags.estimates.begin(), files.begin(), files.end());
  if (flags.estimates.empty() || (of_sequence && flags.estimates.size() > 1)) {
    throw CLI::ValidationError(
        "expected GROUNDTRUTH ESTIMATE..., or --sequence FOLDER and one estimate");
  }
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
  add("--estimate", flags->estimates, "FILE", "trajectory file")->expected(1);
  add("FILE", flags->files, "", "the ground truth, then the trajectories to score");
  add("--align", flags->align, "NAME",
      "how estimates are aligned: none, se3, sim3 (with scale), origin (at the first common pose) "
      "or yaw (about the vertical, and translation)")
      ->check(OneOf({"none", "se3", "sim3", "origin", "yaw"}))
      ->capture_default_str();
  add("--up", flags->up, "AXIS", "vertical axis for yaw: y (down, as cameras have it) or z (up)")
      ->check(OneOf({"y", "z"}))
      ->capture_default_str();
  add("--time-offset", flags->time_offset_s, "SECONDS", "added to the times of estimates")
      ->check(Within(-4e9, 4e9));
  add("--sequence", flags->sequence.folder, "FOLDER",
      "use the ground truth of this sequence instead of a file");
  app->add_flag("--json", flags->json, "print JSON, with the contract of each metric");
  add("--plot", flags->plot, "FILE",
      "also draw the trajectories, as clustervo plot does: .svg or .pdf");
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
      "Poses are world_from_camera. camera_ate is defined by SE(3) over positions, so that other "
      "alignments\nhave the errors of their table alone.\nWith --sequence, camera and objects are "
      "scored in the same way as a run. "
      "Objects are KITTI\ntracking rows with 3D boxes in rectified camera 0, or a folder of "
      "<id>.tum files with\nworld_from_object. They have no landmarks and are therefore matched to "
      "ground-truth bodies by\ndistance, as the contracts state; unlike in run, velocities are "
      "differences of their poses.\n"
      "Examples:\n"
      "  clustervo eval trajectory poses/06.txt OUT/camera.kitti other.kitti\n"
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
