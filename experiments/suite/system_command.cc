// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/system_command.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <regex>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "core/files/images/image_file.h"
#include "core/files/sha256.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/images.h"
#include "experiments/runner/given.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"
#include "experiments/suite/engine.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

using Texts = std::vector<std::string>;
using Values = std::map<std::string, std::string>;  // by placeholder

std::string Filled(std::string text, const Values& values) {
  for (const auto& [name, value] : values) {
    const std::string key = "{" + name + "}";
    for (std::size_t at = 0; (at = text.find(key, at)) != text.npos; at += value.size()) {
      text.replace(at, key.size(), value);
    }
  }
  return text;
}

std::string LastLine(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \r\n");
  if (end == text.npos) return "no output";
  const std::size_t begin = text.rfind('\n', end);
  return Quoted(text.substr(begin == text.npos ? 0 : begin + 1, end - begin));
}

std::string VersionOf(const Texts& version) {
  constexpr std::chrono::seconds kLimit(10);
  if (version.empty()) return "";
  const auto start = std::chrono::steady_clock::now();
  const Captured said = Capture(
      version, [&](const auto&) { return std::chrono::steady_clock::now() - start > kLimit; });
  if (said.exit_code == 0) return said.out.substr(0, said.out.find('\n'));
  ThrowError(Joined(version, " "),
             StrCat("exit code ", said.exit_code, ", ", LastLine(said.out + said.err)),
             "its version, with exit code 0");
}

// The focal lengths and centres of both cameras; an error of the rectification moves the right one.
struct Pair {
  explicit Pair(const Sequence& sequence) : camera(sequence.camera) {
    const auto& times_ns = sequence.timestamps_ns;
    const double time_s = 1e-9 * static_cast<double>(times_ns.back() - times_ns.front());
    if (time_s > 0.0) rate_hz = static_cast<double>(times_ns.size() - 1) / time_s;
  }
  double right_cx() const { return camera.cx + camera.right_shift_px; }

  const StereoCamera& camera;
  double rate_hz = 10.0;
};

std::string KittiCalibration(const Pair& pair) {
  const StereoCamera& c = pair.camera;
  std::string text;
  for (int i = 0; i < 4; ++i) {
    const bool right = i % 2 == 1;
    text += StrCat("P", i, ": ", FormatDouble(c.fx), " 0 ",
                   FormatDouble(right ? pair.right_cx() : c.cx), " ",
                   FormatDouble(right ? -c.fx * c.baseline_m : 0.0), " 0 ", FormatDouble(c.fy), " ",
                   FormatDouble(c.cy), " 0 0 0 1 0\n");
  }
  return text;
}

std::string EurocCalibration(const Pair& pair, bool right) {
  const StereoCamera& c = pair.camera;
  return StrCat("sensor_type: camera\nT_BS:\n  cols: 4\n  rows: 4\n  data: [1.0, 0.0, 0.0, ",
                FormatDouble(right ? c.baseline_m : 0.0),
                ", 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]\nrate_hz: ",
                FormatDouble(pair.rate_hz), "\nresolution: [", c.width_px, ", ", c.height_px,
                "]\ncamera_model: pinhole\nintrinsics: [", FormatDouble(c.fx), ", ",
                FormatDouble(c.fy), ", ", FormatDouble(right ? pair.right_cx() : c.cx), ", ",
                FormatDouble(c.cy), "]\ndistortion_model: radial-tangential\n",
                "distortion_coefficients: [0.0, 0.0, 0.0, 0.0]\n");
}

// Settings with the number of corners and the depth limit that are usual for ORB-SLAM. Its reader
// wants real numbers with a point.
std::string OrbSlamCalibration(const Pair& pair) {
  const StereoCamera& c = pair.camera;
  std::string text = "%YAML:1.0\nCamera.type: \"PinHole\"\n";
  const std::vector<std::pair<const char*, double>> reals = {
      {"fx", c.fx},         {"fy", c.fy}, {"cx", c.cx},
      {"cy", c.cy},         {"k1", 0.0},  {"k2", 0.0},
      {"p1", 0.0},          {"p2", 0.0},  {"bf", c.fx * c.baseline_m},
      {"fps", pair.rate_hz}};
  for (const auto& [key, value] : reals)
    text += StrCat("Camera.", key, ": ", FormatFixed(value, 9), "\n");
  return text + StrCat("Camera.width: ", c.width_px, "\nCamera.height: ", c.height_px,
                       "\nCamera.RGB: 1\nThDepth: 35.0\nORBextractor.nFeatures: 2000\n",
                       "ORBextractor.scaleFactor: 1.2\nORBextractor.nLevels: 8\n",
                       "ORBextractor.iniThFAST: 20\nORBextractor.minThFAST: 7\n");
}

std::string JsonCalibration(const Pair& pair) {
  const StereoCamera& c = pair.camera;
  return DumpJson({{"fx_px", c.fx},
                   {"fy_px", c.fy},
                   {"cx_px", c.cx},
                   {"cy_px", c.cy},
                   {"right_cx_px", pair.right_cx()},
                   {"baseline_m", c.baseline_m},
                   {"width_px", c.width_px},
                   {"height_px", c.height_px},
                   {"rate_hz", pair.rate_hz}});
}

// What {calibration} leads to, below the inputs.
const std::map<std::string, std::string> kCalibrations = {{"kitti", "calib.txt"},
                                                          {"euroc", "euroc"},
                                                          {"orb_slam", "orb_slam.yaml"},
                                                          {"json", "calib.json"}};

// Rows of KITTI tracking, with frames counted from the first one that is read.
std::string DetectionRows(const Sequence& sequence, const Texts& classes) {
  std::string text;
  const auto frames = DetectionsByFrame(sequence);
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    for (const ObjectBox& box : frames[frame]) {
      if (std::find(classes.begin(), classes.end(), box.type) == classes.end()) continue;
      text += StrCat(frame, " -1 ", box.type, " -1 -1 -10");
      for (const double edge : {box.left_px, box.top_px, box.right_px, box.bottom_px}) {
        text += " " + FormatDouble(edge);
      }
      text +=
          StrCat(" -1 -1 -1 -1000 -1000 -1000 -10 ", FormatDouble(box.score.value_or(1.0)), "\n");
    }
  }
  return text;
}

// Links to an image, or writes it as it is used. Numbers start at zero.
void GiveImage(const Sequence& sequence, std::size_t index, int side, const fs::path& folder) {
  const StereoPaths& pair = sequence.images[index];
  const fs::path source = fs::absolute(side == 0 ? pair.left : pair.right);
  const std::string number = StrCat(index);
  const fs::path name =
      folder / (std::string(6 - std::min<std::size_t>(6, number.size()), '0') + number);
  if (!sequence.rectification && PerturbationToJson(sequence.perturbation).empty()) {
    fs::create_symlink(source, name.string() + source.extension().string());
    return;
  }
  LoadedImage image = LoadFrameImage(sequence, index, side);
  if (!image.ok()) throw Error(image.problem);
  if (IsDropped(sequence, index)) {
    ThrowError(source.string(), "dropped by perturb.drop_rate", "an image for another system");
  }
  PerturbImage(sequence, index, side, image.grey);
  WriteFileBytes(name.string() + ".png", EncodeImage(".png", image.grey));
}

// Writes what placeholders lead to, unless an earlier job has.
void WriteInputs(const Sequence& sequence, const Texts& classes, const fs::path& inputs) {
  std::error_code ignored;
  if (fs::exists(inputs, ignored)) return;
  RemoveLeftovers(inputs.parent_path());
  const fs::path folder = TemporaryName(inputs);
  const Texts sides = {"left", "right"};
  for (const char* name : {"left", "right", "euroc/cam0", "euroc/cam1"}) {
    fs::create_directories(folder / name);
  }
  std::string times;
  for (std::size_t i = 0; i < sequence.images.size(); ++i) {
    for (int side : {0, 1}) GiveImage(sequence, i, side, folder / sides[std::size_t(side)]);
    times += FormatSecondsNs(sequence.timestamps_ns[i]) + "\n";
  }
  const Pair pair(sequence);
  WriteFilesAtomically(folder, {{"times.txt", times},
                                {"detections.txt", DetectionRows(sequence, classes)},
                                {"calib.txt", KittiCalibration(pair)},
                                {"euroc/cam0/sensor.yaml", EurocCalibration(pair, false)},
                                {"euroc/cam1/sensor.yaml", EurocCalibration(pair, true)},
                                {"orb_slam.yaml", OrbSlamCalibration(pair)},
                                {"calib.json", JsonCalibration(pair)}});
  fs::rename(folder, inputs, ignored);  // fails if another job was faster
  fs::remove_all(folder, ignored);
}

}  // namespace

bool SuiteSystem::Uses(const std::string& placeholder) const {
  return std::any_of(command.begin(), command.end(),
                     [&](const auto& text) { return text.find(placeholder) != text.npos; });
}

Texts CalibrationForms() {
  Texts forms;
  for (const auto& [form, path] : kCalibrations) forms.push_back(form);
  return forms;
}

// Scripts have braces of their own: only a name in braces near to a placeholder, or that is all
// there is, can be misspelt.
void CheckPlaceholders(const SuiteSystem& system, const std::string& where) {
  static const Texts kKnown = {"left",       "right", "times", "calibration",
                               "detections", "out",   "seed",  "sequence"};
  static const std::regex kName(R"((^|[^$])\{([A-Za-z_]+)\})");
  Texts texts = system.command;
  texts.insert(texts.end(), {system.camera, system.objects});
  for (const std::string& text : texts) {
    for (std::sregex_iterator found(text.begin(), text.end(), kName), end; found != end; ++found) {
      const std::string name = (*found)[2];
      if (std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end()) continue;
      const std::string hint = DidYouMean(name, kKnown);
      if (hint.empty() && found->str() != text) continue;
      ThrowError(where, StrCat("{", name, "}", hint), "one of: " + Joined(kKnown, ", "));
    }
  }
}

std::string ForJob(const std::string& text, const PlanJob& job) {
  return Filled(text, {{"sequence", job.sequence}, {"seed", std::to_string(job.seed)}});
}

void ResolveCommands(const fs::path& folder, Json& suite) {
  if (folder.empty() || !suite.is_object() || !suite.contains("systems")) return;
  for (Json& system : suite["systems"]) {
    for (const char* key : {"command", "version"}) {
      if (!system.is_object() || !system.contains(key) || !system[key].is_array()) continue;
      for (Json& word : system[key]) {
        std::error_code ignored;
        const fs::path file = word.is_string() ? word.get<std::string>() : "";
        if (file.empty() || !fs::exists(folder / file, ignored)) continue;
        word = (folder / file).lexically_normal().string();
      }
    }
  }
}

Json IdentifyProgram(const SuiteSystem& system) {
  Json command = Json::array();
  for (const std::string& argument : system.command) {
    const fs::path file = argument;
    std::error_code ignored;
    const bool is_file = argument.find('/') != argument.npos && fs::is_regular_file(file, ignored);
    if (command.empty() && argument.find('/') != argument.npos && !is_file) {
      ThrowError(argument, "no such program", "a file that can be executed");
    }
    command.push_back(
        is_file ? StrCat(file.filename().string(), " ", Sha256Hex(ReadFileBytes(file))) : argument);
  }
  return {{"command", command},
          {"version", VersionOf(system.version)},
          {"calibration", system.calibration},
          {"writes", {system.camera, system.objects}}};
}

Json WithInput(Json program, const SuiteSystem& system, const Sequence& sequence) {
  if (system.Uses("{detections}")) program["detections"] = DetectionsHash(sequence);
  return program;
}

std::string InputsKey(const Sequence& sequence, const std::string& content, const Texts& classes) {
  return Sha256Hex(StrCat(fs::absolute(sequence.folder).string(), content, DetectionsHash(sequence),
                          Json(classes).dump()));
}

SystemFiles RunProgram(const Suite& suite, const PlanJob& job, const Sequence& sequence,
                       const fs::path& inputs, const fs::path& folder) {
  const SuiteSystem& system = *SystemOf(suite, job);
  WriteInputs(sequence, ClassesOf(suite.sequences[job.entry]), inputs);
  const fs::path out = folder / "out";
  fs::remove_all(out);  // of an earlier try
  fs::create_directories(out);
  Values values = {{"out", out.string()},
                   {"calibration", inputs / kCalibrations.at(system.calibration)}};
  for (const char* name : {"left", "right"}) values[name] = inputs / name;
  for (const char* name : {"times", "detections"}) values[name] = inputs / StrCat(name, ".txt");
  const auto filled = [&](const std::string& text) { return Filled(ForJob(text, job), values); };
  Texts argv;
  for (const std::string& argument : system.command) argv.push_back(filled(argument));
  const fs::path log = folder / "output.txt";
  const Measured measured = Measure(argv, out, log);
  if (!measured.problem.empty()) {
    throw Error(StrCat(system.name, ": ", measured.problem, ", its last line is ",
                       LastLine(ReadFileBytes(log)), " (", log.string(), ")"));
  }
  reports::TimingData timing = ThisProcess();
  timing.job = job.job;
  timing.wall_s = measured.wall_s;
  timing.cpu_s = measured.cpu_s;
  timing.peak_memory_mb = measured.peak_memory_mb;
  timing.frames_per_second = static_cast<double>(sequence.images.size()) / measured.wall_s;
  timing.paths.sequence = fs::absolute(sequence.folder).string();
  timing.paths.output = folder.string();
  WriteFilesAtomically(folder, {{"timing.json", FileText(timing)}});
  const fs::path objects = filled(system.objects);
  return {system.name, out / filled(system.camera), objects.empty() ? objects : out / objects, 0};
}

}  // namespace cvo
