// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "core/record/run_summary.h"
#include "experiments/datasets/sequence.h"
#include "experiments/metrics/objects/object_matching.h"
#include "experiments/metrics/objects/object_scores.h"
#include "experiments/metrics/pose_errors.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_result.h"

namespace cvo {

// The ground truth that a run was compared to; nullptr: there is none.
struct TruthRecord {
  const OptionalPoses* camera = nullptr;  // by processed frame
  const ObjectTruth* objects = nullptr;
  RigidTransform truth_from_estimate;  // between the worlds
  const std::vector<BodyScore>* bodies = nullptr;
};

// Returns the content of truth.json, for drawing: the ground truth in the world of the run, which
// is the first left camera as estimated, and for each body the positions from which its ATE is
// computed. Frames count from the first one processed; poses are as in result.json.
std::string TruthFile(const std::string& job, const TruthRecord& truth);

// A run with everything that determined it.
struct RunRecord {
  const Sequence& sequence;
  BuildIdentity build;
  std::string variant;
  Json options = {};  // resolved
  Json given = {};    // from GivenToJson
  std::uint64_t seed = 0;
  std::vector<Metric> metrics = {};
  std::optional<reports::RunBodies> bodies = {};  // empty without ground truth
  const RunResult& run;
  TruthRecord truth = {};
  std::vector<std::string> warnings = {};  // FindImplausible
};

// Returns [tx, ty, tz, qx, qy, qz, qw].
Json PoseToJson(const RigidTransform& pose);

// Describes the sequence that was read, with its hash and the warnings of FindImplausible.
reports::RunSequence SequenceOf(const Sequence& sequence, const std::string& content,
                                const std::vector<std::string>& warnings);

reports::CameraInfo CameraOf(const StereoCamera& camera);

// Content of a result.json: the summary, followed by details that only some readers need.
Json ResultJson(const reports::RunSummary& summary, const Json& details);

// Calibration of the last frame that has an estimate of it. Empty if there is none.
std::optional<CalibrationReport> LastCalibration(const RunResult& run);

std::string RecordedJob(const RunRecord& record);

// Writes result.json. The same job gives the same bytes, whatever the time, host, paths and number
// of threads. Throws Error naming a field that is not finite.
void WriteResultFile(const RunRecord& record, const TextSink& sink);

}  // namespace cvo
