// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "core/files/text_sink.h"
#include "experiments/datasets/sequence.h"
#include "experiments/log/run_record.h"

namespace cvo {

// objects.csv: a header, then a row for each live cluster in each frame. Poses and velocities are
// in the world of the first left camera, as when the frame came and, with refined_, as last
// estimated (cells empty where the run kept none). center_ and half_: inner extent, which the
// estimator uses; box_ to width_m: the body's upright box, x forward, in the body's frame
// (METHOD.md 10.4). The 2D box is the last estimate's 3D box in the
// left image read, empty out of view; detection: index among the frame's, empty: none.
void WriteObjectTable(const Sequence& sequence, const RunResult& run, const TextSink& sink);

// Clusters in view as rows of KITTI tracking with a score. 2D box: of the associated detection,
// else of the projected 3D box, in the left image read. 3D box: that of objects.csv, in rectified
// camera 0, as last estimated. Predicted ones are among them: see objects.csv.
void ForEachTrackBox(const Sequence& sequence, const RunResult& run,
                     const std::function<void(const ObjectBox&)>& take);

// tracks.kitti: these rows.
void WriteKittiTracks(const Sequence& sequence, const RunResult& run, const TextSink& sink);

// The text of each cluster's clusters/<id>.tum, by id: where it was tracked, world_from_object as
// last estimated.
void ForEachClusterTum(const PoseLog& clusters,
                       const std::function<void(ClusterId, const std::string& text)>& take);

}  // namespace cvo
