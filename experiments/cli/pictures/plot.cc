// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/pictures/plot_tracks.h"
#include "experiments/cli/pictures/render_figures.h"
#include "experiments/cli/run/text_table.h"
#include "experiments/metrics/association.h"
#include "reports/figure_files/interactive_page.h"
#include "reports/figures/numbers.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using reports::Vertical;

struct PlotFlags {
  std::vector<std::string> inputs;
  std::string groundtruth;
  std::string align;
  std::string up;
  double max_time_difference_s = 1e-9 * static_cast<double>(kDefaultAssociation_ns);
  std::string output;
};

// The trajectories to plot and how they compare.
struct PlotContent {
  std::vector<PlotInput> inputs;
  std::optional<PlotReference> reference;
  PlotMatching matching;
  std::vector<MatchedTrack> tracks;  // one per input
};

double ExtentAlong(Eigen::Index axis, const Trajectory& poses) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const TimedPose& pose : poses) {
    low = std::min(low, pose.world_from_camera.translation()[axis]);
    high = std::max(high, pose.world_from_camera.translation()[axis]);
  }
  return high - low;
}

// Runs and KITTI files have y down. For others, the vertical is the axis, y or z, along which they
// extend less.
Vertical VerticalOf(const std::string& up, const PlotContent& content) {
  if (!up.empty()) return up == "z" ? Vertical::kZUp : Vertical::kYDown;
  const bool cameras = std::any_of(content.inputs.begin(), content.inputs.end(),
                                   [](const PlotInput& input) { return input.camera_axes; });
  const Trajectory& shown =
      content.reference ? content.reference->poses : content.inputs.front().poses;
  return cameras || ExtentAlong(1, shown) <= ExtentAlong(2, shown) ? Vertical::kYDown
                                                                   : Vertical::kZUp;
}

TrajectoryAlignment AlignmentOf(const std::string& align, const PlotContent& content) {
  const std::optional<PlotReference>& reference = content.reference;
  if (!reference && !align.empty() && align != "none") {
    throw UsageError("--align: needs --groundtruth, a run with truth or a second trajectory");
  }
  if (!align.empty()) return ParseTrajectoryAlignment(align);
  return reference && reference->is_truth ? TrajectoryAlignment::kSe3 : TrajectoryAlignment::kNone;
}

PlotContent ReadContent(const PlotFlags& flags) {
  PlotContent content;
  for (const std::string& path : flags.inputs) content.inputs.push_back(ReadPlotInput(path));
  if (!flags.groundtruth.empty()) content.inputs.push_back(ReadPlotInput(flags.groundtruth));
  MakeComparable(content.inputs);
  if (!flags.groundtruth.empty()) {
    const PlotInput truth = std::move(content.inputs.back());
    content.inputs.pop_back();
    content.reference = PlotReference{truth.name, truth.poses, true, false};
  } else {
    content.reference = ReferenceAmong(content.inputs);
  }
  content.matching = {AlignmentOf(flags.align, content), VerticalOf(flags.up, content),
                      static_cast<std::int64_t>(std::llround(1e9 * flags.max_time_difference_s))};
  for (const PlotInput& input : content.inputs) {
    const bool is_reference =
        content.reference && !content.reference->is_truth && content.tracks.empty();
    content.tracks.push_back(content.reference && !is_reference
                                 ? MatchTrack(*content.reference, input, content.matching)
                                 : TrackOf(input.name, input.poses));
  }
  return content;
}

// Shifts all times so that the earliest is zero.
void StartAtZero(reports::TrajectoryPlot& plot) {
  double first = std::numeric_limits<double>::infinity();
  const auto each = [&](const auto& act) {
    for (auto* tracks : {&plot.truth, &plot.tracks}) {
      for (reports::PlottedTrack& track : *tracks) {
        for (auto* times :
             {&track.time, &track.position_error_m.time, &track.rotation_error_deg.time}) {
          for (double& time : *times) act(time);
        }
      }
    }
  };
  each([&](double& time) { first = std::min(first, time); });
  each([&](double& time) { time -= first; });
}

std::string TitleOf(const PlotContent& content) {
  const std::optional<PlotReference>& reference = content.reference;
  if (!reference) return "Trajectory of " + content.inputs.front().name + ". No ground truth";
  const TrajectoryAlignment alignment = content.matching.alignment;
  std::string title = StrCat(content.inputs.size() > 1 ? "Trajectories" : "Trajectory", " against ",
                             reference->name, ". ", reports::Capitalised(DescriptionOf(alignment)));
  if (alignment == TrajectoryAlignment::kNone && reference->of_run) {
    title += " here (the truth is in the world of its run, aligned by the camera)";
  }
  if (!content.inputs.front().timed) return title + "; poses matched by line number";
  return StrCat(title, "; poses matched within ",
                1e-9 * static_cast<double>(content.matching.tolerance_ns), " s");
}

std::string CaptionOf(const PlotContent& content, bool bodies) {
  const std::optional<PlotReference>& reference = content.reference;
  const TrajectoryAlignment alignment = content.matching.alignment;
  std::string caption = reference && reference->is_truth ? "Grey: truth. " : "";
  caption += StrCat("Dot: start. The map is seen from above, with ",
                    content.matching.vertical == Vertical::kYDown ? "y down" : "z up",
                    "; both its axes have one scale.");
  if (reference && !reference->is_truth) {
    caption += StrCat(" Distances are from ", reference->name, ", which is not ground truth.");
  }
  if (reference &&
      (alignment == TrajectoryAlignment::kSe3 || alignment == TrajectoryAlignment::kSim3)) {
    caption += " For rotation errors, orientations are aligned by their own mean.";
  }
  if (bodies) {
    caption +=
        " Thin: moving bodies where their estimate counts, with the truth aligned by the "
        "orientations of the camera.";
  }
  return caption;
}

reports::TrajectoryPlot PlotOf(const PlotContent& content) {
  reports::TrajectoryPlot plot;
  plot.vertical = content.matching.vertical;
  for (const MatchedTrack& track : content.tracks) {
    plot.tracks.push_back(track.track);
    if (track.matched == 0) continue;
    plot.tracks.back().legend += StrCat(": ", reports::NumberText(track.rms_m), " m rms");
  }
  const std::optional<PlotReference>& reference = content.reference;
  if (reference && reference->is_truth) {
    plot.truth.push_back(TrackOf(reference->name, reference->poses).track);
  }
  if (content.inputs.size() == 1 && reference && reference->of_run) {
    plot.bodies = MovingBodies(content.inputs.front());
  }
  plot.title = TitleOf(content);
  plot.caption = CaptionOf(content, !plot.bodies.empty());
  plot.time_title = content.inputs.front().timed ? "time (s)" : "pose";
  const bool errors = !reference || reference->is_truth;
  plot.error_title = errors ? "position error" : "distance";
  plot.rotation_title = errors ? "rotation error" : "rotation difference";
  StartAtZero(plot);
  return plot;
}

void PrintSummary(const std::vector<MatchedTrack>& tracks) {
  TextTable table(
      {"trajectory", "poses", "matched", "rms m", "mean m", "max m", "rms deg", "scale"});
  for (const MatchedTrack& track : tracks) {
    if (track.matched == 0) continue;
    table.Add({track.track.name, StrCat(track.track.time.size()), StrCat(track.matched),
               ReadableNumber(track.rms_m), ReadableNumber(track.mean_m),
               ReadableNumber(track.most_m), ReadableNumber(track.rms_deg),
               ReadableNumber(track.scale)});
  }
  if (table.Lines().size() > 1) table.Print(std::cout);
}

std::string FormatOfFile(const std::string& output) {
  const std::string extension = fs::path(output).extension().string();
  for (const char* known : {".svg", ".pdf", ".html"}) {
    if (extension == known) return extension.substr(1);
  }
  throw UsageError(StrCat("-o ", output, ": found ", Quoted(extension),
                          ", expected a name that ends in .svg, .pdf or .html"));
}

int DrawPlot(const PlotFlags& flags) {
  const std::string format = FormatOfFile(flags.output);
  std::vector<fs::path> read(flags.inputs.begin(), flags.inputs.end());
  if (!flags.groundtruth.empty()) read.emplace_back(flags.groundtruth);
  CheckOutputFile(flags.output, read);
  const PlotContent content = ReadContent(flags);
  const reports::TrajectoryPlot plot = PlotOf(content);
  const reports::Figure figure = reports::DrawTrajectoryPlot(plot);
  const std::string file = format == "html" ? reports::InteractivePage(figure)
                                            : RenderFigures({figure}, format).front().content;
  WriteOutputFile(flags.output, file, read);
  std::cout << plot.title << '\n';
  PrintSummary(content.tracks);
  std::cout << "written: " << flags.output << '\n';
  return 0;
}

}  // namespace

Command AddPlotCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "plot", "Plot trajectories from above and over time, with their errors, as SVG, PDF or HTML");
  const auto flags = std::make_shared<PlotFlags>();
  app->add_option("FILE|RUN", flags->inputs,
                  "trajectory in the format of TUM, KITTI or EuRoC, or the output folder of a run")
      ->type_name("")
      ->required();
  app->add_option("--groundtruth", flags->groundtruth,
                  "trajectory to compare with; default: the ground truth of the first run that has "
                  "one, otherwise the first trajectory")
      ->type_name("FILE");
  app->add_option("--align", flags->align,
                  "how trajectories are aligned with it: none, se3, sim3 (with scale), origin (at "
                  "the first common pose) or yaw (about the vertical, and translation); default: "
                  "se3 with ground truth, otherwise none")
      ->type_name("NAME")
      ->check(OneOf({"none", "se3", "sim3", "origin", "yaw"}));
  app->add_option("--up", flags->up,
                  "vertical axis: y (down, as cameras have it) or z (up); default: y for runs and "
                  "KITTI files, otherwise the axis with the smaller extent")
      ->type_name("AXIS")
      ->check(OneOf({"y", "z"}));
  app->add_option("--max-time-difference", flags->max_time_difference_s,
                  "maximum time difference of matching poses, in seconds")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e6).description(""))
      ->check(FiniteProblem)
      ->capture_default_str();
  app->add_option("-o,--output", flags->output, "output file: .svg, .pdf or .html")
      ->type_name("FILE")
      ->required();
  app->footer(
      "Title and caption state alignment and pairing. KITTI files have no timestamps: their poses "
      "are\nmatched by line number, and all files must have the same number of poses. SVG and PDF "
      "are\nrendered by Chromium (Debian's, or CLUSTERVO_BROWSER); HTML needs none. The same input "
      "gives\nthe same bytes.\n"
      "Examples:\n"
      "  clustervo plot results/room results/static -o cameras.svg\n"
      "  clustervo plot mine.txt theirs.txt --groundtruth poses/06.txt --align sim3 -o 06.html");
  return {app, [flags] { return DrawPlot(*flags); }};
}

}  // namespace cvo
