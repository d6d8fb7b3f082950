// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/collection.h"

#include <filesystem>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/atomic_file.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "synth/scene/description.h"
#include "synth/scene/object_reader.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using synth::ObjectReader;

CollectionFigure ReadFigure(ObjectReader object) {
  CollectionFigure figure;
  figure.suite = object.Text("suite");
  figure.sequence = object.Text("sequence");
  figure.variants = object.TextOr("variants", "full");
  for (const double frame : object.Numbers("frames", {0.0, 1e6}, {1, 2, 3, 4})) {
    figure.frames.push_back(static_cast<int>(frame));
  }
  object.Finish();
  return figure;
}

void ReadRows(ObjectReader& object, CollectionSection& section) {
  section.columns = ReadTexts(object.Value("columns"), object.Where("columns"));
  for (const Json& row : object.Value("rows")) {
    section.rows.push_back(ReadTexts(row, object.Where("rows")));
    if (section.rows.back().size() == section.columns.size()) continue;
    ThrowError(object.Where("rows"), StrCat(section.rows.back().size(), " cells"),
               StrCat(section.columns.size(), ", one per column"));
  }
}

// Resolves a suite file relative to the collection's folder; other names stay as they are.
std::string SuitePath(const std::string& suite, const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / suite, ignored) ? (folder / suite).string() : suite;
}

CollectionSection ReadSection(ObjectReader object, const fs::path& folder) {
  CollectionSection section;
  section.title = object.Text("title");
  section.suite = SuitePath(object.TextOr("suite", ""), folder);
  if (object.Has("text")) section.text = ReadTexts(object.Value("text"), object.Where("text"));
  section.data = object.TextOr("data", "");
  section.times = object.BoolOr("times", false);
  if (object.Has("columns")) ReadRows(object, section);
  for (ObjectReader& figure : object.ObjectsOr("figures")) {
    section.figures.push_back(ReadFigure(std::move(figure)));
  }
  object.Finish();
  return section;
}

Collection ReadCollection(const Json& json, const std::string& where, const fs::path& folder) {
  ObjectReader object(json, where, "");
  Collection collection;
  collection.name = object.Text("name");
  collection.about = object.TextOr("about", "");
  for (ObjectReader& section : object.ObjectsOr("sections")) {
    collection.sections.push_back(ReadSection(std::move(section), folder));
  }
  object.Finish();
  if (collection.sections.empty()) ThrowError(where + ", sections", "none", "at least one");
  return collection;
}

}  // namespace

std::optional<Collection> FindCollection(const std::string& name) {
  for (const ShippedSuite& shipped : ShippedCollections()) {
    if (shipped.name == name) return ReadCollection(ParseJson(shipped.text, name), name, {});
  }
  std::error_code ignored;
  if (!fs::is_regular_file(name, ignored)) return std::nullopt;
  const Json json = ReadJson(name);
  if (!json.is_object() || !json.contains("sections")) return std::nullopt;
  return ReadCollection(json, name, fs::absolute(name).parent_path());
}

std::string SuiteFolderName(const std::string& suite) { return fs::path(suite).stem().string(); }

namespace {

constexpr std::string_view kHashLine = "# scene_sha256 ";

const ShippedTrajectory* Find(const std::string& system, const SuiteSequence& sequence) {
  const std::string scene = fs::path(sequence.scene).stem().string();
  for (const ShippedTrajectory& trajectory : ShippedTrajectories()) {
    if (trajectory.system == system && trajectory.scene == scene) return &trajectory;
  }
  return nullptr;
}

std::string SceneText(const std::string& scene) {
  const std::vector<synth::ShippedScene> shipped = synth::ShippedScenes();
  const synth::ShippedScene* found = FindBy(shipped, &synth::ShippedScene::name, scene);
  return found != nullptr ? found->text : ReadFileBytes(scene);
}

// Returns why the trajectory was made from other images than the sequence has; empty if it was not.
std::string Difference(const ShippedTrajectory& trajectory, const SuiteSequence& sequence) {
  if (!sequence.frames.empty()) return "ran on all frames, not " + sequence.frames;
  if (!sequence.perturb.empty()) return "ran on images without the perturbation";
  const std::string_view hash = trajectory.text.substr(kHashLine.size(), kHashBytes);
  if (Sha256Hex(SceneText(sequence.scene)) == hash) return "";
  return StrCat("ran on the scene file of SHA-256 ", hash.substr(0, 8), ", which has changed");
}

}  // namespace

std::vector<SuiteSystem::Files> ShippedFilesOf(const std::string& system,
                                               const std::vector<SuiteSequence>& sequences,
                                               const std::string& where) {
  std::vector<SuiteSystem::Files> files;
  std::set<std::string> named;
  for (const SuiteSequence& sequence : sequences) {
    if (Find(system, sequence) == nullptr || !named.insert(sequence.name).second) continue;
    files.push_back({sequence.name, "", ""});
  }
  if (!files.empty()) return files;
  const std::string known =
      Joined(ShippedTrajectories(), ", ", [](const ShippedTrajectory& trajectory) {
        return StrCat(trajectory.system, " on ", trajectory.scene);
      });
  ThrowError(where, "none", "a file for each sequence; those that come with the program: " + known);
}

SystemFiles ShippedSystemFiles(const std::string& system, const SuiteSequence& sequence,
                               const fs::path& cache) {
  const ShippedTrajectory& trajectory = *Find(system, sequence);
  const std::string difference = Difference(trajectory, sequence);
  if (!difference.empty()) {
    throw Error(StrCat(kStale, system, " on ", sequence.name, " ", difference));
  }
  const fs::path folder = cache / "trajectories" / system;
  const std::string name =
      StrCat(trajectory.scene, "-", Sha256Hex(trajectory.text).substr(0, 8), ".tum");
  std::error_code ignored;
  if (!fs::exists(folder / name, ignored)) {
    fs::create_directories(folder);
    WriteFilesAtomically(folder, {{name, std::string(trajectory.text)}});
  }
  return {system, folder / name, ""};
}

}  // namespace cvo
