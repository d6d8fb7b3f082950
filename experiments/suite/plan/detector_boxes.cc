// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/plan/detector_boxes.h"

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "detector_sources.h"
#include "experiments/record/build_identity.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

std::string Number(double value) { return Json(value).dump(); }

}  // namespace

std::string FindMissingFile(const SuiteSequence& sequence, const fs::path& data) {
  const SuiteDetector& detector = sequence.detector;
  std::vector<std::string> files = {detector.model, detector.weights, detector.names,
                                    sequence.labels};
  const bool is_file =
      detector.model.empty() && sequence.scene.empty() && !AreFromLabels(sequence.detections);
  if (is_file) files.push_back(sequence.detections);
  for (const std::string& file : files) {
    std::error_code ignored;
    if (!file.empty() && !fs::is_regular_file(data / file, ignored)) return file;
  }
  return "";
}

fs::path BoxesFile(const DetectorInput& input, const std::vector<ImageHashes>& images,
                   const fs::path& cache, const HashFiles& hash) {
  const SuiteDetector& detector = input.written.detector;
  const fs::path model = input.data / detector.model;
  const fs::path weights = detector.weights.empty() ? fs::path(model).replace_extension(".weights")
                                                    : input.data / detector.weights;
  Json json = {{"program", kDetectorSources},
               {"opencv", ThisBuild().libraries.opencv},
               {"cpu_level", ThisBuild().cpu_level},
               {"network", hash({model, weights, input.data / detector.names})},
               {"input", detector.input},
               {"first_frame", input.sequence.first_frame},
               {"images", Json::array()}};
  if (detector.min_score) json["min_score"] = *detector.min_score;
  if (detector.max_overlap) json["max_overlap"] = *detector.max_overlap;
  if (input.sequence.rectification) json["rectified"] = input.sequence.rectification->identity();
  for (const ImageHashes& pair : images) json["images"].push_back(pair.left);
  return cache / "detections" / (Sha256Hex(DumpJson(json)) + ".txt");
}

bool AreBoxesWhole(const fs::path& boxes, const HashFiles& hash) try {
  const std::string checksum = ReadFileBytes(boxes.string() + kChecksumSuffix, kHashBytes);
  return checksum == hash({boxes}).front();
} catch (const Error&) {
  return false;
}

std::vector<std::string> DetectArguments(const DetectorInput& input, const fs::path& boxes) {
  const auto& [written, sequence, data] = input;
  const SuiteDetector& detector = written.detector;
  std::vector<std::string> arguments = {"detect",  sequence.folder.string(),
                                        "--model", (data / detector.model).string(),
                                        "--names", (data / detector.names).string()};
  const auto add = [&arguments](const char* flag, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {flag, value});
  };
  if (!detector.weights.empty()) add("--weights", (data / detector.weights).string());
  add("--input", detector.input);
  if (detector.min_score) add("--min-score", Number(*detector.min_score));
  if (detector.max_overlap) add("--max-overlap", Number(*detector.max_overlap));
  add("--pair", written.pair);
  // The frames of a scene were selected at rendering.
  if (written.scene.empty()) add("--frames", written.frames);
  if (!written.layout.empty()) add("--layout", written.layout.dump());
  arguments.insert(arguments.end(), {"-o", boxes.string(), "--checksum"});
  return arguments;
}

}  // namespace cvo
