// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The flags that select a sequence.
#include <algorithm>
#include <iostream>
#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/run.h"
#include "experiments/datasets/import/import_stereo.h"
#include "experiments/datasets/sequence.h"
#include "experiments/datasets/sequence_parts.h"
#include "synth/family/family.h"
#include "synth/scene/description.h"
#include "synth/write/render_cache.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Throws UsageError if the folder does not exist, with the command that renders it if it has the
// name of a scene, or with the nearest of such names and of its neighbours.
void CheckSequenceFolder(const fs::path& folder) {
  if (fs::exists(folder) || fs::exists(folder.parent_path() / "image_02")) return;
  const std::string name = folder.filename().string();
  std::vector<std::string> scenes;
  for (const synth::ShippedScene& scene : synth::ShippedScenes()) scenes.emplace_back(scene.name);
  const bool is_scene =
      synth::IsFamilyScene(name) || std::find(scenes.begin(), scenes.end(), name) != scenes.end();
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(fs::absolute(folder).parent_path(), none)) {
    if (entry.is_directory()) AddOnce(entry.path().filename().string(), scenes);
  }
  throw UsageError(StrCat(
      folder.string(), ": found no such folder", is_scene ? "" : DidYouMean(name, scenes),
      ", expected the folder of a sequence",
      is_scene
          ? StrCat(": `clustervo synth render ", name, " -o ", folder.string(), "` makes this one")
          : ""));
}

// Throws Error unless `detections` is empty, a file, a detector level of the sequence's scene,
// "labels" (see AreFromLabels) or "none".
void CheckDetections(const fs::path& given, const fs::path& folder) {
  const std::string detections = given.string();
  if (detections.empty() || AreFromLabels(detections) || fs::exists(detections)) return;
  std::vector<std::string> names = DetectorLevels(folder);
  names.insert(names.end(), {"labels", "none"});
  if (std::find(names.begin(), names.end(), detections) != names.end()) return;
  ThrowError("--detections", Quoted(detections) + DidYouMean(detections, names),
             "a file, or for this sequence one of " + Joined(names, ", "));
}

Json ReadLayoutSettings(const std::string& text) {
  if (text.empty()) return Json::object();
  const Json json = text.starts_with("{") ? ParseJson(text, "option --layout") : ReadJson(text);
  if (!json.is_object()) ThrowError("option --layout", json.dump(), "a JSON object");
  return json;
}

}  // namespace

void SequenceFlags::AddLayoutTo(CLI::App& app) {
  const FlagAdder add{app};
  add("--type", type, "NAME",
      "layout of the folder: " + Joined(SequenceLayouts(), ", ", &SequenceLayout::type) +
          "; default: detected from its contents");
  add("--layout", layout_flag, "JSON|FILE",
      "settings of the layout, such as the names of bodies (experiments/README.md): a "
      "JSON object, or a file containing one");
}

void SequenceFlags::AddTruthTo(CLI::App& app) {
  const FlagAdder add{app};
  AddLayoutTo(app);
  add("--pair", pair, "NAME",
      "images to read, grey or colour; default: grey if present, otherwise colour");
  add("--frames", frames, "A:B", "frames A to B-1, counted from 0; default: all");
  add("--labels", labels_file, "FILE", "KITTI label file to use instead of the folder's own");
  add("--labels-camera", labels_camera, "X",
      "camera (image_0X) in which the labels were drawn; default: 2, for KITTI odometry the left "
      "camera in use");
}

void SequenceFlags::AddTo(CLI::App& app) {
  const FlagAdder add{app};
  add("SEQUENCE", folder, "",
      "sequence folder of KITTI or another supported data set (see experiments/README.md), or "
      "<training>/<number> for KITTI tracking; alternatively give --left, --right and --calib");
  AddTruthTo(app);
  add("--detections", detections_file, "FILE|labels|none",
      "source of 2D boxes: a file in KITTI format (track ids are ignored), a detector level of a "
      "synthetic scene (oracle, good, poor), the 2D boxes of the labels (labels:0-5: of the tracks "
      "with these ids), or none; default of run: good for such a scene, otherwise none");
  add("--detections-camera", detections_camera, "X",
      "camera (image_0X) in which the boxes were detected; default: the left camera in use");
  add("--right-shift", right_shift_px, "PX",
      "known rectification error: pixels by which u_right is too large; the estimate of this error "
      "starts from it; default: 0")
      ->check(Within(-100.0, 100.0));
  AddStereo(app, stereo);
  add("--min-score", min_score, "SCORE", "minimum score of a detection; default: none")
      ->check(Within(-1e6, 1e6));
}

std::vector<std::string> DetectorLevels(const fs::path& folder) {
  std::vector<std::string> levels;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder / "detections", none)) {
    if (entry.path().extension() == ".txt") levels.push_back(entry.path().stem().string());
  }
  std::sort(levels.begin(), levels.end());
  return levels;
}

SequenceRequest WithBoxes(SequenceRequest request) {
  const std::vector<std::string> levels = DetectorLevels(request.folder);
  const bool has = std::find(levels.begin(), levels.end(), "good") != levels.end();
  if (has && request.detections_file.empty()) request.detections_file = "good";
  return request;
}

void CheckStereo(const StereoImport& stereo) {
  if (stereo.left.empty()) throw UsageError("--left is missing");
  if (stereo.right.empty()) throw UsageError("--right is missing");
  if (stereo.calibration.empty()) throw UsageError("--calib is missing");
}

std::vector<std::filesystem::path> InputsOf(const StereoImport& stereo) {
  std::vector<std::filesystem::path> inputs = {stereo.left, stereo.right, stereo.times};
  inputs.insert(inputs.end(), stereo.calibration.begin(), stereo.calibration.end());
  return inputs;
}

void AddStereo(CLI::App& app, StereoImport& stereo) {
  const auto add = [&app](const char* flag, auto& value, const char* kind, const char* meaning) {
    return app.add_option(flag, value, meaning)->type_name(kind)->group("Your own stereo images");
  };
  add("--left", stereo.left, "FOLDER", "images of the left camera");
  add("--right", stereo.right, "FOLDER",
      "images of the right camera, paired by the times or the numbers in their names");
  add("--calib", stereo.calibration, "FILE [FILE]",
      "calibration: YAML or JSON as in experiments/README.md, or as OpenCV, Kalibr, OpenVINS, ROS, "
      "ORB-SLAM or KITTI write it, in one or two files; unrectified images are rectified")
      ->expected(1, 2);
  add("--times", stereo.times, "FILE",
      "file with one timestamp per line, in s, ms, us or ns; default: the file names if they are "
      "times, otherwise --rate");
  add("--rate", stereo.rate_hz, "HZ",
      "frame rate, used if neither --times nor the file names give timestamps; default: 10")
      ->check(Within(1e-3, 1e6));
}

SequenceRequest SequenceFlags::Request(bool quiet) const {
  SequenceRequest request = *this;
  if (stereo.left.empty() && stereo.right.empty()) {
    if (folder.empty()) {
      throw UsageError(kSequenceMissing);
    }
    CheckSequenceFolder(folder);
  } else {
    if (!folder.empty()) {
      throw UsageError("give either a sequence folder or --left and --right, not both");
    }
    CheckStereo(stereo);
    request.folder = ImportIntoCache(stereo, synth::CacheFolder(), Progress(quiet).Reporter());
  }
  CheckDetections(detections_file, request.folder);
  request.layout = ReadLayoutSettings(layout_flag);
  if (!frames.empty()) {
    const FrameRange range = ParseFrameRange(frames);
    request.begin_frame = range.begin;
    request.end_frame = range.end;
  }
  if (detections_file == "none") request.detections_file.clear();
  return request;
}

}  // namespace cvo
