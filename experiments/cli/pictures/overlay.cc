// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/pictures/overlay.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

#include "core/base/error.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/pictures/overlay_output.h"
#include "experiments/cli/run/run_flags.h"
#include "experiments/cli/suite/suite_run.h"
#include "experiments/datasets/frame_range.h"
#include "reports/overlays/overlay_run.h"
#include "variants/registry.h"

namespace cvo {
namespace {

bool HasFrame(const reports::OverlayRun& run, int frame) {
  return std::any_of(run.detail.camera.begin(), run.detail.camera.end(),
                     [frame](const reports::CameraFrame& entry) { return entry.frame == frame; });
}

// The selected frames of the first run that all other runs have, too.
std::vector<int> SelectFrames(const OverlayFlags& flags,
                              const std::vector<reports::OverlayRun>& runs) {
  const FrameRange range = flags.frames.empty() ? FrameRange{} : ParseFrameRange(flags.frames);
  std::vector<int> frames;
  int count = 0;
  for (const reports::CameraFrame& entry : runs.front().detail.camera) {
    if (flags.frame >= 0 && entry.frame != flags.frame) continue;
    if (entry.frame < range.begin || (range.end >= 0 && entry.frame >= range.end)) continue;
    if (count++ % flags.every != 0) continue;
    const bool in_all = std::all_of(runs.begin(), runs.end(),
                                    [&](const auto& run) { return HasFrame(run, entry.frame); });
    if (in_all) frames.push_back(entry.frame);
  }
  if (!frames.empty()) return frames;
  const auto& camera = runs.front().detail.camera;
  const std::string wanted = flags.frame >= 0       ? StrCat("--frame ", flags.frame)
                             : flags.frames.empty() ? "frames"
                                                    : "--frames " + flags.frames;
  ThrowError(wanted, runs.size() > 1 ? "no frame that all runs have" : "no such frame in the run",
             camera.empty() ? "a run with frames"
                            : StrCat(camera.front().frame, " to ", camera.back().frame));
}

void CheckSameSequence(const std::vector<reports::OverlayRun>& runs,
                       const std::vector<std::string>& folders) {
  for (std::size_t i = 1; i < runs.size(); ++i) {
    if (runs[i].sequence.name == runs[0].sequence.name) continue;
    ThrowError(folders[i], "a run of " + runs[i].sequence.name,
               StrCat("one of ", runs[0].sequence.name, ", as ", folders[0]));
  }
}

// What distinguishes the variant, as ": labels from ...". Empty for a variant unknown to this
// program.
std::string VariantChanges(const std::string& variant) {
  for (const VariantInfo& info : Variants()) {
    if (info.name == variant) return StrCat(": ", info.changes);
  }
  return "";
}

// Titles of the runs: the variant with its description, or with its folder if several runs are of
// this variant.
std::vector<std::string> Titles(const std::vector<reports::OverlayRun>& runs,
                                const std::vector<std::string>& folders) {
  std::vector<std::string> titles;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto same = std::count_if(
        runs.begin(), runs.end(), [&](const auto& run) { return run.variant == runs[i].variant; });
    titles.push_back(same > 1 ? StrCat(runs[i].variant, ": ", folders[i])
                              : runs[i].variant + VariantChanges(runs[i].variant));
  }
  return titles;
}

}  // namespace

int DrawOverlays(const OverlayFlags& flags) {
  const std::vector<std::string> folders =
      flags.suite.empty()
          ? flags.runs
          : SuiteRunFolders({flags.suite, flags.sequence, flags.variants, flags.seed});
  const std::string images_folder = flags.suite.empty() ? flags.sequence : "";
  const bool inferred = flags.labels.empty() ? folders.size() > 1 : flags.labels == "inferred";
  if (flags.panels && folders.size() > 1) throw UsageError("--panels needs exactly one run");
  OverlayJob job;
  for (const std::string& folder : folders) {
    job.read.insert(job.read.end(), {folder, std::filesystem::path(folder) / "clusters"});
    job.runs.push_back(reports::ReadOverlayRun(
        folder, inferred ? reports::LandmarkLabel::kInferred : reports::LandmarkLabel::kCluster));
    for (const std::string& line : job.runs.back().missing) {
      std::cerr << "clustervo: " << line << '\n';
    }
  }
  CheckSameSequence(job.runs, folders);
  reports::AgreeOnColors(job.runs);
  job.titles = Titles(job.runs, folders);
  job.boxes = !inferred;
  job.frames = SelectFrames(flags, job.runs);
  job.scale = flags.scale;
  job.output = flags.output;
  job.images = !flags.no_images;
  job.inset = !flags.no_inset;
  job.panels = flags.panels;
  job.sheet = flags.sheet;
  job.video = flags.video;
  job.quiet = flags.quiet;
  const RunImages images(job.runs.front(), images_folder);
  for (reports::OverlayRun& run : job.runs) {
    if (AdoptDetections(FindDetections(images_folder, run), run)) continue;
    if (run.sequence.detections == 0) continue;
    std::cerr << "clustervo: note: the run's detection file was not found or is of another camera, "
                 "so only detections that were assigned to a cluster are drawn\n";
  }
  job.inset_corner = reports::EmptiestCorner(job.runs.front());
  return WriteOverlays(job, images);
}

namespace {

void AddSuiteFlags(CLI::App& app, const std::shared_ptr<OverlayFlags>& flags) {
  CLI::Option* runs = app.add_option("RUN", flags->runs,
                                     "output folder of clustervo run, or DIR/jobs/ID of a suite; "
                                     "several runs on one sequence are drawn side by side")
                          ->type_name("");
  CLI::Option* suite =
      app.add_option("--suite", flags->suite, "output folder of a suite, to use instead of RUN")
          ->type_name("DIR");
  suite->excludes(runs);
  app.add_option("--sequence", flags->sequence,
                 "folder of the images, if they have moved since the run; with --suite: name of a "
                 "sequence of the suite")
      ->type_name("FOLDER|NAME");
  app.add_option("--variant", flags->variants,
                 "with --suite: variant to draw; several are drawn side by side")
      ->type_name("A,B,...")
      ->capture_default_str()
      ->needs(suite);
  app.add_option_function<std::string>(
         "--seed", [flags](const std::string& text) { flags->seed = ParseSeed(text); },
         "with --suite: seed to draw; default: the first of the suite")
      ->type_name("N")
      ->needs(suite);
}

void AddDrawingFlags(CLI::App& app, OverlayFlags& flags) {
  const auto add = [&app](const char* flag, auto& value, const char* kind, const char* meaning) {
    return app.add_option(flag, value, meaning)->type_name(kind);
  };
  add("-o,--output", flags.output, "DIR", "output folder for DIR/000123.png etc.")->required();
  CLI::Option* frame = add("--frame", flags.frame, "N", "draw only this frame");
  frame->check(CLI::NonNegativeNumber.description(""));
  add("--frames", flags.frames, "A:B", "frames A to B-1 as numbered in the sequence; default: all")
      ->excludes(frame);
  add("--every", flags.every, "K", "draw every K-th frame; default: 1")
      ->check(CLI::Range(1, 1000000).description(""));
  add("--scale", flags.scale, "S", "scale of the drawing relative to the image; default: 1")
      ->check(CLI::Range(0.1, 4.0).description(""))
      ->check(FiniteProblem);
  add("--labels", flags.labels, "NAME",
      "label that colours the landmarks: cluster (the cluster they belong to) or inferred (the "
      "label inferred from the energy terms in the frame, drawn without 3D boxes); default: "
      "cluster, for several runs inferred")
      ->check(OneOf({"cluster", "inferred"}));
  app.add_flag("--sheet", flags.sheet,
               "also write DIR/sheet.png: evenly spaced frames in one image");
  app.add_flag("--video", flags.video,
               "also write DIR/video.mp4, or .webm or .avi if OpenCV cannot write MP4");
  app.add_flag("--no-images", flags.no_images, "write only the sheet or video, no image per frame");
  app.add_flag("--panels", flags.panels,
               "with --frame N and one run: write DIR/panels.jpg instead, four views of the frame: "
               "landmarks, boxes and tracks, bird's-eye view, and errors over time");
  app.add_flag("--no-inset", flags.no_inset, "omit the bird's-eye view in the corner");
  AddQuiet(app, flags.quiet);
}

}  // namespace

Command AddOverlayCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "overlay", "Draw the results of a run on the left images: landmarks, boxes, ids, motion");
  const auto flags = std::make_shared<OverlayFlags>();
  AddSuiteFlags(*app, flags);
  AddDrawingFlags(*app, *flags);
  app->footer(
      "Landmarks are drawn if the run has landmarks.csv (clustervo run --landmarks; in a suite, "
      "the\nfirst seed). A cluster id has the same colour in all frames; with several runs, the "
      "colours\nare those of the last run. Up to 16 clusters that exist at the same time "
      "have\ndifferent colours. Dashed and shaded: clusters with too few landmarks in the frame, "
      "drawn at\ntheir predicted pose. White rings (inferred labels): wrong labels, if the run has "
      "ground truth.\nPictures at least 600 pixels wide have a legend and a bird's-eye view, "
      "placed in the corner\nwith the fewest bodies.\n"
      "Examples:\n"
      "  clustervo overlay results/indoor_1 -o pictures --every 5 --sheet --video\n"
      "  clustervo overlay results/indoor_1 -o pictures --frame 60 --panels\n"
      "  clustervo overlay RUN_2D RUN_2D3D RUN_FULL --frame 120 -o figure   # as labelled by each\n"
      "  clustervo overlay --suite results/ablation --sequence room_1000 --variant 2d,2d3d,full "
      "\\\n"
      "      --frame 40 -o figure");
  app->callback([flags] {
    if (flags->panels && flags->frame < 0) throw CLI::RequiredError("--panels: --frame N");
    if (flags->panels && (flags->sheet || flags->video)) {
      throw CLI::ValidationError("--panels",
                                 "draws one frame and cannot be combined with --sheet or --video");
    }
    if (flags->runs.empty() && flags->suite.empty()) throw CLI::RequiredError("RUN or --suite");
    if (!flags->suite.empty() && flags->sequence.empty()) {
      throw CLI::RequiredError("--suite: --sequence NAME");
    }
    if (flags->no_images && !flags->sheet && !flags->video) {
      throw CLI::RequiredError("--no-images: --sheet or --video");
    }
  });
  return {app, [flags] { return DrawOverlays(*flags); }};
}

}  // namespace cvo
