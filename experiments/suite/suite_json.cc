// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/parse_suite.h"

namespace cvo {
namespace {

void AddText(const char* key, const std::string& text, Json& json) {
  if (!text.empty()) json[key] = text;
}

void AddDetections(const SuiteSequence& sequence, Json& json) {
  const SuiteDetector& detector = sequence.detector;
  if (detector.model.empty()) {
    AddText("detections", sequence.detections, json);
    return;
  }
  Json& written = json["detections"];
  written = {{"name", sequence.detections}, {"model", detector.model}, {"names", detector.names}};
  AddText("weights", detector.weights, written);
  AddText("input", detector.input, written);
  if (detector.min_score) written["min_score"] = *detector.min_score;
  if (detector.max_overlap) written["max_overlap"] = *detector.max_overlap;
}

Json SequenceToJson(const SuiteSequence& sequence) {
  Json json;
  AddText("scene", sequence.scene, json);
  AddText("folder", sequence.folder, json);
  json["name"] = sequence.name;
  AddText("frames", sequence.frames, json);
  AddDetections(sequence, json);
  if (!sequence.classes.empty()) json["classes"] = sequence.classes;
  if (!sequence.perturb.empty()) json["perturb"] = sequence.perturb;
  if (sequence.folder.empty()) return json;
  AddText("dataset", sequence.dataset, json);
  AddText("pair", sequence.pair, json);
  json["groundtruth"] = sequence.groundtruth;
  if (sequence.detections_camera >= 0) json["detections_camera"] = sequence.detections_camera;
  if (sequence.min_score) json["min_score"] = *sequence.min_score;
  AddText("labels", sequence.labels, json);
  if (!sequence.layout.empty()) json["layout"] = sequence.layout;
  return json;
}

Json SystemToJson(const SuiteSystem& system) {
  if (system.shipped) return {{"name", system.name}};
  Json files = Json::array();
  for (const SuiteSystem::Files& file : system.files) {
    Json row = {{"sequence", file.sequence}, {"camera", file.camera}};
    AddText("objects", file.objects, row);
    files.push_back(std::move(row));
  }
  return {{"name", system.name}, {"files", std::move(files)}};
}

}  // namespace

Json SuiteToJson(const Suite& suite) {
  Json json = {{"name", suite.name}, {"about", suite.about}, {"sequences", Json::array()}};
  for (const SuiteSequence& sequence : suite.sequences) {
    json["sequences"].push_back(SequenceToJson(sequence));
  }
  json["variants"] = suite.variants;
  json["seeds"] = suite.seeds;
  json["options"] = suite.options;
  json["grid"] = Json::object();
  for (const GridAxis& axis : suite.grid) json["grid"][axis.path] = axis.values;
  json["grid_one_at_a_time"] = suite.grid_one_at_a_time;
  json["oracles"] = suite.oracles;
  json["systems"] = Json::array();
  for (const SuiteSystem& system : suite.systems) json["systems"].push_back(SystemToJson(system));
  if (suite.timed_threads > 0) json["timed_threads"] = suite.timed_threads;
  json["landmarks"] = suite.landmarks;
  json["table"] = ToJson(suite.table);
  return json;
}

}  // namespace cvo
