// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What pictures are drawn from: the images and detections of runs, and trajectories of files and
// runs.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "core/record/run_summary.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/sequence_parts.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/runner/given.h"
#include "experiments/runner/identity.h"
#include "experiments/suite/build_plan.h"
#include "experiments/suite/engine.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Renders the scene of a run of a suite, if it is not in the cache yet. Returns its folder.
fs::path RenderedScene(const reports::OverlayRun& run) {
  const fs::path file = run.folder.parent_path().parent_path() / "plan.json";
  const Plan plan = ParsePlan(ReadJson(file, {}), file.string());
  const PlanJob* job = FindBy(plan.jobs, &PlanJob::job, run.folder.filename().string());
  if (job == nullptr) ThrowError(file.string(), "not the job of " + run.folder.string(), "it");
  const Preparation scene = FindScene(synth::CacheFolder(), plan.suite.sequences.at(job->entry),
                                      job->parameters, job->seed);
  if (fs::exists(scene.output / synth::kManifestName)) return scene.output;
  PrintNotice(StrCat("rendering ", run.sequence.name, " again"));
  std::vector<std::string> command = {fs::read_symlink("/proc/self/exe").string()};
  command.insert(command.end(), scene.arguments.begin(), scene.arguments.end());
  const Captured made = Capture(command, [](const Captured&) { return false; });
  if (made.exit_code != 0) ThrowError("rendering " + run.sequence.name, made.err, "exit code 0");
  return scene.output;
}

// Where the images of a run are: in `folder`; if that is empty, where the run read them; if those
// are gone, such as on another machine, and were rendered, in the cache of this one.
fs::path ImagesOf(const reports::OverlayRun& run, const std::string& folder) {
  const fs::path read = run.detail.timing.paths.sequence;
  if (!folder.empty() || fs::exists(read)) return folder.empty() ? read : fs::path(folder);
  const fs::path scenes = synth::ScenesFolder(synth::CacheFolder());
  if (read.parent_path().parent_path().filename() != scenes.filename()) return read;
  const fs::path here = scenes / read.parent_path().filename() / read.filename();
  return fs::exists(here / synth::kManifestName) ? here : RenderedScene(run);
}

// `folder`: of ImagesOf.
SequenceRequest RequestOf(const reports::OverlayRun& run, const fs::path& folder) {
  SequenceRequest request;
  request.folder = folder.string();
  request.type = run.sequence.type;
  request.pair = run.sequence.pair;
  if (run.sequence.layout) request.layout = *run.sequence.layout;
  request.begin_frame = run.sequence.first_frame;
  request.end_frame = run.sequence.first_frame + run.sequence.frames;
  return request;
}

Sequence OpenImages(const reports::OverlayRun& run, const std::string& folder) {
  const fs::path read = run.detail.timing.paths.sequence;
  if (folder.empty() && read.empty()) {
    ThrowError("the images of " + run.sequence.name, "no folder in the run's timing.json",
               "a folder, or --sequence FOLDER");
  }
  try {
    const fs::path images = ImagesOf(run, folder);
    Sequence sequence = OpenSequence(RequestOf(run, images));
    const std::string& hash = run.sequence.images;
    if (folder.empty() && images != read && !hash.empty() &&
        ImagesHash(RenderedHashes(sequence)) != hash) {
      ThrowError(images.string(), "images that this program renders differently",
                 "those of the run");
    }
    return sequence;
  } catch (const Error& error) {
    if (!folder.empty()) throw;
    throw Error(StrCat("the images of ", run.sequence.name,
                       " are not in the folder that the run read them from: ", error.what(),
                       "; give their folder with --sequence FOLDER"));
  }
}

}  // namespace

RunImages::RunImages(const reports::OverlayRun& run, const std::string& folder)
    : sequence_(OpenImages(run, folder)) {
  const StereoCamera& camera = sequence_.camera;
  if (camera.width_px != run.sequence.camera.width_px ||
      camera.height_px != run.sequence.camera.height_px) {
    ThrowError(sequence_.folder.string(),
               StrCat("images of ", camera.width_px, "x", camera.height_px, " pixels"),
               StrCat(run.sequence.camera.width_px, "x", run.sequence.camera.height_px,
                      ", as the run of ", run.sequence.name, " had"));
  }
}

cv::Mat RunImages::Left(int frame) const {
  const auto index = static_cast<std::size_t>(frame - sequence_.first_frame);
  return LoadFrameImage(sequence_, index, 0).grey;
}

std::optional<Sequence> FindDetections(const std::string& folder, const reports::OverlayRun& run) {
  const reports::RunPaths& paths = run.detail.timing.paths;
  try {
    const fs::path images = ImagesOf(run, folder);
    // Files of the sequence have moved with it.
    const auto moved = [&](const std::string& file) {
      return file.starts_with(paths.sequence + "/")
                 ? images.string() + file.substr(paths.sequence.size())
                 : file;
    };
    SequenceRequest request = RequestOf(run, images);
    request.detections_file = moved(paths.detections.value_or(""));
    request.detections_camera = paths.detections_camera.value_or(-1);
    request.min_score = paths.min_score.value_or(BoxSources().min_score);
    request.labels_file = moved(paths.labels.value_or(""));
    Sequence sequence = OpenSequence(request);
    if (DetectionsHash(sequence) == run.sequence.detections_hash) return sequence;
  } catch (const Error&) {  // files have moved
  }
  return std::nullopt;
}

std::vector<std::vector<Detection>> DetectionsOf(const Sequence& sequence,
                                                 const std::vector<std::string>& classes) {
  std::vector<std::vector<Detection>> detections;
  for (const std::vector<ObjectBox>& boxes : DetectionsByFrame(sequence)) {
    DetectionCounts counts;
    detections.push_back(DetectionsOfFrame(boxes, {sequence.camera, 0.0}, {}, classes, counts));
  }
  return detections;
}

void AddTruthBoxes(const Sequence& sequence, reports::OverlayRun& run) {
  const std::unique_ptr<BodyTruthReader> truth = ReadBodyTruth(sequence);
  if (!truth) {
    ThrowError("--truth", "no ground truth of bodies in " + sequence.folder.string(),
               "a sequence that has it");
  }
  const TrueBoxes boxes = BoxesOfBodies(sequence, *truth);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const auto& [body, box] : boxes[i]) {
      run.truth[sequence.first_frame + static_cast<int>(i)].push_back(box);
    }
  }
}

bool AddDetections(const std::string& folder, reports::OverlayRun& run) {
  const std::optional<Sequence> sequence = FindDetections(folder, run);
  if (!sequence) return false;
  const auto frames = DetectionsOf(*sequence, run.classes);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const Detection& detection : frames[i]) {
      run.detections[sequence->first_frame + static_cast<int>(i)].push_back(detection.box);
    }
  }
  return true;
}

namespace {

constexpr std::int64_t kStep_ns = 1'000'000'000;  // between poses without timestamps

Trajectory ReadKittiTrajectory(const fs::path& path) {
  Trajectory trajectory;
  for (const RigidTransform& pose : ReadKittiPoses(path)) {
    trajectory.push_back({static_cast<std::int64_t>(trajectory.size()) * kStep_ns, pose});
  }
  return trajectory;
}

PlotInput ReadRunInput(const std::string& path) {
  const fs::path result = fs::path(path) / "result.json";
  if (!fs::exists(result)) {
    ThrowError(path, "a folder without result.json or plan.json",
               "the output folder of a run or of a suite, or a trajectory file");
  }
  const reports::RunSummary run = reports::ReadRun(result, {});
  reports::RunDetail detail = reports::ReadRunDetail(path);
  PlotInput input;
  input.path = path;
  input.name = run.variant;
  input.sequence = run.sequence.name;
  for (const reports::CameraFrame& frame : detail.camera) {
    if (frame.truth)
      input.truth.push_back({frame.timestamp_ns, reports::TransformOf(*frame.truth)});
    if (frame.status == "skipped") continue;
    input.poses.push_back({frame.timestamp_ns, reports::TransformOf(frame.world_from_camera)});
  }
  input.bodies = std::move(detail.bodies);
  return input;
}

}  // namespace

double Seconds(std::int64_t time_ns) { return 1e-9 * static_cast<double>(time_ns); }

PlotInput ReadPlotInput(const std::string& path, std::string& notes) {
  PlotInput input;
  if (fs::is_directory(path)) {
    input = ReadRunInput(path);
  } else {
    input.path = path;
    input.name = fs::path(path).stem().string();
    input.timed = !IsKittiPoseFile(path);
    if (input.timed) {
      TrajectoryFile file = ReadTrajectory(path);
      input.poses = std::move(file.poses);
      input.has_rotations = file.has_rotations;
      if (!file.left_out.empty()) {
        notes += StrCat("note: ", path, ": ", file.left_out.size(),
                        " rows of NaN or infinity left out\n");
      }
      if (!file.has_rotations) {
        notes +=
            StrCat("note: ", path, ": quaternions that are missing, all zero or all the same, so ",
                   "no errors of rotation\n");
      }
    } else {
      input.poses = ReadKittiTrajectory(path);
    }
  }
  if (input.poses.empty()) ThrowError(path, "no pose", "a trajectory");
  return input;
}

void MakeComparable(std::vector<PlotInput>& inputs) {
  std::vector<std::string> names;
  std::vector<std::string> paths;
  for (const PlotInput& input : inputs) {
    names.push_back(input.name);
    paths.push_back(input.path);
  }
  names = UniqueNames(names, paths);
  for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i].name = names[i];
  const auto counted = std::find_if(inputs.begin(), inputs.end(),
                                    [](const PlotInput& input) { return !input.timed; });
  if (counted == inputs.end()) return;
  for (PlotInput& input : inputs) {
    if (input.poses.size() != counted->poses.size()) {
      ThrowError(input.path, StrCat(input.poses.size(), " poses"),
                 StrCat(counted->poses.size(), ", as many as ", counted->path,
                        " (KITTI files have no times to match by)"));
    }
    if (input.timed && input.truth.size() != input.poses.size()) input.truth.clear();
    input.timed = false;
    for (std::size_t i = 0; i < input.poses.size(); ++i) {
      input.poses[i].timestamp_ns = static_cast<std::int64_t>(i) * kStep_ns;
      if (!input.truth.empty()) input.truth[i].timestamp_ns = input.poses[i].timestamp_ns;
    }
  }
}

std::optional<PlotReference> ReferenceAmong(const std::vector<PlotInput>& inputs) {
  for (const PlotInput& input : inputs) {
    if (input.truth.empty()) continue;
    return PlotReference{"truth of " + input.sequence, input.truth, true, true, true};
  }
  if (inputs.size() < 2) return std::nullopt;
  const PlotInput& first = inputs.front();
  return PlotReference{first.name, first.poses, false, false, first.has_rotations};
}

namespace {

std::string RangeText(const Trajectory& poses) {
  return StrCat(FormatSecondsNs(poses.front().timestamp_ns), " to ",
                FormatSecondsNs(poses.back().timestamp_ns), " s");
}

}  // namespace

PlotTrack MatchTrack(const PlotReference& reference, const PlotInput& input,
                     const PlotMatching& matching) {
  Trajectory shifted = input.poses;
  for (TimedPose& pose : shifted) pose.timestamp_ns += matching.offset_ns;
  PlotTrack track{.name = input.name,
                  .matches = AssociateByTime(reference.poses, shifted, matching.tolerance_ns)};
  if (track.matches.pairs.size() < 2) {
    ThrowError(input.path,
               StrCat(track.matches.pairs.size(), " poses that match one of ", reference.name,
                      ", at ", RangeText(shifted)),
               StrCat("2 or more within ", Seconds(matching.tolerance_ns), " s of ",
                      RangeText(reference.poses)));
  }
  const bool rotations = reference.has_rotations && input.has_rotations;
  if (!rotations && matching.alignment == TrajectoryAlignment::kOrigin) {
    ThrowError(input.path, "positions without rotations", "--align se3, sim3, yaw or none");
  }
  CommonPoses poses;
  for (const auto& [i, k] : track.matches.pairs) {
    poses.frames.push_back(static_cast<int>(i));
    poses.truth.push_back(reference.poses[i].world_from_camera);
    poses.estimate.push_back(shifted[k].world_from_camera);
    track.times_s.push_back(Seconds(shifted[k].timestamp_ns));
  }
  const Eigen::Vector3d up =
      matching.z_up ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(-Eigen::Vector3d::UnitY());
  const Similarity moved = AlignTrajectory(poses, matching.alignment, up);
  track.scale = moved.scale;
  for (const TimedPose& pose : shifted) {
    track.poses.push_back({pose.timestamp_ns, moved * pose.world_from_camera});
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    track.errors_m.push_back(
        (moved * poses.estimate[i].translation() - poses.truth[i].translation()).norm());
  }
  if (!rotations) return track;
  for (const double error_rad : OrientationErrors(poses, matching.alignment, moved)) {
    track.errors_deg.push_back(error_rad * 180.0 / std::numbers::pi);
  }
  return track;
}

void PrintTracks(const std::vector<PlotTrack>& tracks) {
  TextTable table({"trajectory", "poses", "matched", "rms m", "mean m", "median m", "max m",
                   "rms deg", "scale"});
  for (const PlotTrack& track : tracks) {
    if (track.errors_m.empty()) continue;
    const std::optional<double> deg = RootMeanSquare(track.errors_deg);
    table.Add({track.name, StrCat(track.poses.size()), StrCat(track.errors_m.size()),
               ReadableNumber(RootMeanSquare(track.errors_m).value()),
               ReadableNumber(MeanOf(track.errors_m)), ReadableNumber(Median(track.errors_m)),
               ReadableNumber(*std::max_element(track.errors_m.begin(), track.errors_m.end())),
               deg ? ReadableNumber(*deg) : "-", ReadableNumber(track.scale)});
  }
  if (table.Lines().size() > 1) table.Print(std::cout);
}

}  // namespace cvo
