// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/eval_sequence.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "core/base/error.h"
#include "experiments/cache/content_hash.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/progress.h"
#include "experiments/cli/run/run_summary.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/score_files.h"
#include "experiments/suite/plan/scenes.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResult = "result.json";

std::string HashSequence(const Sequence& sequence) {
  Progress progress(sequence.images.size(), false);
  std::vector<ImageHashes> images;
  for (const StereoPaths& pair : sequence.images) {
    images.push_back({HashFile(pair.left), HashFile(pair.right)});
    progress.Report(images.size());
  }
  return ContentHash(sequence, images);
}

// Throws Error for the folder of a run: its result would be lost, and its other files would be
// taken for those of the system.
void RefuseRunFolder(const fs::path& folder) {
  for (const std::string& name : RunFileNames()) {
    if (name == kResult || !fs::exists(folder / name)) continue;
    ThrowError(folder.string(), name + " of a run", "a folder without");
  }
}

void PrintOutcome(const Sequence& sequence, const EvalSequence& eval,
                  const SystemOutcome& outcome) {
  std::cout << sequence.name << ": poses of " << outcome.frames - outcome.frames_without_camera
            << " of " << outcome.frames << " frames";
  if (!eval.objects.empty()) {
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
  if (!eval.objects.empty() && outcome.bodies.empty()) {
    std::cout << "\nobjects not scored: the sequence has no ground truth of its bodies\n";
  }
  if (outcome.bodies.empty()) return;
  std::cout << "\nbodies:\n";
  PrintBodies(outcome.bodies, outcome.metrics, std::cout);
}

}  // namespace

std::vector<std::string> EvalSequence::FlagNames() {
  return {"--type",          "--dataset", "--pair", "--frames", "--labels",
          "--labels-camera", "--objects", "--name", "--output", "--right-shift"};
}

void EvalSequence::AddTo(CLI::App& app) {
  const auto add = [&app](const char* flag, auto& value, const char* kind, const char* meaning) {
    app.add_option(flag, value, meaning)->type_name(kind);
  };
  app.add_option("--sequence", flags.folder,
                 "score against the ground truth of this sequence instead of a file")
      ->type_name("FOLDER");
  add("--objects", objects, "FILE|FOLDER",
      "KITTI tracking rows with 3D boxes, or a folder of <id>.tum files");
  add("--name", name, "NAME", "name of the system in tables; default: the estimate's file name");
  add("-o,--output", output, "FOLDER", "output folder for result.json, in the format of a run");
  add("--right-shift", right_shift_px, "PX",
      "rectification correction applied to the system's input; default: 0, as published");
  app.get_option("--right-shift")
      ->check(CLI::Range(-100.0, 100.0).description(""))
      ->check(FiniteProblem);
  flags.AddTruthTo(app);
  for (const std::string& flag : FlagNames()) app.get_option(flag)->group("With --sequence");
}

int EvaluateSequence(const EvalSequence& eval, const std::string& estimate, bool json) {
  const Sequence sequence = OpenSequence(eval.flags.Request());
  std::unique_ptr<const OutputFolder> output;
  if (!eval.output.empty()) {
    RefuseRunFolder(eval.output);
    std::vector<fs::path> read = FoldersOf(sequence);
    read.insert(read.end(), {estimate, eval.objects});
    output.reset(new OutputFolder(OpenOutput(eval.output, {kResult}, read)));
  }
  RequireAsRendered(sequence, HashesByReading);
  const std::string name = eval.name.empty() ? fs::path(estimate).stem().string() : eval.name;
  SystemRequest request{sequence, "", {name, estimate, eval.objects}, 0, eval.right_shift_px};
  if (json || output) {
    ReadSystem(sequence, request.files);  // reports bad files before the images are hashed
    request.content = HashSequence(sequence);
  }
  const SystemOutcome outcome =
      output ? ScoreSystem(request, output->path()) : ScoreSystem(request);
  if (json) {
    std::cout << outcome.result;
  } else {
    PrintOutcome(sequence, eval, outcome);
  }
  return 0;
}

}  // namespace cvo
