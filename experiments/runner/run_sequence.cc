// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/run_sequence.h"

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/stage_times.h"
#include "core/base/task_pool.h"
#include "core/odometry/odometry.h"
#include "experiments/runner/content_hash.h"
#include "experiments/runner/look_ahead.h"

namespace cvo {
namespace {

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void RefuseProblems(const Sequence& sequence, const PreparedFrame& prepared) {
  if (prepared.problems.empty()) return;
  const ImageProblem& problem = prepared.problems.front();
  throw Error(StrCat((sequence.folder / problem.image).string(), ": ", problem.reason));
}

// Lets the estimator work on one frame. Its Error ends the run, but is a result.
void Estimate(const PreparedFrame& prepared, Odometry& odometry, FrameRecord& record,
              RunResult& result) {
  try {
    const ScopedStage stage(record.times_s, "estimate");
    record.report = prepared.problems.empty() ? odometry.Process(prepared.frame, record.times_s)
                                              : odometry.Skip(prepared.frame.timestamp_ns);
  } catch (const Error& error) {
    result.status = RunStatus::kFailed;
    result.message = StrCat("frame ", record.frame, ": ", error.what());
  }
}

// The poses as they stand at the end; those of a failed run stay what they were.
void Refine(const Odometry& odometry, RunResult& result) {
  if (result.status == RunStatus::kFailed) return;
  const std::vector<RigidTransform> trajectory = odometry.Trajectory();
  Require(trajectory.size() == result.frames.size(), "Odometry::Trajectory: one pose per frame");
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    result.frames[i].refined_world_from_camera = trajectory[i];
  }
}

void JudgeStatus(RunResult& result) {
  if (result.status == RunStatus::kFailed) return;
  int lost = 0;
  int first_lost = 0;
  for (const FrameRecord& frame : result.frames) {
    if (frame.report.status != FrameStatus::kLost) continue;
    if (lost++ == 0) first_lost = frame.frame;
  }
  if (lost == 0) return;
  result.status = RunStatus::kLost;
  result.message =
      StrCat(lost, " of ", result.frames.size(), " frames lost, the first is frame ", first_lost);
}

// The identity of the input does not depend on how far the run came.
void HashRest(const Sequence& sequence, std::vector<ImageHashes>& hashes) {
  for (std::size_t i = hashes.size(); i < sequence.images.size(); ++i) {
    hashes.push_back({HashFile(sequence.images[i].left), HashFile(sequence.images[i].right)});
  }
}

}  // namespace

std::optional<RunResult> RunSequence(const RunRequest& request) {
  const Sequence& sequence = request.sequence;
  const auto run_start = std::chrono::steady_clock::now();
  TaskPool pool(request.threads);
  const std::unique_ptr<Odometry> odometry =
      request.variant.make({sequence.camera, request.options, request.seed}, pool);
  LookAhead look_ahead(sequence, request.options, pool);

  RunResult result;
  std::vector<ImageHashes> hashes;
  for (std::size_t i = 0; i < sequence.images.size(); ++i) {
    const auto frame_start = std::chrono::steady_clock::now();
    PreparedFrame prepared = look_ahead.Next();
    const double waited_s = SecondsSince(frame_start);
    if (request.strict) RefuseProblems(sequence, prepared);
    hashes.push_back(prepared.hashes);

    FrameRecord record;
    record.frame = sequence.first_frame + static_cast<int>(i);
    record.timestamp_ns = prepared.frame.timestamp_ns;
    record.times_s = prepared.times_s;
    record.times_s["wait_for_features"] = waited_s;
    Estimate(prepared, *odometry, record, result);
    if (result.status == RunStatus::kFailed) break;
    record.refined_world_from_camera = record.report.world_from_camera;
    record.problems = std::move(prepared.problems);
    record.times_s["frame"] = SecondsSince(frame_start);
    result.frames.push_back(std::move(record));
    request.progress(i + 1);
    if (request.stop()) return std::nullopt;
  }
  result.wall_s = SecondsSince(run_start);
  Refine(*odometry, result);
  JudgeStatus(result);
  HashRest(sequence, hashes);
  result.content = ContentHash(sequence, hashes);
  return result;
}

}  // namespace cvo
