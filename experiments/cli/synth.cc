// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo synth: render and check synthetic scenes.
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "experiments/cli/command.h"
#include "experiments/datasets/scene_check/check_scene.h"
#include "experiments/datasets/sequence.h"
#include "synth/family/family.h"
#include "synth/write/dataset.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct RenderFlags {
  std::string scene;
  std::vector<std::string> set;
  std::string output;
  std::string frames;
  bool preview = false;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> detectors;
  int threads = 1;
  bool quiet = false;

  synth::SceneFrames Frames() const {
    if (frames.empty()) return {};
    const FrameRange range = ParseFrameRange(frames);
    return {range.begin, range.end < 0 ? std::nullopt : std::optional(range.end)};
  }
};

// Calls work(hooks). Returns 130 if the user stopped it, otherwise 0.
template <typename Work>
int RunStoppable(bool quiet, const Work& work) {
  const StopSignal stop;
  Progress progress(quiet);
  synth::WorkHooks hooks;
  hooks.progress = [&](int done, int total, const std::string& stage) {
    progress.Report(static_cast<std::size_t>(done), static_cast<std::size_t>(total), stage);
  };
  hooks.stop = [&] { return stop.Requested(); };
  hooks.notice = [&](const std::string& line) { progress.Note(line); };
  try {
    work(hooks);
    return 0;
  } catch (const synth::Stopped&) {
    progress.Note("clustervo: stopped, nothing was written");
    return kInterrupted;
  }
}

// Writes a contact sheet: masks, boxes and a map of all paths.
void WritePreview(const synth::SceneDescription& scene, const RenderFlags& flags,
                  const synth::WorkHooks& hooks) {
  synth::RenderRequest request;
  request.threads = flags.threads;
  const synth::DatasetSource source = synth::SourceOf(scene, request);
  const synth::World world = source.build_world();
  const synth::SceneFrames frames = flags.Frames();
  const FrameRange range = ResolveFrameRange({frames.first, frames.end.value_or(-1)}, world.frames);
  const cv::Mat sheet =
      synth::MakeContactSheet(world, range.begin, range.end, source.open_tools(world), hooks);
  WriteOutputFile(flags.output, EncodeImage(".png", sheet), {flags.scene});
}

void CheckOutput(const RenderFlags& flags) {
  if (flags.preview) {
    CheckOutputFile(flags.output, {flags.scene});
    CheckOwnFile(flags.output, "\x89PNG");
    return;
  }
  std::vector<fs::path> read;
  if (fs::exists(flags.scene)) read = {fs::absolute(flags.scene).parent_path()};
  CheckNewSequence(flags.output, read);
  try {
    synth::RequireReplaceable(flags.output);
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
}

int Render(const RenderFlags& flags) {
  CheckOutput(flags);
  const auto scene =
      LoadNamed(flags.scene, [&] { return synth::LoadScene(flags.scene, flags.set); });
  const int code = RunStoppable(flags.quiet, [&](const synth::WorkHooks& hooks) {
    if (flags.preview) return WritePreview(scene, flags, hooks);
    synth::WriteDataset(scene,
                        {.frames = flags.Frames(),
                         .seed = flags.seed,
                         .detector_levels = flags.detectors,
                         .threads = flags.threads,
                         .hooks = hooks},
                        flags.output);
  });
  if (code == 0) std::cout << "written: " << flags.output << '\n';
  return code;
}

Command AddRenderCommand(CLI::App& synth) {
  CLI::App* app = synth.add_subcommand("render", "Render a scene as a KITTI odometry folder");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<RenderFlags>();
  add("SCENE", flags->scene, "",
      "a shipped scene (clustervo list scenes), a JSON file or a seed of a family, "
      "such as room@17")
      ->required();
  add("-o,--output", flags->output, "DIR",
      "output folder; replaced if it exists and contains only files rendered by this program; "
      "with --preview: a PNG file")
      ->required();
  app->add_flag("--preview", flags->preview,
                "only draw a contact sheet: masks, boxes and a map of all paths");
  add("--frames", flags->frames, "A:B", "frames A to B-1 of the scene; default: all");
  add("--set", flags->set, "KEY=VALUE", "set one value of the scene, such as sensor.read_noise=0")
      ->allow_extra_args(false);
  AddSeed(*app, flags->seed, "seed of sensor noise and detector errors; default: the scene's");
  add("--detector", flags->detectors, "LEVEL",
      "detector level: oracle, good or poor; can be repeated; default: all")
      ->allow_extra_args(false);
  AddThreads(*app, flags->threads);
  AddQuiet(*app, flags->quiet);
  app->footer(
      "The seed changes sensor noise and detector errors (and, in clustervo run, the "
      "estimator's\nrandom draws), but not motion, textures or ground truth. Rendered images are "
      "cached in\nCLUSTERVO_CACHE (default: ~/.cache/clustervo), so another seed, noise level or "
      "detector does\nnot render again.\n"
      "Examples:\n"
      "  clustervo synth render indoor_1 -o sheet.png --preview\n"
      "  clustervo synth render indoor_1 -o quiet --seed 3 --frames 0:50 --set "
      "sensor.read_noise=0");
  return {app, [flags] { return Render(*flags); }};
}

constexpr int kDisagreement = 1;

struct SceneCheckFlags {
  std::string folder;
  int threads = 1;
};

void Print(const SceneCheckReport& report) {
  TextTable table({"check", "figure", "unit", "limit", "", "worst"});
  for (const SceneCheck& check : report.checks) {
    table.Add({check.name, std::isfinite(check.figure) ? ReadableNumber(check.figure) : "-",
               check.unit, "<= " + ReadableNumber(check.limit), check.Passed() ? "ok" : "FAILED",
               check.where});
  }
  table.Print(std::cout);
  std::cout << '\n'
            << report.folder << ": " << report.frames << " frames, the images of "
            << report.image_frames << " compared: " << (report.Passed() ? "passed" : "FAILED")
            << '\n';
}

int Check(const SceneCheckFlags& flags) {
  const SceneCheckReport report = CheckScene(flags.folder, flags.threads);
  Print(report);
  return report.Passed() ? 0 : kDisagreement;
}

Command AddSceneCheckCommand(CLI::App& synth) {
  CLI::App* app = synth.add_subcommand(
      "check", "Check that a rendered sequence's images, depth, masks and poses are consistent");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<SceneCheckFlags>();
  add("DIR", flags->folder, "", "folder of a rendered sequence")->required();
  AddThreads(*app, flags->threads);
  app->footer(
      "Only the folder's files are read. Text files and masks of all frames are checked, and "
      "the\nimages of at most 40 frames. Exit code 1 if a value exceeds its limit.\n"
      "Example: clustervo synth check indoor_1");
  return {app, [flags] { return Check(*flags); }};
}

}  // namespace

Command AddSynthCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "synth", "Render and check synthetic stereo sequences with exact ground truth");
  return Group(*app, {AddRenderCommand(*app), AddSceneCheckCommand(*app)});
}

}  // namespace cvo
