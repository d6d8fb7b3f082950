// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text_file.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "experiments/metrics/trajectory.h"
#include "reports/figures/figure_style.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using reports::NumberText;
using reports::Panel;
using reports::Series;
using reports::SeriesKind;

struct PlotFlags {
  std::vector<std::string> inputs;
  std::string groundtruth;
  std::string align;
  std::string up = "y";
  double max_time_difference_s = 1e-9 * static_cast<double>(kDefaultAssociation_ns);
  SuiteFigureFlags suite;  // output and style: also of trajectories
};

// What is drawn of positions and times.
struct Axes {
  std::size_t ahead = 2;  // the axis that is vertical on the map
  double first_s = 0.0;
};

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
  for (const std::string& path : flags.inputs) {
    content.inputs.push_back(ReadPlotInput(path, content.notes));
  }
  if (!flags.groundtruth.empty()) {
    content.inputs.push_back(ReadPlotInput(flags.groundtruth, content.notes));
  }
  MakeComparable(content.inputs);
  if (!flags.groundtruth.empty()) {
    const PlotInput truth = std::move(content.inputs.back());
    content.inputs.pop_back();
    content.reference = PlotReference{truth.name, truth.poses, true, false, truth.has_rotations};
  } else {
    content.reference = ReferenceAmong(content.inputs);
  }
  content.matching = {AlignmentOf(flags.align, content), flags.up == "z",
                      static_cast<std::int64_t>(std::llround(1e9 * flags.max_time_difference_s)),
                      0};
  for (const PlotInput& input : content.inputs) {
    const bool is_reference =
        content.reference && !content.reference->is_truth && content.tracks.empty();
    content.tracks.push_back(content.reference && !is_reference
                                 ? MatchTrack(*content.reference, input, content.matching)
                                 : PlotTrack{input.name, input.poses});
  }
  return content;
}

std::string TitleOf(const PlotContent& content) {
  const std::optional<PlotReference>& reference = content.reference;
  if (!reference) return "Trajectory of " + content.inputs.front().name + ". No ground truth";
  const std::string title =
      StrCat("Trajectories against ", reference->name, ". ",
             reports::Capitalised(DescriptionOf(content.matching.alignment)), "; poses matched ");
  if (!content.inputs.front().timed) return title + "by line number";
  return StrCat(title, "within ", Seconds(content.matching.tolerance_ns), " s");
}

std::string CaptionOf(const PlotContent& content) {
  std::string caption = StrCat(
      "Grey: truth. Dot: start. The map is seen from above, with ",
      content.matching.z_up ? "z up" : "y down",
      "; both its axes have one scale. Thin: moving bodies where their estimate counts, with "
      "the truth aligned by the camera. For rotation errors, orientations are aligned by "
      "their own mean.");
  if (content.reference && !content.reference->is_truth) {
    caption +=
        StrCat(" Distances are from ", content.reference->name, ", which is no ground truth.");
  }
  return caption;
}

struct Path {
  std::vector<double> time;
  std::array<std::vector<double>, 3> axes;

  void Add(double at, const auto& position) {
    time.push_back(at);
    for (const int axis : {0, 1, 2}) axes[static_cast<std::size_t>(axis)].push_back(position[axis]);
  }
};

// The line through (x, y), broken where the time leaps.
Series LineThrough(Series series, const std::vector<double>& time, const std::vector<double>& x,
                   const std::vector<double>& y) {
  constexpr double kLeap = 5.5;  // median steps
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> steps;
  for (std::size_t i = 1; i < time.size(); ++i) steps.push_back(time[i] - time[i - 1]);
  const double longest = steps.empty() ? 0.0 : kLeap * Median(steps);
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (i > 0 && time[i] - time[i - 1] > longest) series.data.push_back({kGap, kGap});
    series.data.push_back({x[i], y[i]});
  }
  return series;
}

// Adds a line to the map, the first panel, with a disc and a text at its start.
void AddToMap(const Path& path, const Series& series, const std::string& start, const Axes& axes,
              Panel& map) {
  if (path.time.empty()) return;
  map.series.push_back(LineThrough(series, path.time, path.axes[0], path.axes[axes.ahead]));
  reports::Datum first{path.axes[0].front(), path.axes[axes.ahead].front(), "start", start};
  reports::Look look = series.look;
  look.symbol = reports::Symbol::kCircle;
  map.series.push_back({SeriesKind::kPoints, "", look, {std::move(first)}});
}

void AddTrack(const Trajectory& poses, const Series& series, const Axes& axes,
              std::vector<Panel>& panels) {
  Path path;
  for (const TimedPose& pose : poses) {
    path.Add(Seconds(pose.timestamp_ns) - axes.first_s, pose.world_from_camera.translation());
  }
  AddToMap(path, series, "", axes, panels[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    panels[1 + i].series.push_back(LineThrough(series, path.time, path.time, path.axes[i]));
  }
}

// Adds a moving body of a run to the map, from the first to the last frame in which it is visible.
void AddBody(const reports::BodyDetail& body, reports::Look look, const Axes& axes, Panel& map) {
  if (!body.mover || body.visible.empty()) return;
  Path truth;
  Path estimate;
  for (const auto& [frame, pose] : body.truth) {
    if (frame >= body.visible.front() && frame <= body.visible.back()) truth.Add(frame, pose);
  }
  for (const reports::BodyPosition& at : body.estimated) estimate.Add(at.frame, at.position_m);
  AddToMap(truth, {SeriesKind::kLine, "", {0, {}, 0, 2.0}, {}, body.name + ", truth"}, body.name,
           axes, map);
  look.width = 0.9;
  AddToMap(estimate, {SeriesKind::kLine, "", look, {}, body.name},
           truth.time.empty() ? body.name : "", axes, map);
}

// The map, the coordinates over time and, if there is a reference, the errors over time.
std::vector<Panel> EmptyPanels(const PlotContent& content) {
  const bool errors = !content.reference || content.reference->is_truth;
  const char* titles[] = {content.matching.z_up ? "y (m)" : "z, ahead (m)",
                          "x (m)",
                          "y (m)",
                          "z (m)",
                          errors ? "position error (m)" : "distance (m)",
                          errors ? "rotation error (deg)" : "rotation difference (deg)"};
  std::vector<Panel> panels(content.reference ? 6 : 4);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    panels[i].x.title = content.inputs.front().timed ? "time (s)" : "pose";
    panels[i].y.title = titles[i];
    panels[i].y.from_zero = i > 3;
    panels[i].aspect = 0.12;
  }
  panels[0].x.title = "x (m)";
  panels[0].equal_scale = true;
  panels[0].aspect = 0.7;
  return panels;
}

}  // namespace

reports::Figure TrajectoryFigure(const PlotContent& content) {
  std::vector<std::string> names;
  Axes axes{content.matching.z_up ? 1U : 2U, std::numeric_limits<double>::infinity()};
  for (const PlotTrack& track : content.tracks) {
    names.push_back(track.name);
    axes.first_s = std::min(axes.first_s, Seconds(track.poses.front().timestamp_ns));
  }
  const reports::Palette palette(names);
  const std::optional<PlotReference>& reference = content.reference;
  std::vector<Panel> panels = EmptyPanels(content);
  if (reference && reference->is_truth) {
    axes.first_s = std::min(axes.first_s, Seconds(reference->poses.front().timestamp_ns));
    AddTrack(reference->poses, {SeriesKind::kLine, reference->name, {0, {}, 0, 3.0}, {}}, axes,
             panels);
  }
  for (const PlotTrack& track : content.tracks) {
    Series series{SeriesKind::kLine, track.name, palette.Line(track.name), {}};
    std::vector<double> time;
    for (const double at_s : track.times_s) time.push_back(at_s - axes.first_s);
    if (!track.errors_m.empty()) {
      series.name += StrCat(": ", NumberText(RootMeanSquare(track.errors_m).value()), " m rms");
      panels[4].series.push_back(LineThrough(series, time, time, track.errors_m));
      if (!track.errors_deg.empty()) {
        panels[5].series.push_back(LineThrough(series, time, time, track.errors_deg));
      }
    }
    AddTrack(track.poses, series, axes, panels);
  }
  const bool bodies = content.inputs.size() == 1 && reference && reference->of_run;
  for (const reports::BodyDetail& body : content.inputs.front().bodies) {
    if (bodies) AddBody(body, palette.Line(names.front()), axes, panels[0]);
  }
  reports::Figure figure{"", TitleOf(content), CaptionOf(content), {}};
  if (reference && panels[5].series.empty()) panels.pop_back();  // no rotations
  figure.chart.panels = std::move(panels);
  figure.chart.share_x = true;
  return figure;
}

std::string FormatOfFigure(const std::string& flag, const std::string& output) {
  const std::string extension = fs::path(output).extension().string();
  if (extension == ".svg" || extension == ".pdf") return extension.substr(1);
  throw UsageError(StrCat(flag, " ", output, ": found ", Quoted(extension),
                          ", expected a name that ends in .svg or .pdf"));
}

namespace {

int DrawPlot(const PlotFlags& flags) {
  const std::string format = FormatOfFigure("-o", flags.suite.output);
  std::vector<fs::path> read(flags.inputs.begin(), flags.inputs.end());
  if (!flags.groundtruth.empty()) read.emplace_back(flags.groundtruth);
  CheckOutputFile(flags.suite.output, read);
  const PlotContent content = ReadContent(flags);
  const reports::Figure figure = TrajectoryFigure(content);
  WriteOutputFile(flags.suite.output, FigureFile(figure, flags.suite.style, format), read);
  std::cout << figure.title << '\n';
  PrintTracks(content.tracks);
  std::cerr << content.notes;
  std::cout << "written: " << flags.suite.output << '\n';
  return 0;
}

int Plot(const CLI::App& app, const PlotFlags& flags) {
  const auto suite = std::find_if(
      flags.inputs.begin(), flags.inputs.end(),
      [](const std::string& input) { return fs::exists(fs::path(input) / "plan.json"); });
  if (suite == flags.inputs.end()) {
    RefuseFlags(app, {"--format", "--only"}, "applies to a suite");
    return DrawPlot(flags);
  }
  if (flags.inputs.size() > 1) {
    throw UsageError(StrCat(*suite, ": found the folder of a suite, expected it alone"));
  }
  RefuseFlags(app, {"--groundtruth", "--align", "--up", "--max-time-difference"},
              "applies to trajectories, found a suite");
  SuiteFigureFlags of_suite = flags.suite;
  of_suite.folder = *suite;
  return WriteFigures(of_suite);
}

}  // namespace

Command AddPlotCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "plot",
      "Plot trajectories from above and over time, with their errors, or the figures of a suite");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<PlotFlags>();
  add("FILE|DIR", flags->inputs, "",
      "trajectories in the format of TUM, KITTI or EuRoC and output folders of runs; or "
      "the output folder of one suite")
      ->required();
  add("--groundtruth", flags->groundtruth, "FILE",
      "trajectory to compare with; default: the ground truth of the first run that has "
      "one, otherwise the first trajectory");
  add("--align", flags->align, "NAME",
      "how trajectories are aligned with it: none, se3, sim3 (with scale), origin (at "
      "the first common pose) or yaw (about the vertical, and translation); default: "
      "se3 with ground truth, otherwise none")
      ->check(OneOf({"none", "se3", "sim3", "origin", "yaw"}));
  add("--up", flags->up, "AXIS", "vertical axis: y (down, as cameras have it) or z (up)")
      ->check(OneOf({"y", "z"}))
      ->capture_default_str();
  add("--max-time-difference", flags->max_time_difference_s, "S",
      "maximum time difference of matching poses, in seconds")
      ->check(Within(0.0, 1e6))
      ->capture_default_str();
  add("-o,--output", flags->suite.output, "FILE|FOLDER",
      "output file, .svg or .pdf (made by rsvg-convert); of a suite: output folder")
      ->required();
  add("--format", flags->suite.format, "FORMAT", "of a suite: svg or pdf; default: svg")
      ->check(OneOf({"svg", "pdf"}));
  add("--only", flags->suite.only, "ID",
      "of a suite: write only this figure, given by its file name");
  AddChartStyle(*app, flags->suite.style);
  app->footer(
      "Title and caption state alignment and pairing. KITTI files have no timestamps: their poses "
      "are\nmatched by line number, and all files must have the same number of poses. The figures "
      "of a suite\ndepend on its results: varied options, references, bodies with ground truth, "
      "times. Those that\ncannot be drawn are listed with the reason. PDF needs rsvg-convert "
      "(Debian: librsvg2-bin). The\nsame input gives the same bytes.\n"
      "Examples:\n"
      "  clustervo plot results/room results/static -o cameras.svg\n"
      "  clustervo plot mine.txt theirs.txt --groundtruth poses/06.txt --align sim3 -o 06.pdf\n"
      "  clustervo plot results/ablation -o figures --width-mm 84 --font-pt 8 --no-title");
  return {app, [app, flags] { return Plot(*app, *flags); }};
}

}  // namespace cvo
