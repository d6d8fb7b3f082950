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

// Which label of a landmark is drawn.
enum class LandmarkLabel {
  kCluster,   // what it belongs to after the frame
  kInferred,  // what the unary and pairwise terms made of it in the frame alone
};

// A run's folder, as far as it can be drawn.
struct OverlayRun {
  std::string variant;
  std::uint64_t seed = 0;
  RunSequence sequence;              // its detections are of all classes
  std::vector<std::string> classes;  // of detections that the run made use of
  RunDetail detail;
  bool has_clusters = false;
  bool has_landmarks = false;
  bool has_truth = false;                             // of landmarks and of what moves
  std::map<int, std::vector<LandmarkDot>> landmarks;  // by frame
  std::map<std::int64_t, std::int64_t> color_ids;     // as OverlayFrame has them
  // By frame. Of the run's folder: those that a cluster was associated with.
  std::map<int, std::vector<PixelBox>> detections;
  std::vector<std::string> missing;  // what is drawn without, one line each
};

// Throws Error where the folder holds no run, or one of another schema. An objects.csv or
// landmarks.csv that is not there, or damaged or cut off (with file and line), is listed.
OverlayRun ReadOverlayRun(const std::filesystem::path& folder, LandmarkLabel label);

// landmarks.csv. Throws Error.
std::map<int, std::vector<LandmarkDot>> ReadLandmarks(const std::filesystem::path& file,
                                                      LandmarkLabel label);

// 2D boxes of tracks.kitti in rows of objects.csv that have a detection. Throws Error.
std::map<int, std::vector<PixelBox>> ReadAssociatedBoxes(const std::filesystem::path& folder);

// Marks the labels that are wrong: on a cluster, though not of the body that most of its landmarks
// are on; static, though of a body that moves. An outlier is never wrong. Needs truth.json.
void MarkWrongLabels(OverlayRun& run);

// The id whose colour a cluster takes, where its own is that of another that is there in the same
// frames, by id: the first colour that it shares fewest frames with.
std::map<std::int64_t, std::int64_t> ApartColors(const std::vector<ClusterRow>& rows);

// Gives the clusters of all runs the colours of the last run's: each that of the cluster with which
// it shares most landmarks, over all frames, unless one that shares more with it is there at the
// same time: within a run colours stay apart. Runs of one sequence have the same pixels.
void AgreeOnColors(std::vector<OverlayRun>& runs);

// The corner that bodies are in least, over all frames: the same in all pictures of the run.
Corner EmptiestCorner(const OverlayRun& run);

// Leaves of inset and legend what some of the runs have anything for.
void LimitTo(const std::vector<OverlayRun>& runs, OverlayStyle& style);

// What is drawn on a frame of the run. Throws Error naming the frames that there are.
OverlayFrame FrameOf(const OverlayRun& run, int frame);

}  // namespace cvo::reports
