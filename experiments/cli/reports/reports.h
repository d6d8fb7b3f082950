// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/interface/frame.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/trajectory.h"
#include "reports/figures/suite_figures.h"
#include "reports/overlays/overlay_run.h"
#include "reports/runs/run_detail.h"
#include "reports/tables/make_table.h"

namespace cvo {

// How a table is printed, and where.
struct TableFormat {
  std::string format = "terminal";
  std::string output;  // a file; empty: standard output
  bool all = false;    // terminal, markdown: every column, not only those that tell most

  // Adds --format and --output.
  void AddTo(CLI::App& app);
};

// Prints the table, or writes it to its file, which must not be one of `read`, and reports the
// file's name. `after`: text that follows the table in the terminal format.
void OutputTable(const reports::Table& table, const TableFormat& format,
                 const std::vector<std::filesystem::path>& read, std::string after = "");

// The default values of the estimator's options, as nested JSON.
std::string DefaultOptions();

struct ReportFlags {
  std::string folder;
  std::string out = {};  // empty: the subfolder "report"
  bool no_images = false;
};

// Writes the page of a suite's results. Returns 1 if a whole section could not be made, else 0.
int WriteReport(const ReportFlags& flags);

struct OverlayFlags {
  std::vector<std::string> runs = {};
  std::string suite = {};
  std::string sequence = {};
  std::string variants = "full";
  std::optional<std::uint64_t> seed = {};
  std::string output = {};
  int frame = -1;
  std::string frames = {};
  int every = 1;
  std::string labels = {};
  bool sheet = false;
  bool no_images = false;
  bool truth = false;  // also the boxes of the true bodies
  bool plain = false;  // OverlayStyle::plain
  bool svg = false;    // vectors over the image
  bool quiet = false;
};

// Draws runs on their images. Returns the exit code. Throws Error.
int DrawOverlays(const OverlayFlags& flags);

// The flags --width-mm, --font-pt and --no-title.
void AddChartStyle(CLI::App& app, reports::ChartStyle& style);

// The content of a file with the figure, its title and its caption. `format` is "svg" or "pdf",
// which rsvg-convert makes. Throws Error if that is not in PATH, or fails.
std::string FigureFile(const reports::Figure& figure, const reports::ChartStyle& style,
                       const std::string& format);

struct SuiteFigureFlags {
  std::string folder;  // of the suite
  std::string output;  // a folder
  std::string format = "svg";
  std::string only;  // the name of a figure; empty: all
  reports::ChartStyle style;
};

// Writes the figures of a suite, and prints their titles and why others were not drawn. Returns 0.
int WriteFigures(const SuiteFigureFlags& flags);

// The left images of a run.
class RunImages {
 public:
  // `folder`: of the sequence; empty: where the run found it. Throws Error if the folder no longer
  // exists, lacks frames of the run or has images of another size.
  RunImages(const reports::OverlayRun& run, const std::string& folder);

  // Returns the grey image of a frame, as numbered in the sequence's folder. Empty if the image
  // cannot be decoded.
  cv::Mat Left(int frame) const;
  const Sequence& sequence() const { return sequence_; }

 private:
  Sequence sequence_;
};

// Opens the sequence of a run, in `folder` or, if that is empty, where the run found it, with the
// detections that the run was given. Empty if they are no longer where the run read them.
std::optional<Sequence> FindDetections(const std::string& folder, const reports::OverlayRun& run);

// Returns the detections of these classes, by frame. Boxes of another camera stay where they were
// detected, since the depth by which the run moved them is not known.
std::vector<std::vector<Detection>> DetectionsOf(const Sequence& sequence,
                                                 const std::vector<std::string>& classes);

// Adds the detections that FindDetections finds to the run. Returns false if it finds none.
bool AddDetections(const std::string& folder, reports::OverlayRun& run);

// Adds the boxes of the true bodies of its sequence to the run. Throws Error if there are none.
void AddTruthBoxes(const Sequence& sequence, reports::OverlayRun& run);

// A trajectory file, or the camera trajectory of a run.
struct PlotInput {
  std::string path;
  std::string name;                         // stem of the file's name, or variant of the run
  std::string sequence;                     // runs only
  Trajectory poses;                         // row i of a KITTI file is at time i s
  bool timed = true;                        // false for a KITTI file
  bool has_rotations = true;                // TrajectoryFile::has_rotations
  Trajectory truth;                         // runs only, in the world of the run; may be empty
  std::vector<reports::BodyDetail> bodies;  // runs only
};

// Reads a trajectory. A folder is a run; a file is in KITTI's format or one that ReadTrajectory
// reads. Adds to `notes`, in lines for stderr, how many rows of NaN are left out, and that a file
// has no rotations. Throws Error naming the file, the line and what was expected.
PlotInput ReadPlotInput(const std::string& path, std::string& notes);

// Makes the names unique and the times comparable: if one of the inputs is a KITTI file, all poses
// are matched by their position in the file, and Error is thrown if the numbers of poses differ.
void MakeComparable(std::vector<PlotInput>& inputs);

// The trajectory that others are aligned with and compared to.
struct PlotReference {
  std::string name;
  Trajectory poses;
  bool is_truth = true;  // false: it is the first trajectory
  bool of_run = false;   // it is the truth of a run, in the world of that run
  bool has_rotations = true;
};

// Returns the truth of the first run that has one, otherwise the first of several trajectories,
// otherwise nothing.
std::optional<PlotReference> ReferenceAmong(const std::vector<PlotInput>& inputs);

struct PlotMatching {
  TrajectoryAlignment alignment = TrajectoryAlignment::kSe3;
  bool z_up = false;  // of the world; otherwise y points down
  std::int64_t tolerance_ns = 0;
  std::int64_t offset_ns = 0;  // added to the times of trajectories, not to the reference's
};

// A trajectory as it is drawn and, if it was compared to a reference, its errors.
struct PlotTrack {
  std::string name;
  Trajectory poses = {};             // aligned with the reference
  TimeAssociation matches = {};      // with the reference; none: not compared
  std::vector<double> times_s = {};  // of the matched poses
  std::vector<double> errors_m = {};
  std::vector<double> errors_deg = {};  // none unless both have rotations
  double scale = 1.0;
};

// Aligns a trajectory with the reference and computes its errors. Throws Error if fewer than two
// poses match, or if an alignment needs rotations that are not known.
PlotTrack MatchTrack(const PlotReference& reference, const PlotInput& input,
                     const PlotMatching& matching);

// The trajectories to plot and how they compare.
struct PlotContent {
  std::vector<PlotInput> inputs;
  std::optional<PlotReference> reference;
  PlotMatching matching;
  std::vector<PlotTrack> tracks;  // one per input
  std::string notes;              // of ReadPlotInput
};

// Draws the trajectories from above and over time, with their errors.
reports::Figure TrajectoryFigure(const PlotContent& content);

// "svg" or "pdf", by the end of the name that a flag gives. Throws UsageError for another.
std::string FormatOfFigure(const std::string& flag, const std::string& output);

// Prints a row of errors per compared trajectory.
void PrintTracks(const std::vector<PlotTrack>& tracks);

double Seconds(std::int64_t time_ns);

}  // namespace cvo
