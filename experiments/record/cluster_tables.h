// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "experiments/datasets/sequence.h"
#include "experiments/record/run_record.h"

namespace cvo {

// objects.csv: a header, then a row for each live cluster in each frame. Poses and velocities are
// in the world of the first left camera, as when the frame came and, with refined_, as last
// estimated (cells empty where the run kept none). center_ and half_: inner extent, which the
// estimator uses; box_ to width_m: the body's upright box, x forward, in the body's frame
// (METHOD.md 10.4). The 2D box is the last estimate's 3D box in the
// left image read, empty out of view; detection: index among the frame's, empty: none.
std::string ObjectTable(const Sequence& sequence, const RunResult& run);

// Clusters in view as rows of KITTI tracking with a score. 2D box: of the associated detection,
// else of the projected 3D box, in the left image read. 3D box: that of objects.csv, in rectified
// camera 0, as last estimated. Predicted ones are among them: see objects.csv.
std::vector<ObjectBox> TrackBoxes(const Sequence& sequence, const RunResult& run);

// tracks.kitti: these rows.
std::string KittiTracks(const Sequence& sequence, const RunResult& run);

// clusters/<id>.tum: where the cluster was tracked, world_from_object as last estimated.
std::string ClusterTum(const ClusterTrajectory& cluster);

}  // namespace cvo
