// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/run.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/options_json.h"
#include "core/files/text/closest_names.h"
#include "core/record/run_summary.h"
#include "experiments/cli/command.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_job.h"
#include "experiments/suite/plan_inputs.h"
#include "synth/write/render_cache.h"
#include "variants/registry.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Like FindVariant, but throws UsageError with the nearest names if there is no such variant.
const VariantInfo& VariantNamed(const std::string& name) {
  std::vector<std::string> names;
  for (const VariantInfo& variant : Variants()) names.emplace_back(variant.name);
  const std::string meant = DidYouMean(name, names);
  const bool known = std::find(names.begin(), names.end(), name) != names.end();
  if (known) return FindVariant(name);
  throw UsageError(StrCat("--variant: found ", Quoted(name), meant, ", expected ",
                          meant.empty() ? OneOfKnown(name, names)
                                        : "one of those that `clustervo list variants` lists"));
}

// Throws UsageError if the folder contains the result of a run other than the requested one,
// whichever build made it, or a landmarks.csv that the request does not ask for, because the new
// run would replace them. Reads the images of the sequence only if nothing else distinguishes the
// two runs.
void CheckFormerRun(const RunRequest& request, const fs::path& folder) {
  if (!fs::exists(folder / "result.json")) return;
  reports::RunSummary run;
  try {
    run = reports::ReadRun(folder / "result.json", {});
  } catch (const Error& error) {
    throw UsageError(StrCat(error.what(), "; use --force to replace it"));
  }
  const auto expect = [&](bool same, const std::string& found, const std::string& expected) {
    if (same) return;
    throw UsageError(StrCat(folder.string(), ": found a run of ", run.sequence.name, " with ",
                            found, ", expected ", expected, "; use --force to replace it"));
  };
  const auto expect_same = [&](const std::string& what, const std::string& found,
                               const std::string& asked) {
    expect(found == asked, StrCat(what, " ", found), asked);
  };
  const Sequence& sequence = request.sequence;
  const auto end = sequence.first_frame + static_cast<int>(sequence.images.size());
  expect_same("sequence", run.sequence.name, sequence.name);
  expect_same("frames", StrCat(run.sequence.first_frame, ":", run.sequence.range().last + 1),
              StrCat(sequence.first_frame, ":", end));
  expect_same("variant", run.variant, std::string(request.variant.name));
  expect_same("seed", StrCat(run.seed), StrCat(request.seed));
  Options options = request.options;
  const auto former = FlatJson(run.options);
  const std::string asked = DumpJson(OptionsToJson(OptionLeaves(options)));
  for (const auto& [path, value] : FlatJson(ParseJson(asked, "options"))) {
    const auto known = former.find(path);
    expect_same("option " + path, known == former.end() ? "not known" : known->second, value);
  }
  expect(run.sequence.detections_hash == DetectionsHash(sequence),
         StrCat("other detections (", run.sequence.detections, ")"),
         StrCat("the given ones (", sequence.detections.size(), ")"));
  expect_same("classes and oracles", run.given.dump(),
              Given(sequence, request.classes, request.oracle).dump());
  expect(request.landmarks || !fs::exists(folder / "landmarks.csv"), "landmarks.csv",
         "one without, or --landmarks");
  const auto& hashes = request.images;
  expect(
      run.sequence.content == ContentHash(sequence, hashes.empty() ? HashImages(sequence) : hashes),
      "other images, calibration or ground truth", "the given ones");
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
  bool strict = false;
  bool landmarks = false;
  bool force = false;
  bool all = false;
  bool cache = false;
  std::string cache_size;
};

void PrintProblems(const RunResult& run) {
  for (const FrameRecord& frame : run.frames) {
    for (const ImageProblem& problem : frame.problems) {
      std::cout << "frame " << frame.frame << " skipped: " << problem.image << ": "
                << problem.reason << '\n';
    }
  }
}

// Prints by how much u_right is too large: the mean over the image, and the range.
void PrintCalibration(const Sequence& sequence, const RunResult& run) {
  const std::optional<CalibrationReport> calibration = LastCalibration(run);
  if (!calibration) return;
  StereoCamera camera = sequence.camera;
  camera.right_field_px = calibration->right_field_px;
  std::vector<double> shifts_px;
  for (const double u : {0.0, 0.5, 1.0}) {
    for (const double v : {0.0, 0.5, 1.0}) {
      shifts_px.push_back(camera.RightShift(u * camera.width_px, v * camera.height_px));
    }
  }
  const auto [least, most] = std::minmax_element(shifts_px.begin(), shifts_px.end());
  std::cout << "self-calibration: u_right is too large by "
            << ReadableNumber(camera.right_shift_px + camera.right_field_px[0]) << " +- "
            << ReadableNumber(std::sqrt(calibration->Covariance_px2()(0, 0)))
            << " px (mean over the image; locally " << ReadableNumber(*least) << " to "
            << ReadableNumber(*most) << " px)\n";
}

void PrintSummary(const Sequence& sequence, const JobOutcome& outcome, bool all) {
  const RunResult& run = outcome.run;
  const double rate = static_cast<double>(run.frames.size()) / run.wall_s;
  std::cout << sequence.name << ": " << Counted(run.frames.size(), "frame") << " in "
            << ReadableNumber(run.wall_s) << " s, " << FrameRateText(rate) << ", "
            << ReadableNumber(outcome.context.peak_memory_mb) << " MB, status "
            << ToString(run.status) << (run.message.empty() ? "" : ": ") << run.message << '\n';
  for (const std::string& line : outcome.warnings) {
    std::cout << "warning: implausible: " << line << '\n';
  }
  PrintProblems(run);
  PrintCalibration(sequence, run);
  PrintDetections(sequence, run.detections, std::cout);
  if (outcome.scores.refined.empty()) {
    std::cout << "no metrics: the sequence has no ground truth\n";
    return;
  }
  std::cout << '\n';
  PrintScores(outcome.scores, all, std::cout);
}

// Throws Error if most poses are predicted: this is not a trajectory, whatever its files look like.
void RefuseLost(const Sequence& sequence, const RunResult& run) {
  const auto lost = std::count_if(run.frames.begin(), run.frames.end(), [](const auto& frame) {
    return frame.report.status == FrameStatus::kLost;
  });
  if (2 * static_cast<std::size_t>(lost) <= run.frames.size()) return;
  const std::optional<PairCheck> pair = CheckMiddlePair(sequence);
  const std::string problem = pair ? pair->Problem() : "";
  throw Error(run.message + (problem.empty() ? "" : ": " + problem));
}

// Opens the cache of earlier runs. Its notices report what it has to do without.
JobCache OpenCache(const Flags& flags, std::size_t frames) {
  FileHashHooks hooks;
  hooks.notice = PrintNotice;
  const auto progress = std::make_shared<Progress>(flags.quiet);
  hooks.hashed = [progress, frames](std::size_t done, std::size_t total) {
    progress->Report(frames * done / total, frames);
  };
  return {synth::CacheFolder(), CacheLimit(flags.cache_size), hooks};
}

int Run(const Flags& flags) {
  if (!flags.cache_size.empty()) (void)CacheLimit(flags.cache_size);  // even without --cache
  const VariantInfo& variant = VariantNamed(flags.variant);
  CheckNoFolder("--config", flags.config);
  const Options options = ResolveOptions<Options>(flags.config, flags.set, variant.defaults());
  const std::vector<std::string> classes =
      flags.classes.empty() ? RigidClasses() : ParseClasses(flags.classes);
  CheckApartFrom(flags.sequence.OwnInputs(), flags.output);
  CheckPlaceOfRun(flags.output);
  const Sequence sequence = OpenSequence(flags.sequence.Request(flags.quiet));
  CheckClasses(classes, sequence.detections);
  std::vector<std::filesystem::path> read = FoldersOf(sequence);
  read.emplace_back(flags.config);
  const OutputFolder output = OpenOutput(flags.output, RunFileNames(), read);

  std::optional<JobCache> cache;
  if (flags.cache) cache.emplace(OpenCache(flags, sequence.images.size()));
  RequireAsRendered(sequence, [&](const auto& files) {
    return cache ? cache->HashesOf(files, flags.threads) : HashesByReading(files);
  });

  std::optional<JobOutcome> outcome;
  {
    const StopSignal stop;
    RunRequest request = {.sequence = sequence,
                          .variant = variant,
                          .options = options,
                          .seed = flags.seed.value_or(0),
                          .threads = flags.threads,
                          .classes = classes,
                          .oracle = ParseOracle(flags.oracle),
                          .landmarks = flags.landmarks,
                          .strict = flags.strict,
                          .stop = [&stop] { return stop.Requested(); }};
    if (cache) cache->Serve(request);
    if (!flags.force) CheckFormerRun(request, output.path());
    Progress progress(flags.quiet);
    request.progress = [&](std::size_t done) { progress.Report(done, sequence.images.size()); };
    outcome = RunJob(request, output.path());
  }
  if (!outcome) {
    PrintNotice("stopped, nothing was written");
    return kInterrupted;
  }
  if (outcome->run.status == RunStatus::kFailed) throw Error(outcome->run.message);
  PrintSummary(sequence, *outcome, flags.all);
  std::cout << "\nwritten: " << flags.output << '\n';
  RefuseLost(sequence, outcome->run);
  return 0;
}

}  // namespace

Command AddRunCommand(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("run", "Estimate the camera's trajectory on a sequence and score it");
  const auto flags = std::make_shared<Flags>();
  flags->sequence.AddTo(*app);
  const FlagAdder add{*app};
  add("-o,--output", flags->output, "FOLDER", "output folder for the results")->required();
  add("--variant", flags->variant, "NAME", "estimator variant (see clustervo list variants)")
      ->capture_default_str();
  add("--set", flags->set, "PATH=VALUE",
      "set one option (see clustervo list options); can be repeated")
      ->allow_extra_args(false);
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
  app->add_flag("--all", flags->all, "print all metrics instead of the most important ones");
  app->add_flag("--strict", flags->strict,
                "treat an image that cannot be decoded as an error instead of skipping its frame");
  app->add_flag("--cache", flags->cache,
                "store extracted features in the cache folder (CLUSTERVO_CACHE) and reuse them: "
                "faster when only the variant or its options change, with identical results");
  add("--cache-size", flags->cache_size, "SIZE",
      "with --cache: maximum total size of cached features, the least recently used are removed "
      "first; default: CLUSTERVO_CACHE_SIZE or 20G");
  app->footer(
      "Output files: result.json, timing.json, truth.json, camera.tum, camera.kitti; for moving "
      "bodies\nobjects.csv (every cluster in every frame, with its life state), tracks.kitti "
      "(KITTI\ntracking rows, without the life state) and clusters/<id>.tum.\ncamera.kitti has one "
      "line per frame; skipped frames, listed in result.json, have their\npredicted pose. "
      "camera.tum omits skipped frames. Poses are the final estimates of\nworld_from_camera. "
      "result.json and the trajectories are byte-identical on every run.\n"
      "Examples:\n"
      "  clustervo run kitti_raw/2011_09_26/2011_09_26_drive_0001_sync -o results/0001\n"
      "  clustervo run kitti_odometry/sequences/06 -o results/06 --frames 0:51 \\\n"
      "      --set window.spatial=5 --set orb.features=1500");
  return {app, [flags] { return Run(*flags); }};
}

}  // namespace cvo
