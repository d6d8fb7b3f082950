// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/cell_input.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/options_json.h"
#include "experiments/datasets/frame_range.h"
#include "experiments/runner/frame_detections.h"
#include "experiments/suite/shipped_trajectories.h"
#include "variants/registry.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDetector = "scene.detector.";

bool ChangesDetector(const GridPoint& parameters) {
  return std::any_of(parameters.begin(), parameters.end(),
                     [](const auto& parameter) { return parameter.first.starts_with(kDetector); });
}

// Returns {"a": {"b": value}} for the path "a.b".
Json Nested(const std::string& path, const Json& value) {
  const std::size_t dot = path.find('.');
  if (dot == std::string::npos) return {{path, value}};
  return {{path.substr(0, dot), Nested(path.substr(dot + 1), value)}};
}

// Returns the file of a scene's boxes. A grid point that changes the detector has a file of its
// own.
fs::path SceneDetections(const Cell& cell, const fs::path& folder) {
  const std::string level = DetectorLevel(cell.sequence);
  if (level.empty()) return cell.sequence.detections;
  const std::string name = ChangesDetector(cell.parameters) ? "custom" : level;
  return folder / "detections" / (name + ".txt");
}

}  // namespace

Options OptionsOf(const Suite& suite, const std::string& variant, const GridPoint& parameters) {
  Options options = variant.empty() ? Options() : FindVariant(variant).defaults();
  const std::vector<OptionLeaf> leaves = OptionLeaves(options);
  MergeOptions(suite.options, "suite " + suite.name, leaves);
  for (const auto& [path, value] : parameters) {
    if (IsOptionPath(path)) MergeOptions(Nested(path, value), "suite " + suite.name, leaves);
  }
  options.Check();
  return options;
}

Perturbation PerturbationOf(const SuiteSequence& sequence, const GridPoint& parameters,
                            std::uint64_t seed) {
  Json json = sequence.perturb;
  for (const auto& [path, value] : parameters) {
    if (IsPerturbPath(path)) json[PerturbKey(path)] = value;
  }
  Perturbation perturbation = ParsePerturbation(json, sequence.name + ", perturb");
  perturbation.seed = seed;
  return perturbation;
}

std::vector<std::string> SceneAssignments(const SuiteSequence& sequence,
                                          const GridPoint& parameters) {
  std::vector<std::string> assignments;
  if (const std::string level = DetectorLevel(sequence);
      ChangesDetector(parameters) && !level.empty()) {
    assignments.push_back("detector.level=" + level);
  }
  for (const auto& [path, value] : parameters) {
    if (IsScenePath(path)) assignments.push_back(SceneKey(path) + "=" + value.dump());
  }
  return assignments;
}

std::string DetectorLevel(const SuiteSequence& sequence) {
  const bool own = sequence.detector.model.empty();
  return own && !AreFromLabels(sequence.detections) ? sequence.detections : "";
}

SequenceRequest RequestOf(const Cell& cell, const fs::path& folder, const fs::path& data,
                          const std::string& boxes) {
  const SuiteSequence& sequence = cell.sequence;
  SequenceRequest request;
  request.folder = folder;
  request.dataset = sequence.dataset;
  request.pair = sequence.pair;
  request.groundtruth = sequence.groundtruth;
  request.perturbation = PerturbationOf(sequence, cell.parameters, cell.seed);
  const bool by_detector = !sequence.detector.model.empty();
  if (by_detector) request.detections_file = boxes;
  if (!sequence.scene.empty()) {
    if (!by_detector) request.detections_file = SceneDetections(cell, folder);
    return request;  // frames were selected at rendering
  }
  if (!sequence.frames.empty()) {
    const FrameRange range = ParseFrameRange(sequence.frames);
    request.begin_frame = range.begin;
    request.end_frame = range.end;
  }
  const bool from_labels = AreFromLabels(sequence.detections);
  if (from_labels) request.detections_file = sequence.detections;
  if (!sequence.detections.empty() && !from_labels && !by_detector) {
    request.detections_file = data / sequence.detections;
  }
  request.detections_camera = sequence.detections_camera;
  request.layout = sequence.layout;
  if (sequence.min_score) request.min_score = *sequence.min_score;
  if (!sequence.labels.empty()) request.labels_file = data / sequence.labels;
  return request;
}

std::vector<std::string> ClassesOf(const SuiteSequence& sequence) {
  return sequence.classes.empty() ? RigidClasses() : sequence.classes;
}

SystemFiles SystemFilesOf(const Suite& suite, const Cell& cell, const fs::path& data,
                          const fs::path& cache) {
  for (const SuiteSystem& system : suite.systems) {
    if (system.name != cell.system) continue;
    if (system.shipped) return ShippedSystemFiles(system.name, cell.sequence, cache);
    for (const SuiteSystem::Files& files : system.files) {
      if (files.sequence != cell.sequence.name) continue;
      return {system.name, data / files.camera, files.objects.empty() ? "" : data / files.objects};
    }
  }
  ThrowError("suite " + suite.name, "no files of " + cell.system + " on " + cell.sequence.name,
             "a cell of the suite");
}

OracleSwitches OracleOf(const std::vector<std::string>& switches) {
  const std::string text = Joined(switches, ",");
  return ParseOracle(text.empty() ? "none" : text);
}

}  // namespace cvo
