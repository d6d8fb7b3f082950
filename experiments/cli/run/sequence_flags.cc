// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The flags that select a sequence, and clustervo import.
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
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

bool IsFamilySeed(const std::string& name) {
  const auto families = synth::ShippedFamilies();
  return std::any_of(families.begin(), families.end(), [&](const auto& family) {
    return name.starts_with(std::string(family.name) + "@");
  });
}

// Sorted names of the folders in a folder, or of its files without their extensions.
std::vector<std::string> NamesIn(const fs::path& folder, bool folders) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.is_directory() != folders) continue;
    const fs::path name = entry.path().filename();
    names.push_back((folders ? name : name.stem()).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

[[noreturn]] void FailUsage(const std::string& where, const std::string& found,
                            const std::string& expected) {
  throw UsageError(StrCat(where, ": found ", found, ", expected ", expected));
}

// Throws UsageError if the folder does not exist. The message gives the command that renders it if
// it has the name of a scene or of a seed of a family, otherwise similar names.
void CheckSequenceFolder(const fs::path& folder) {
  if (fs::exists(folder) || fs::exists(folder.parent_path() / "image_02")) return;
  const std::string name = folder.filename().string();
  std::vector<std::string> near = NamesIn(fs::absolute(folder).parent_path(), true);
  for (const synth::ShippedScene& scene : synth::ShippedScenes()) near.emplace_back(scene.name);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  if (std::binary_search(near.begin(), near.end(), name) || IsFamilySeed(name)) {
    FailUsage(folder.string(), "no such folder",
              StrCat("a sequence: `clustervo synth render ", name, " -o ", folder.string(),
                     "` makes this one"));
  }
  FailUsage(folder.string(), "no such folder" + DidYouMean(name, near), "the folder of a sequence");
}

// Throws Error unless `detections` is empty, a file, a detector level of the sequence's scene,
// "labels" (see AreFromLabels) or "none".
void CheckDetections(const fs::path& given, const fs::path& folder) {
  const std::string detections = given.string();
  std::vector<std::string> names = NamesIn(folder / "detections", false);
  const bool has_levels = !names.empty();
  names.insert(names.end(), {"labels", "none"});
  if (detections.empty() || AreFromLabels(detections) || fs::exists(detections)) return;
  if (std::find(names.begin(), names.end(), detections) != names.end()) return;
  const std::string levels =
      has_levels ? "" : " (this sequence has no detector levels such as good)";
  ThrowError("--detections", Quoted(detections) + DidYouMean(detections, names),
             "a file, or for this sequence one of " + Joined(names, ", ") + levels);
}

Json ReadLayoutSettings(const std::string& text) {
  if (text.empty()) return Json::object();
  const Json json = text.starts_with("{") ? ParseJson(text, "option --layout") : ReadJson(text);
  if (!json.is_object()) ThrowError("option --layout", json.dump(), "a JSON object");
  return json;
}

struct ImportFlags {
  StereoImport stereo;
  std::string output;
  bool quiet = false;
};

int Import(const ImportFlags& flags) {
  CheckStereo(flags.stereo);
  CheckApartFrom(InputsOf(flags.stereo), flags.output);
  CheckNewSequence(flags.output, {flags.stereo.left, flags.stereo.right});
  const ImportOutcome outcome =
      ImportStereo(flags.stereo, flags.output, Progress(flags.quiet).Reporter());
  for (const std::string& line : outcome.damaged) std::cout << "lost: " << line << '\n';
  const StereoCamera& camera = outcome.camera;
  std::cout << outcome.frames << " pairs of " << camera.width_px << "x" << camera.height_px
            << " px, " << (outcome.rectified ? "rectified" : "used as they are")
            << ", times: " << outcome.times << "\ncalibration: fx " << ReadableNumber(camera.fx)
            << ", fy " << ReadableNumber(camera.fy) << ", cx " << ReadableNumber(camera.cx)
            << ", cy " << ReadableNumber(camera.cy) << " px, baseline "
            << ReadableNumber(camera.baseline_m) << " m\nwritten: " << flags.output << '\n';
  return 0;
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
  add("--dataset", dataset, "NAME",
      "recorded data set, kitti or other; default: kitti if the calibration is KITTI's");
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
  add("--groundtruth", groundtruth, "NAME",
      "KITTI raw: devkit (OxTS packets as recorded) or interpolated (OxTS interpolated to image "
      "times)")
      ->capture_default_str();
  add("--detections", detections_file, "FILE|labels|none",
      "source of 2D boxes: a file in KITTI format (track ids are ignored), a detector level of a "
      "synthetic scene (oracle, good, poor), the 2D boxes of the labels (labels:0-5: of the tracks "
      "with these ids), or none");
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

void CheckStereo(const StereoImport& stereo) {
  if (stereo.left.empty()) throw UsageError("--left is missing");
  if (stereo.right.empty()) throw UsageError("--right is missing");
  if (stereo.calibration.empty()) throw UsageError("--calib is missing");
}

std::vector<std::filesystem::path> InputsOf(const StereoImport& stereo) {
  return {stereo.left, stereo.right, stereo.calibration, stereo.times};
}

void AddStereo(CLI::App& app, StereoImport& stereo) {
  const auto add = [&app](const char* flag, auto& value, const char* kind, const char* meaning) {
    return app.add_option(flag, value, meaning)->type_name(kind)->group("Your own stereo images");
  };
  add("--left", stereo.left, "FOLDER|VIDEO", "images of the left camera");
  add("--right", stereo.right, "FOLDER|VIDEO",
      "images of the right camera, the same number as --left");
  add("--calib", stereo.calibration, "FILE",
      "calibration file: YAML or JSON as in experiments/README.md, or the format of OpenCV, Kalibr "
      "or KITTI; unrectified images are rectified");
  add("--times", stereo.times, "FILE",
      "file with one timestamp per line, in seconds or integer nanoseconds; default: the file "
      "names if they are nanoseconds, otherwise --rate");
  add("--rate", stereo.rate_hz, "HZ",
      "frame rate, used if neither --times nor the file names give timestamps; default: the "
      "video's frame rate, otherwise 10")
      ->check(Within(1e-3, 1e6));
}

std::vector<std::filesystem::path> SequenceFlags::OwnInputs() const {
  std::vector<std::filesystem::path> inputs = InputsOf(stereo);
  inputs.insert(inputs.end(), {detections_file, labels_file});
  return inputs;
}

SequenceRequest SequenceFlags::Request(bool quiet) const {
  CheckNoFolder("--labels", labels_file);
  if (detections_file != "labels" && detections_file != "none") {
    CheckNoFolder("--detections", detections_file);
  }
  SequenceRequest request = *this;
  if (stereo.left.empty() && stereo.right.empty()) {
    if (folder.empty()) throw UsageError(kSequenceMissing);
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

Command AddImportCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "import", "Convert your own stereo images into a sequence, rectifying them if necessary");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<ImportFlags>();
  AddStereo(*app, flags->stereo);
  add("-o,--output", flags->output, "FOLDER", "new folder, in the layout of KITTI odometry")
      ->required();
  AddQuiet(*app, flags->quiet);
  app->footer(
      "run accepts the same flags and caches the sequence. Use import to inspect the sequence or "
      "to\nuse it in a suite.\n"
      "Example: clustervo import --left cam0 --right cam1 --calib camchain.yaml -o kitchen");
  return {app, [flags] { return Import(*flags); }};
}

}  // namespace cvo
