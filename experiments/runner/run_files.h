// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/resource.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/atomic_file.h"
#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "core/interface/frame.h"
#include "core/record/run_summary.h"
#include "core/record/truth.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_matching.h"
#include "experiments/runner/run_result.h"

namespace cvo {

// Returns date, host, CPU, peak memory and number of CPUs of the running process, the head of its
// timing.json.
reports::TimingData ThisProcess();

// Seconds of all processors that this process has taken, or with RUSAGE_CHILDREN the programs that
// it has waited for.
double CpuSeconds(int whose = RUSAGE_SELF);

// Content of timing.json: run.timing with wall time per frame by stage in ms, and frames per
// second.
std::string TimingFile(const RunResult& run);

// Returns the names of what a run may write to its folder: result.json, timing.json, truth.json,
// camera.tum, camera.kitti, objects.csv, tracks.kitti, clusters/ with <id>.tum and, on request,
// landmarks.csv.
std::vector<std::string> RunFileNames();

// Starts landmarks.csv in the folder with its header. Rows are appended during the run, since all
// of them take many times the memory of a run.
StagedFile BeginLandmarks(const std::filesystem::path& folder);

// Writes these files to an existing folder: either all of them complete, or none (see StagedFiles).
// Removes files of an earlier run that this one does not have. `objects`: see TruthFile.
void WriteRunFiles(const std::filesystem::path& folder, const RunResult& run,
                   const ObjectTruth* objects, std::optional<StagedFile> landmarks = {});

// Returns the content of truth.json, for drawing: the ground truth in the world of the run, which
// is the first left camera as estimated, and for each body the positions from which its ATE is
// computed. Frames count from the first one processed; poses are as in result.json. `objects`: null
// if there is no ground truth of bodies.
std::string TruthFile(const RunResult& run, const ObjectTruth* objects);

reports::Pose PoseOf(const RigidTransform& pose);

// Describes the sequence that was read, with its hash and the warnings of FindImplausible.
reports::RunSequence SequenceOf(const Sequence& sequence, const std::string& content,
                                const std::vector<std::string>& warnings);

reports::CameraInfo CameraOf(const StereoCamera& camera);

// Content of a result.json: the summary, followed by details that only some readers need.
Json ResultJson(reports::RunSummary summary, const Json& details);

// Calibration of the last frame that has an estimate of it. Empty if there is none.
std::optional<CalibrationReport> LastCalibration(const RunResult& run);

// Content of result.json. The same job gives the same bytes, whatever the time, host, paths and
// number of threads. Throws Error naming a field that is not finite.
std::string ResultFile(const RunResult& run);

// Writes objects.csv: a header, then a row for each live cluster in each frame.
void WriteObjectTable(const RunResult& run, const TextSink& sink);

// Calls `take` with the clusters in view, as rows of KITTI tracking with a score. The 2D box is
// that of the associated detection, otherwise the projected 3D box, in the left image read. The 3D
// box is that of objects.csv, in rectified camera 0, as last estimated. Clusters whose pose is
// only predicted are left out, as trackers report what they see; objects.csv has them.
void ForEachTrackBox(const RunResult& run, const std::function<void(const ObjectBox&)>& take);

// Writes these rows as tracks.kitti.
void WriteKittiTracks(const RunResult& run, const TextSink& sink);

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
