// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>
#include <optional>

#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/output_place.h"
#include "experiments/cli/progress.h"
#include "experiments/cli/run/run_flags.h"
#include "experiments/cli/run/sequence_flags.h"
#include "experiments/cli/run/text_table.h"

namespace cvo {
namespace {

struct ImportFlags {
  StereoImport stereo;
  std::string output;
  bool quiet = false;
};

int Import(const ImportFlags& flags) {
  CheckStereo(flags.stereo);
  CheckApartFrom(InputsOf(flags.stereo), flags.output);
  CheckNewSequence(flags.output, {flags.stereo.left, flags.stereo.right});
  std::optional<Progress> progress;
  const ImportOutcome outcome =
      ImportStereo(flags.stereo, flags.output, [&](std::size_t done, std::size_t total) {
        if (!progress) progress.emplace(total, flags.quiet);
        progress->Report(done);
      });
  progress.reset();
  for (const std::string& line : outcome.damaged) std::cout << "lost: " << line << '\n';
  const StereoCamera& camera = outcome.camera;
  std::cout << outcome.frames << " pairs of " << camera.width_px << "x" << camera.height_px
            << " px, " << (outcome.rectified ? "rectified" : "used as they are")
            << ", times: " << outcome.times << "\ncalibration: fx " << ReadableNumber(camera.fx)
            << ", fy " << ReadableNumber(camera.fy) << ", cx " << ReadableNumber(camera.cx)
            << ", cy " << ReadableNumber(camera.cy) << " px, baseline "
            << ReadableNumber(camera.baseline_m) << " m\nwritten: " << flags.output << '\n';
  return 0;
}

}  // namespace

Command AddImportCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "import", "Convert your own stereo images into a sequence, rectifying them if necessary");
  const auto flags = std::make_shared<ImportFlags>();
  AddStereo(*app, flags->stereo);
  app->add_option("-o,--output", flags->output, "new folder, in the layout of KITTI odometry")
      ->type_name("FOLDER")
      ->required();
  AddQuiet(*app, flags->quiet);
  app->footer(
      "run accepts the same flags and caches the sequence. Use import to inspect the sequence or "
      "to\nuse it in a suite.\n"
      "Example: clustervo import --left cam0 --right cam1 --calib camchain.yaml -o kitchen");
  return {app, [flags] { return Import(*flags); }};
}

}  // namespace cvo
