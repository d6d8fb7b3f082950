// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/drawing/overlay_frame.h"

namespace cvo::reports {

// Which of the two labels of a landmark is drawn.
enum class LandmarkLabel {
  kCluster,   // its cluster after the frame was processed
  kInferred,  // inferred by the unary and pairwise terms from this frame alone
};

// What can be drawn of a run, read from its folder.
struct OverlayRun {
  std::string variant;
  std::uint64_t seed = 0;
  RunSequence sequence;              // its detection count includes all classes
  std::vector<std::string> classes;  // detection classes that the run used
  RunDetail detail;
  bool has_clusters = false;
  bool has_landmarks = false;
  bool has_truth = false;                             // the true bodies of landmarks are known
  std::map<int, std::vector<LandmarkDot>> landmarks;  // by frame
  std::map<std::int64_t, std::int64_t> color_ids;     // see OverlayFrame::color_ids
  // By frame. ReadOverlayRun fills in only those that were associated with a cluster.
  std::map<int, std::vector<PixelBox>> detections;
  std::vector<std::string> missing;  // what the drawing lacks, one line each
};

// Reads the folder of a run. Throws Error if it holds no run, or one of another schema version. If
// objects.csv, landmarks.csv or tracks.kitti is missing, damaged or truncated, the run is drawn
// without it and OverlayRun::missing names the file, and the line of the damage.
OverlayRun ReadOverlayRun(const std::filesystem::path& folder, LandmarkLabel label);

// Reads landmarks.csv, by frame. Throws Error if it cannot be parsed.
std::map<int, std::vector<LandmarkDot>> ReadLandmarks(const std::filesystem::path& file,
                                                      LandmarkLabel label);

// Reads the 2D boxes of tracks.kitti, by frame, whose row in objects.csv has an associated
// detection. Throws Error if one of the files cannot be parsed.
std::map<int, std::vector<PixelBox>> ReadAssociatedBoxes(const std::filesystem::path& folder);

// Marks the landmarks with a wrong label: on a cluster, but not on the body that holds most of its
// landmarks; or static, but on a moving body. Outliers are never wrong. Needs truth.json.
void MarkWrongLabels(OverlayRun& run);

// Resolves colour clashes: if another cluster in the same frames already has the colour of a
// cluster, maps its id to the id whose colour it takes instead. That colour is the first, counting
// from the cluster's own, that is in use in the fewest of the cluster's frames.
std::map<std::int64_t, std::int64_t> ApartColors(const std::vector<ClusterRow>& rows);

// Gives the clusters of all runs the colours of the last run: each cluster takes the colour of the
// cluster of the last run with which it shares most landmarks over all frames, unless a cluster of
// its own run that shares more has that colour in the same frames, so that colours stay distinct
// within a run. Landmarks are matched by their pixel, which is the same in all runs of one
// sequence.
void AgreeOnColors(std::vector<OverlayRun>& runs);

// The corner of the image with the fewest bodies over all frames. It is the same in all pictures of
// the run.
Corner EmptiestCorner(const OverlayRun& run);

// Removes from the inset and the legend whatever none of the runs has data for.
void LimitTo(const std::vector<OverlayRun>& runs, OverlayStyle& style);

// Assembles what is drawn on a frame of the run. Throws Error, naming the first and last frame of
// the run, if it has no such frame.
OverlayFrame FrameOf(const OverlayRun& run, int frame);

}  // namespace cvo::reports
