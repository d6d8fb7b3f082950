// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"

// What a stereo sequence can look like. All ways in ask here: folders, own images, imports,
// detections and labels.
namespace cvo {

// What one stereo pair reveals about its calibration: corners matched by their appearance alone, at
// any position in the images, so that a wrong rectification and swapped sides become visible.
struct PairCheck {
  int frame = 0;  // as numbered in the sequence's folder
  std::size_t matches = 0;
  double row_error_px = 0.0;  // median of |v_left - v_right|
  double disparity_px = 0.0;  // median of u_left - u_right
  std::string problem;        // why this is not a stereo pair; empty if it is one
};

// Checks the middle frame of the sequence. Empty if it cannot be decoded or has too few matches.
std::optional<PairCheck> CheckMiddlePair(const Sequence& sequence);

// The time from each frame to the next.
std::vector<double> TimeSteps(const Sequence& sequence);

// The largest of the two values before `i` and the two after; infinite near the ends.
double LargestAround(const std::vector<double>& values, std::size_t i);

// Throws Error for what cannot be: more than 1000 frames per second, boxes in parts of the image.
void RefuseImpossible(const Sequence& sequence);

// Describes what is well-formed but unlikely, one line per finding, with the number that makes it
// so, after the notes on reading: of the baseline, the times, the ground truth, the boxes and
// labels, of images that repeat the ones before (`repeated` frames), and of FindInImages (not for
// rendered scenes, whose files are known). Empty if nothing is. Does not depend on the number of
// threads.
std::vector<std::string> FindImplausible(const Sequence& sequence, std::size_t repeated = 0,
                                         int threads = 1);

// What the images of a frame show: pixels of the left one with their disparities (third, px).
// Corners of it are elsewhere in the left image of a later frame.
struct SeenFrame {
  int frame = 0;
  std::vector<Eigen::Vector3d> points;
  int later = 0;
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> moves;  // from, to
};

// Adds what tells that boxes are elsewhere than the bodies in the images.
void FindMisplaced(const Sequence& sequence, const std::vector<SeenFrame>& frames, const char* what,
                   const std::vector<ObjectBox>& boxes, std::vector<std::string>& lines);

// Adds what tells that images are not in the order of time, or are of two sequences: of the first
// frames, those from the middle on, and the last ones.
void FindDisorder(const Sequence& sequence, std::vector<std::string>& lines);

// Adds what the images of a few frames contradict: each other, the calibration, the ground truth or
// the boxes.
void FindInImages(const Sequence& sequence, double step_s, int threads,
                  std::vector<std::string>& lines);

}  // namespace cvo
