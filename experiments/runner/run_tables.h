// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/files/text_file.h"
#include "core/interface/frame.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_matching.h"
#include "experiments/runner/run_result.h"

namespace cvo {

// Writes objects.csv: a header, then a row for each live cluster in each frame.
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

// Rows of landmarks.csv for the landmarks observed in one frame, in the order of their features, as
// estimated when the frame was processed; pixels rounded to 0.01, metres and nats to 0.001.
// `feature_truth`: one per feature, or empty.
std::string LandmarkRows(int frame, const StereoFrame& given,
                         const std::vector<LandmarkReport>& landmarks,
                         const std::vector<LandmarkTruth>& feature_truth);

}  // namespace cvo
