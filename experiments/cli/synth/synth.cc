// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo synth` and its subcommand `check`.
#include <cmath>
#include <iostream>
#include <memory>

#include "core/base/error.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/run/run_flags.h"
#include "experiments/cli/run/text_table.h"
#include "experiments/datasets/scene_check/check_scene.h"

namespace cvo {
namespace {

constexpr int kDisagreement = 1;

struct Flags {
  std::string folder;
  std::string json;
  int threads = 1;
};

std::string Limit(const SceneCheck& check) {
  return (check.bound == Bound::kAtMost ? "<= " : ">= ") + ReadableNumber(check.limit);
}

void Print(const SceneCheckReport& report) {
  TextTable table({"check", "figure", "unit", "limit", "", "worst"});
  for (const SceneCheck& check : report.checks) {
    table.Add({check.name, std::isfinite(check.figure) ? ReadableNumber(check.figure) : "-",
               check.unit, Limit(check), check.Passed() ? "ok" : "FAILED", check.where});
  }
  table.Print(std::cout);
  std::cout << '\n'
            << report.folder << ": " << report.frames << " frames, the images of "
            << report.image_frames << " compared: " << (report.Passed() ? "passed" : "FAILED")
            << '\n';
}

int Check(const Flags& flags) {
  if (!flags.json.empty()) CheckOutputFile(flags.json, {flags.folder});
  const SceneCheckReport report = CheckScene(flags.folder, flags.threads);
  Print(report);
  if (!flags.json.empty()) {
    WriteOutputFile(flags.json, DumpJson(SceneCheckJson(report)), {flags.folder});
  }
  return report.Passed() ? 0 : kDisagreement;
}

Command AddCheckCommandOfSynth(CLI::App& synth) {
  CLI::App* app = synth.add_subcommand(
      "check", "Check that a rendered sequence's images, depth, masks and poses are consistent");
  const auto flags = std::make_shared<Flags>();
  app->add_option("DIR", flags->folder, "folder of a rendered sequence")->type_name("")->required();
  app->add_option("--json", flags->json, "also write the results to this file")->type_name("FILE");
  AddThreads(*app, flags->threads);
  app->footer(
      "Only the folder's files are read. Text files and masks of all frames are checked, and "
      "the\nimages of at most 40 frames. Exit code 1 if a value exceeds its limit.\n"
      "Example: clustervo synth check indoor_1 --json check.json");
  return {app, [flags] { return Check(*flags); }};
}

}  // namespace

Command AddSynthCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "synth", "Render, preview and check synthetic stereo sequences with exact ground truth");
  app->footer(
      "Start with: clustervo synth render indoor_1 -o indoor_1, then clustervo synth check "
      "indoor_1\n"
      "and clustervo run indoor_1 -o results/indoor_1.");
  return Group(*app, {AddSynthRenderCommand(*app), AddSynthPreviewCommand(*app),
                      AddCheckCommandOfSynth(*app)});
}

}  // namespace cvo
