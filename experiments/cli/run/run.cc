// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/run.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/options_json.h"
#include "core/record/run_summary.h"
#include "experiments/cli/command.h"
#include "experiments/datasets/plausibility.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_job.h"
#include "experiments/suite/build_plan.h"
#include "experiments/suite/job_status.h"
#include "synth/write/render_cache.h"
#include "variants/registry.h"

namespace cvo {

namespace {

const std::string kNone = "-";

// Returns "camera_causal_ate" for "camera_ate", and the reverse.
std::string Named(const std::string& name, bool causal) {
  reports::MetricForm form = reports::FindForm(name).value();
  form.causal = causal;
  return reports::MetricName(form);
}

// Whether the metric is printed by default.
bool IsKeyMetric(const std::string& name) {
  constexpr std::array<std::string_view, 8> kKey = {
      "camera_ate",          "camera_trpe_1_frame", "camera_rrpe_1_frame", "object_ate",
      "object_success_10cm", "object_coverage",     "moving_precision",    "moving_recall"};
  return std::find(kKey.begin(), kKey.end(), name) != kKey.end();
}

std::string Value(const std::optional<double>& value) {
  return value ? ReadableNumber(*value) : kNone;
}

std::string SuccessAt10cm(const BodyScore& body) {
  constexpr double kLimit_m = 0.1;
  const std::vector<double>& errors_m = body.errors.position_m;
  const auto within = std::count_if(errors_m.begin(), errors_m.end(),
                                    [](double error_m) { return error_m <= kLimit_m; });
  return ReadableNumber(static_cast<double>(within) / body.visible_frames);
}

}  // namespace

void AddEstimator(CLI::App& app, std::string& variant, std::vector<std::string>& set) {
  std::vector<std::string> names;
  for (const VariantInfo& known : Variants()) names.emplace_back(known.name);
  const FlagAdder add{app};
  add("--variant", variant, "NAME", "estimator variant (see clustervo list variants)")
      ->check(OneOf(std::move(names)))
      ->capture_default_str();
  add("--set", set, "PATH=VALUE", "set one option (see clustervo list options); can be repeated")
      ->allow_extra_args(false);
}

void PrintBodies(const std::vector<BodyScore>& bodies, const std::vector<Metric>& metrics,
                 std::ostream& out) {
  double least_travel_m = 0.0;
  for (const Metric& metric : metrics) {
    least_travel_m = std::max(least_travel_m, metric.contract.travel_m.value_or(0.0));
  }
  const std::string moves = StrCat("moves (> ", ReadableNumber(least_travel_m), " m)");
  TextTable table({"body", "class", moves, "travel m", "cluster", "visible", "estimated", "ATE m",
                   "in 10 cm", "motion rad", "motion m", "velocity error m/s", "switches"});
  for (const BodyScore& body : bodies) {
    table.Add({body.name, body.category, body.mover ? "yes" : "no", ReadableNumber(body.travel_m),
               body.cluster < 0 ? kNone : std::to_string(body.cluster),
               std::to_string(body.visible_frames), std::to_string(body.estimated_frames),
               Value(body.ate_m), SuccessAt10cm(body), Value(body.motion_rad), Value(body.motion_m),
               Value(body.velocity_m_s), std::to_string(body.id_switches)});
  }
  table.Print(out);
}

void PrintMetrics(const std::vector<Metric>& metrics, std::ostream& out) {
  TextTable table({"metric", "value", "unit", "n"});
  for (const Metric& metric : metrics) {
    table.Add(
        {metric.name, ReadableNumber(metric.value), NameOf(metric.unit), std::to_string(metric.n)});
  }
  table.Print(out);
}

namespace {

void PrintDetections(const RunResult& run, std::ostream& out) {
  const Sequence& sequence = run.sequence;
  const DetectionCounts& counts = run.detections;
  if (sequence.box_sources.detections.empty()) return;
  int other_classes = 0;
  for (const auto& [type, count] : counts.other_classes) other_classes += count;
  out << "detections: " << counts.given << " used; left out: " << sequence.low_scores
      << " below --min-score, " << counts.outside << " outside the image, " << counts.skipped
      << " of skipped frames, " << other_classes << " of other classes\n";
  const auto negative =
      std::count_if(sequence.detections.begin(), sequence.detections.end(),
                    [](const ObjectBox& box) { return box.score && *box.score < 0.0; });
  if (negative == 0) return;
  out << "warning: " << negative << " of " << sequence.detections.size()
      << " boxes have a negative score: --min-score 0 leaves them out\n";
}

void PrintScores(const RunScores& scores, bool all, std::ostream& out) {
  TextTable table({"metric", "refined", "causal", "unit", "n"});
  for (const Metric& metric : scores.metrics) {
    const std::string name = Named(metric.name, false);
    const bool refined = metric.contract.poses == reports::PoseTime::kRefined;
    // One that has both forms has one row.
    if ((!refined && name != metric.name) || (!all && !IsKeyMetric(name))) continue;
    const Metric* causal =
        refined ? FindBy(scores.metrics, &Metric::name, Named(name, true)) : &metric;
    table.Add({name, refined ? ReadableNumber(metric.value) : kNone,
               causal == nullptr ? kNone : ReadableNumber(causal->value), NameOf(metric.unit),
               std::to_string(metric.n)});
  }
  table.Print(out);
  out << "refined: final estimates; causal: estimates at the time of each frame\n";
  if (!all) out << "all metrics: --all, and in result.json\n";
  if (scores.refined_bodies.empty()) return;
  out << "\nbodies, refined poses:\n";
  PrintBodies(scores.refined_bodies, scores.metrics, out);
}

namespace fs = std::filesystem;

// Throws UsageError if the folder contains the result of a run other than the requested one,
// whichever build made it, or a landmarks.csv that the request does not ask for, because the new
// run would replace them. Reads the images of the sequence only if nothing else distinguishes the
// two runs.
void CheckFormerRun(const RunRequest& request, const fs::path& folder) {
  if (!fs::exists(folder / "result.json")) return;
  const Sequence& sequence = request.sequence;
  try {
    const reports::RunSummary run = reports::ReadRun(folder / "result.json", {});
    const auto expect = [&](const std::string& what, const Json& found, const Json& expected) {
      if (found != expected)
        ThrowError(folder.string(), StrCat("a run with ", what, " ", found.dump()),
                   expected.dump());
    };
    expect("sequence", run.sequence.name, sequence.name);
    expect("first frame", run.sequence.first_frame, sequence.first_frame);
    expect("number of frames", run.sequence.frames, sequence.images.size());
    expect("variant", run.variant, request.variant.name);
    expect("seed", run.seed, request.seed);
    const auto former = FlatJson(run.options);
    const std::string asked = DumpJson(ResolvedOptions(request.options));
    for (const auto& [path, value] : FlatJson(ParseJson(asked, "options"))) {
      const auto known = former.find(path);
      expect("option " + path, known == former.end() ? "not known" : known->second, value);
    }
    expect("boxes (SHA-256)", run.sequence.detections_hash, DetectionsHash(sequence));
    expect("given", run.given, Given(sequence, request.classes, request.oracle));
    expect("landmarks.csv", fs::exists(folder / "landmarks.csv") && !request.landmarks, false);
    expect("input (SHA-256)", run.sequence.content, ContentHash(sequence, HashImages(sequence)));
  } catch (const Error& error) {
    throw UsageError(StrCat(error.what(), "; use --force to replace it"));
  }
}

struct Flags {
  SequenceFlags sequence;
  std::string config;
  std::vector<std::string> set;
  int threads = 1;
  bool quiet = false;
  std::string variant = "full";
  std::string output;
  std::optional<std::uint64_t> seed;
  std::string classes;
  std::string oracle = "none";
  bool landmarks = false;
  bool force = false;
  bool all = false;
  bool no_warnings = false;
};

void PrintProblems(const RunResult& run) {
  for (const FrameRecord& frame : run.frames) {
    for (const ImageProblem& problem : frame.problems) {
      std::cout << "frame " << frame.frame << " skipped: " << problem.image << ": "
                << problem.reason << '\n';
    }
  }
}

// Prints by how much u_right is too large, as a mean over the image, unless it may be zero.
void PrintCalibration(const RunResult& run) {
  const std::optional<CalibrationReport> calibration = LastCalibration(run);
  if (!calibration) return;
  const double shift_px = run.sequence.camera.right_shift_px + calibration->right_field_px[0];
  const double deviation_px = std::sqrt(calibration->Covariance_px2()(0, 0));
  if (std::abs(shift_px) < 2.0 * deviation_px) return;
  std::cout << "self-calibration: u_right is too large by " << ReadableNumber(shift_px) << " +- "
            << ReadableNumber(deviation_px) << " px (mean over the image)\n";
}

void PrintSummary(const RunResult& run, bool all, bool warn) {
  const double rate = static_cast<double>(run.frames.size()) / run.wall_s;
  std::cout << run.sequence.name << ": " << Counted(run.frames.size(), "frame") << " in "
            << ReadableNumber(run.wall_s) << " s, " << FrameRateText(rate) << ", "
            << ReadableNumber(run.timing.peak_memory_mb) << " MB, status " << ToString(run.status)
            << (run.message.empty() ? "" : ": ") << run.message << '\n';
  for (const std::string& line : run.warnings) {
    if (warn) std::cout << "warning: " << line << " (--no-warnings)\n";
  }
  PrintProblems(run);
  PrintCalibration(run);
  PrintDetections(run, std::cout);
  if (run.scores.metrics.empty()) {
    std::cout << "no metrics: the sequence has no ground truth\n";
    return;
  }
  std::cout << '\n';
  PrintScores(run.scores, all, std::cout);
}

// Throws Error if most poses are predicted: this is not a trajectory, whatever its files look like.
void RefuseLost(const RunResult& run) {
  const auto lost = std::count_if(run.frames.begin(), run.frames.end(), [](const auto& frame) {
    return frame.report.status == FrameStatus::kLost;
  });
  if (2 * static_cast<std::size_t>(lost) <= run.frames.size()) return;
  const std::optional<PairCheck> pair = CheckMiddlePair(run.sequence);
  throw Error(run.message + (pair && !pair->problem.empty() ? ": " + pair->problem : ""));
}

// The folder of the results if none is given.
std::string DefaultOutput(const Flags& flags) {
  const StereoImport& stereo = flags.sequence.stereo;
  const fs::path input = stereo.left.empty() ? flags.sequence.folder : stereo.left.parent_path();
  const std::string name = NormalFolder(fs::absolute(input)).filename().string();
  return StrCat("results/", name, flags.variant == "full" ? "" : "_" + flags.variant);
}

// The path as a word of a command line.
std::string ShellWord(const std::string& path) {
  const bool plain = std::all_of(path.begin(), path.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("/._-+=@:,").find(c) != std::string_view::npos;
  });
  if (plain) return path;
  std::string word = "'";
  for (const char c : path) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

int Run(Flags flags) {
  if (flags.sequence.folder.empty() && flags.sequence.stereo.left.empty()) {
    throw UsageError(kSequenceMissing);
  }
  if (flags.output.empty()) flags.output = DefaultOutput(flags);
  const VariantInfo& variant = FindVariant(flags.variant);
  const Options options = ResolveOptions<Options>(flags.config, flags.set, variant.defaults());
  const std::vector<std::string> classes =
      flags.classes.empty() ? RigidClasses() : ParseClasses(flags.classes);
  CheckNotBelow(InputsOf(flags.sequence.stereo), flags.output);
  CheckPlaceOfRun(flags.output);
  const Sequence sequence = OpenSequence(WithBoxes(flags.sequence.Request(flags.quiet)));
  CheckClasses(classes, sequence.detections);
  std::vector<std::filesystem::path> read = FoldersOf(sequence);
  read.emplace_back(flags.config);
  const OutputFolder output = OpenOutput(flags.output, RunFileNames(), read);
  const FolderLock lock(output.path() / "lock");
  RemoveTemporaries(output.path());  // of killed runs

  RequireAsRendered(sequence);
  const std::optional<RunResult> run = [&] {
    const StopSignal stop;
    RunRequest request = {.sequence = sequence,
                          .variant = variant,
                          .options = options,
                          .seed = flags.seed.value_or(0),
                          .threads = flags.threads,
                          .classes = classes,
                          .oracle = ParseOracle(flags.oracle),
                          .landmarks = flags.landmarks,
                          .stop = [&stop] { return stop.Requested(); }};
    if (!flags.force) CheckFormerRun(request, output.path());
    if (sequence.box_sources.detections.empty() && flags.sequence.detections_file.empty() &&
        !flags.quiet) {
      PrintNotice(
          "no boxes: bodies are not estimated; --detections FILE reads boxes, `clustervo detect` "
          "makes them");
    }
    Progress progress(flags.quiet);
    request.progress = [&](std::size_t done) { progress.Report(done, sequence.images.size()); };
    return RunJob(request, output.path());
  }();
  if (!run) {
    PrintNotice("stopped, nothing was written");
    return kInterrupted;
  }
  if (run->status == RunStatus::kFailed) throw Error(run->message);
  PrintSummary(*run, flags.all, !flags.no_warnings);
  const std::string word = ShellWord(flags.output);
  std::cout << "\nwritten: " << flags.output << "\nnext: clustervo plot " << word << " -o "
            << ShellWord(flags.output + "/camera.svg") << "\n      clustervo overlay " << word
            << " -o " << ShellWord(flags.output + "/pictures") << '\n';
  RefuseLost(*run);
  return 0;
}

}  // namespace

Command AddRunCommand(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("run", "Estimate the camera's trajectory on a sequence and score it");
  const auto flags = std::make_shared<Flags>();
  flags->sequence.AddTo(*app);
  const FlagAdder add{*app};
  add("-o,--output", flags->output, "FOLDER",
      "output folder for the results; default: results/SEQUENCE, or results/SEQUENCE_VARIANT");
  AddEstimator(*app, flags->variant, flags->set);
  add("--config", flags->config, "FILE",
      "JSON file with options as nested objects; --set takes precedence");
  AddThreads(*app, flags->threads);
  AddQuiet(*app, flags->quiet);
  AddSeed(*app, flags->seed, "random seed of the estimator; default: 0");
  add("--classes", flags->classes, "A,B,...",
      "detection classes to treat as rigid bodies, others are ignored; default: vehicles and the "
      "moving objects of the shipped scenes");
  add("--oracle", flags->oracle, "A,B,...",
      "quantities taken from the ground truth instead of being estimated: boxes (which body each "
      "detection shows), labels (which body each feature belongs to), camera (its pose)")
      ->capture_default_str();
  app->add_flag("--landmarks", flags->landmarks,
                "write landmarks.csv: every landmark of every frame with its labels");
  app->add_flag("--force", flags->force,
                "overwrite FOLDER even if it holds the results of a different run (refused by "
                "default; the same run can always be repeated)");
  app->add_flag("--no-warnings", flags->no_warnings,
                "do not print what is unlikely about the input; result.json keeps it");
  app->add_flag("--all", flags->all, "print all metrics instead of the most important ones");
  app->footer(
      "Output files: result.json, timing.json, truth.json, camera.tum, camera.kitti; for moving "
      "bodies\nobjects.csv (every cluster in every frame, with its life state), tracks.kitti "
      "(KITTI\ntracking rows, without predicted poses) and clusters/<id>.tum.\ncamera.kitti has "
      "one line per frame; skipped frames, listed in result.json, have their\npredicted pose. "
      "camera.tum omits skipped frames. Poses are the final estimates of\nworld_from_camera. "
      "result.json and the trajectories are byte-identical on every run.\n"
      "Examples:\n"
      "  clustervo run kitti_raw/2011_09_26/2011_09_26_drive_0001_sync -o results/0001\n"
      "  clustervo run kitti_odometry/sequences/06 -o results/06 --frames 0:51 \\\n"
      "      --set window.spatial=5 --set orb.features=2000");
  return {app, [flags] { return Run(*flags); }};
}

}  // namespace cvo
