// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/text_file.h"
#include "core/interface/frame.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_matching.h"
#include "experiments/runner/run_result.h"

namespace cvo {

// Writes objects.csv: a header, then a row for each live cluster in each frame. Poses and
// velocities are in the world of the first left camera, as estimated when the frame was processed
// and, with the prefix refined_, as last estimated (cells are empty if the run has no such
// estimate). center_ and half_ are the inner extent, which the estimator uses; box_ to width_m are
// the cluster's upright box, x forward, in the frame of the object (METHOD.md 10.4). The 2D box is
// the projection of the last estimated 3D box into the left image read, empty out of view.
// detection is the index among the frame's detections, empty if there is none.
void WriteObjectTable(const Sequence& sequence, const RunResult& run, const TextSink& sink);

// Calls `take` with the clusters in view, as rows of KITTI tracking with a score. The 2D box is
// that of the associated detection, otherwise the projected 3D box, in the left image read. The 3D
// box is that of objects.csv, in rectified camera 0, as last estimated. Clusters with a predicted
// pose are included; objects.csv states which ones they are.
void ForEachTrackBox(const Sequence& sequence, const RunResult& run,
                     const std::function<void(const ObjectBox&)>& take);

// Writes these rows as tracks.kitti.
void WriteKittiTracks(const Sequence& sequence, const RunResult& run, const TextSink& sink);

// Text of clusters/<id>.tum: world_from_object as last estimated, in the frames in which the
// cluster was tracked.
std::string ClusterTum(const ClusterTrajectory& cluster);

// landmarks.csv: the landmarks observed in each frame, in the order of their features. Pixels are
// in the left image read, points in the world of the first left camera, as estimated when the frame
// was processed. Labels: 0 is the static scene, empty is none (an outlier). truth_body: 0 is the
// static scene, empty is unknown. Pixels are rounded to 0.01, metres and nats to 0.001.
extern const std::string_view kLandmarksHeader;

// Rows of one frame. `feature_truth`: one per feature, or empty.
std::string LandmarkRows(int frame, const StereoFrame& given,
                         const std::vector<LandmarkReport>& landmarks,
                         const std::vector<LandmarkTruth>& feature_truth);

}  // namespace cvo
