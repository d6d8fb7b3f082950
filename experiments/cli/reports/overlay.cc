// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "core/record/suite_runs.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "experiments/datasets/sequence.h"
#include "experiments/runner/given.h"
#include "reports/overlays/canvas.h"
#include "reports/overlays/draw_overlay.h"
#include "reports/overlays/overlay_run.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSheet = "sheet.png";

bool HasFrame(const reports::OverlayRun& run, int frame) {
  return std::any_of(run.detail.camera.begin(), run.detail.camera.end(),
                     [frame](const reports::CameraFrame& entry) { return entry.frame == frame; });
}

// Returns the folder of the first run in the plan that is selected, with this variant.
std::string FolderOf(const reports::SuitePlan& plan, const OverlayFlags& flags,
                     const std::string& variant) {
  const std::string wanted = StrCat(flags.sequence, ", ", variant);
  std::vector<std::string> known;
  for (const reports::PlannedRun& run : plan.runs) {
    const std::string& sequence = run.keys.at("sequence");
    AddOnce(StrCat(sequence, ", ", run.keys.at("variant")), known);
    if (sequence != flags.sequence || run.keys.at("variant") != variant) continue;
    if (!run.system.empty() || (flags.seed && run.seed != *flags.seed)) continue;
    if (run.job.empty()) ThrowError(wanted, run.missing, "a sequence that exists");
    return (fs::path(flags.suite) / "jobs" / run.job).string();
  }
  ThrowError(plan.file.string(),
             StrCat("no run of ", wanted, flags.seed ? StrCat(", seed ", *flags.seed) : ""),
             OneOfKnown(wanted, known));
}

// Returns the folders of the selected runs of a suite, in the order of the variants.
std::vector<std::string> SuiteRunFolders(const OverlayFlags& flags) {
  const reports::SuitePlan plan = reports::ReadPlan(fs::path(flags.suite) / "plan.json");
  std::vector<std::string> folders;
  for (const std::string& variant : AtCommas(flags.variants)) {
    folders.push_back(FolderOf(plan, flags, variant));
  }
  return folders;
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

// Titles of the runs: the variant, or the folder if several runs are of this variant.
std::vector<std::string> Titles(const std::vector<reports::OverlayRun>& runs,
                                const std::vector<std::string>& folders) {
  std::vector<std::string> variants;
  for (const reports::OverlayRun& run : runs) variants.push_back(run.variant);
  return UniqueNames(variants, folders);
}

std::string ImageName(int frame, bool svg) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), svg ? "%06d.svg" : "%06d.png", frame);
  return name.data();
}

// Draws frames of one run, or of several side by side, and writes the files.
class OverlayWriter {
 public:
  OverlayWriter(const OverlayFlags& flags, const std::vector<std::string>& folders);

  // Returns the exit code.
  int WriteAll();

 private:
  bool wide() const { return camera_.width_px > 2 * camera_.height_px; }
  reports::OverlayStyle StyleOf(int width_px) const;
  // All runs side by side, or one below the other if they are wide; each is `width_px` wide.
  cv::Mat Draw(const cv::Mat& image, int frame, int width_px) const;
  void WriteFrame(int frame, const fs::path& folder);
  void Finish(const fs::path& folder);

  const OverlayFlags& flags_;
  std::vector<fs::path> read_;  // folders of the runs
  std::vector<reports::OverlayRun> runs_;
  std::vector<std::string> titles_;
  bool inferred_ = false;
  reports::CameraInfo camera_;
  std::vector<int> frames_;
  std::optional<RunImages> images_;
  std::vector<int> on_sheet_;
  std::vector<cv::Mat> tiles_;
};

OverlayWriter::OverlayWriter(const OverlayFlags& flags, const std::vector<std::string>& folders)
    : flags_(flags),
      inferred_(flags.labels.empty() ? folders.size() > 1 : flags.labels == "inferred") {
  for (const std::string& folder : folders) {
    read_.insert(read_.end(), {folder, fs::path(folder) / "clusters"});
    runs_.push_back(reports::ReadOverlayRun(
        folder, inferred_ ? reports::LandmarkLabel::kInferred : reports::LandmarkLabel::kCluster));
    for (const std::string& line : runs_.back().missing) {
      PrintNotice("drawn " + line);
    }
  }
  CheckSameSequence(runs_, folders);
  titles_ = Titles(runs_, folders);
  camera_ = runs_.front().sequence.camera;
  frames_ = SelectFrames(flags, runs_);
  const std::string images_folder = flags.suite.empty() ? flags.sequence : "";
  images_.emplace(runs_.front(), images_folder);
  for (reports::OverlayRun& run : runs_) {
    if (run.sequence.detections == 0 || AddDetections(images_folder, run)) continue;
    PrintNotice("note: the run's detection file was not found, so no detections are drawn");
  }
  for (reports::OverlayRun& run : runs_) {
    if (flags.truth) AddTruthBoxes(images_->sequence(), run);
  }
  const std::size_t most = runs_.size() > 1 ? 8 : wide() ? 20 : 24;
  for (const std::size_t i : reports::EvenlySpaced(frames_.size(), flags.sheet ? most : 0)) {
    on_sheet_.push_back(frames_[i]);
  }
}

reports::OverlayStyle OverlayWriter::StyleOf(int width_px) const {
  reports::OverlayStyle style = reports::StyleFor(camera_, width_px);
  style.inset = style.inset && !inferred_;
  style.boxes = !inferred_;
  style.wrong = inferred_;
  style.plain = flags_.plain;
  return style;
}

cv::Mat OverlayWriter::Draw(const cv::Mat& image, int frame, int width_px) const {
  std::vector<cv::Mat> pictures;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    reports::OverlayFrame drawn = reports::FrameOf(runs_[i], frame);
    if (runs_.size() > 1) drawn.run = titles_[i];
    pictures.push_back(reports::DrawOverlay(image, drawn, camera_, StyleOf(width_px)));
  }
  return reports::Grid(pictures, wide() ? 1 : static_cast<int>(pictures.size()));
}

void OverlayWriter::WriteFrame(int frame, const fs::path& folder) {
  cv::Mat image = images_->Left(frame);
  if (image.empty()) image = cv::Mat::zeros(camera_.height_px, camera_.width_px, CV_8UC1);
  if (!flags_.no_images) {
    const int width_px = camera_.width_px;
    const std::string bytes =
        flags_.svg ? reports::OverlaySvg(image, reports::FrameOf(runs_.front(), frame), camera_,
                                         StyleOf(width_px))
                   : reports::PngBytes(Draw(image, frame, width_px));
    WriteFilesAtomically(folder, {{ImageName(frame, flags_.svg), bytes}});
  }
  if (std::find(on_sheet_.begin(), on_sheet_.end(), frame) == on_sheet_.end()) return;
  tiles_.push_back(Draw(image, frame, std::min(wide() ? 800 : 480, camera_.width_px)));
}

void OverlayWriter::Finish(const fs::path& folder) {
  const auto path = [&](const std::string& name) { return (folder / name).string(); };
  if (!flags_.no_images) {
    std::cout << "written: " << path(ImageName(frames_.front(), flags_.svg));
    if (frames_.size() > 1) {
      std::cout << " to " << ImageName(frames_.back(), flags_.svg) << " (" << frames_.size()
                << " images)";
    }
    std::cout << '\n';
  }
  if (flags_.sheet) {
    const cv::Mat sheet = reports::Grid(tiles_, wide() ? 2 : runs_.size() > 1 ? 1 : 4);
    WriteFilesAtomically(folder, {{kSheet, reports::PngBytes(sheet)}});
    std::cout << "written: " << path(kSheet) << " (" << tiles_.size() << " frames)\n";
  }
}

int OverlayWriter::WriteAll() {
  std::vector<std::string> names;
  for (const int frame : frames_) {
    if (!flags_.no_images) names.push_back(ImageName(frame, flags_.svg));
  }
  if (flags_.sheet) names.emplace_back(kSheet);
  const OutputFolder output = OpenOutput(flags_.output, names, read_);
  {
    const StopSignal stop;
    Progress progress(flags_.quiet);
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      WriteFrame(frames_[i], output.path());
      progress.Report(i + 1, frames_.size());
      if (!stop.Requested()) continue;
      PrintNotice(StrCat("stopped after ", i + 1, " of ", frames_.size(), " frames"));
      return kInterrupted;
    }
  }
  Finish(output.path());
  return 0;
}

}  // namespace

int DrawOverlays(const OverlayFlags& flags) {
  const std::vector<std::string> folders =
      flags.suite.empty() ? flags.runs : SuiteRunFolders(flags);
  if (flags.svg && folders.size() > 1) {
    throw UsageError(StrCat("--svg: found ", folders.size(), " runs, expected one"));
  }
  return OverlayWriter(flags, folders).WriteAll();
}

namespace {

void AddSuiteFlags(CLI::App& app, OverlayFlags& flags) {
  const FlagAdder add{app};
  CLI::Option* runs = add("RUN", flags.runs, "",
                          "output folder of clustervo run, or DIR/jobs/ID of a suite; "
                          "several runs on one sequence are drawn side by side");
  CLI::Option* suite =
      add("--suite", flags.suite, "DIR", "output folder of a suite, to use instead of RUN");
  suite->excludes(runs);
  add("--sequence", flags.sequence, "FOLDER|NAME",
      "folder of the images, if they have moved since the run; with --suite: name of a "
      "sequence of the suite");
  add("--variant", flags.variants, "A,B,...",
      "with --suite: variant to draw; several are drawn side by side")
      ->capture_default_str()
      ->needs(suite);
  AddSeed(app, flags.seed, "with --suite: seed to draw; default: the first of the suite")
      ->needs(suite);
}

void AddDrawingFlags(CLI::App& app, OverlayFlags& flags) {
  const FlagAdder add{app};
  add("-o,--output", flags.output, "DIR", "output folder for DIR/000123.png etc.")->required();
  CLI::Option* frame = add("--frame", flags.frame, "N", "draw only this frame");
  frame->check(CLI::NonNegativeNumber.description(""));
  add("--frames", flags.frames, "A:B", "frames A to B-1 as numbered in the sequence; default: all")
      ->excludes(frame);
  add("--every", flags.every, "K", "draw every K-th frame; default: 1")->check(Within(1, 1000000));
  add("--labels", flags.labels, "NAME",
      "label that colours the landmarks: cluster (the cluster they belong to) or inferred (the "
      "label inferred from the energy terms in the frame, drawn without 3D boxes); default: "
      "cluster, for several runs inferred")
      ->check(OneOf({"cluster", "inferred"}));
  app.add_flag("--sheet", flags.sheet,
               "also write DIR/sheet.png: evenly spaced frames in one image");
  app.add_flag("--no-images", flags.no_images, "write only the sheet, no image per frame");
  app.add_flag("--truth", flags.truth, "also draw boxes around the true bodies, dashed");
  app.add_flag("--plain", flags.plain, "without names, line of text and bird's-eye view");
  app.add_flag("--svg", flags.svg,
               "of one run: DIR/000123.svg, with vectors over the image, instead of PNG files");
  AddQuiet(app, flags.quiet);
}

}  // namespace

Command AddOverlayCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "overlay", "Draw the results of a run on the left images: landmarks, boxes, ids, motion");
  const auto flags = std::make_shared<OverlayFlags>();
  AddSuiteFlags(*app, *flags);
  AddDrawingFlags(*app, *flags);
  app->footer(
      "Landmarks are drawn if the run has landmarks.csv (clustervo run --landmarks; in a suite, "
      "the\nfirst seed): in the colour of their cluster, which its id determines; small and grey: "
      "static;\nwhite points: outliers. White rectangles: detections. Coloured boxes: clusters in "
      "3D, each with\nits path in the last two seconds and an arrow to where it is in half a "
      "second; dashed: at the\npredicted pose, with too few landmarks in the frame. White rings "
      "(inferred labels): wrong labels,\nif the run has ground truth. Pictures at least 600 pixels "
      "wide have a bird's-eye view of the bodies.\n"
      "Examples:\n"
      "  clustervo overlay results/indoor_1 -o pictures --every 5 --sheet\n"
      "  clustervo overlay RUN_2D RUN_2D3D RUN_FULL --frame 120 -o figure   # as labelled by each\n"
      "  clustervo overlay --suite results/ablation --sequence room_1000 --variant 2d,2d3d,full "
      "\\\n"
      "      --frame 40 -o figure");
  app->callback([flags] {
    if (flags->runs.empty() && flags->suite.empty()) throw CLI::RequiredError("RUN or --suite");
    if (!flags->suite.empty() && flags->sequence.empty()) {
      throw CLI::RequiredError("--suite: --sequence NAME");
    }
    if (flags->no_images && !flags->sheet) {
      throw CLI::RequiredError("--no-images: --sheet");
    }
  });
  return {app, [flags] { return DrawOverlays(*flags); }};
}

}  // namespace cvo
