// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/scene/description.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/files/sha256.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "synth/scene/parse_scene.h"
#include "synth/scene/shipped_scenes.h"

namespace cvo::synth {
namespace {

struct SceneText {
  std::string text;
  std::string where;
  std::filesystem::path folder;
};

SceneText FindScene(const std::string& scene) {
  std::vector<std::string> names;
  for (const ShippedScene& shipped : ShippedScenes()) {
    if (shipped.name == scene) return {shipped.text, "scene " + scene, {}};
    names.push_back(shipped.name);
  }
  const std::filesystem::path file = scene;
  if (std::filesystem::is_regular_file(file)) {
    return {ReadFileBytes(file), scene, file.parent_path()};
  }
  ThrowError("scene " + Quoted(scene), "neither a shipped scene nor a file",
             "a JSON file or " + OneOfKnown(scene, names));
}

// Returns the value of one key of a path. A key that is missing in an object is created, so that
// strict parsing reports it if it is unknown.
Json& Child(Json& parent, const std::string& key, const std::string& where) {
  if (parent.is_object()) return parent[key];
  if (!parent.is_array())
    ThrowError(where, "'" + key + "' within a value that has no parts", "a path of keys");
  const auto index = ParseInteger(key);
  if (!index || *index < 0 || *index >= static_cast<std::int64_t>(parent.size())) {
    ThrowError(where, "'" + key + "'", StrCat("an index below ", parent.size()));
  }
  return parent[static_cast<std::size_t>(*index)];
}

void Assign(Json& scene, const std::string& assignment) {
  const std::string where = "--set " + assignment;
  const std::size_t equals = assignment.find('=');
  if (equals == 0 || equals == std::string::npos) {
    ThrowError(where, "no PATH=VALUE", "PATH=VALUE, for example objects.0.size_m=0.6");
  }
  Json* value = &scene;
  const std::string path = assignment.substr(0, equals);
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t end = std::min(path.find('.', start), path.size());
    value = &Child(*value, path.substr(start, end - start), where);
    if (value->is_null() && end < path.size()) *value = Json::object();
    start = end + 1;
  }
  const std::string text = assignment.substr(equals + 1);
  try {
    *value = ParseJson(text, where);
  } catch (const Error&) {
    *value = text;  // a word needs no quotes
  }
}

// Sorts keys and gives numbers a unique form, so that equal meaning gives equal text.
nlohmann::json Canonical(const Json& value) {
  if (value.is_object()) {
    nlohmann::json object = nlohmann::json::object();
    for (const auto& [key, element] : value.items()) object[key] = Canonical(element);
    return object;
  }
  if (value.is_array()) {
    nlohmann::json array = nlohmann::json::array();
    for (const Json& element : value) array.push_back(Canonical(element));
    return array;
  }
  // Keep integers: doubles cannot represent all seeds beyond 2^53.
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) {
    const double number = value.get<double>();
    const auto whole = static_cast<std::int64_t>(std::clamp(number, -1e15, 1e15));
    if (static_cast<double>(whole) == number) return whole;
    return number;
  }
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>();
  return nullptr;
}

// Hashes a mesh file and the files that belong to it because they share its stem: materials,
// buffers, images.
std::string MeshHash(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().stem() == file.stem()) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::string text;
  for (const std::filesystem::path& part : files) {
    text += part.filename().string() + " " + Sha256Hex(ReadFileBytes(part)) + "\n";
  }
  return "sha256:" + Sha256Hex(text);
}

}  // namespace

SceneDescription::SceneDescription(Json json, std::string where,
                                   const std::filesystem::path& folder)
    : json_(std::move(json)),
      where_(std::move(where)),
      parts_(std::make_shared<SceneParts>(ParseScene(json_, where_, folder))) {}

SceneDescription SceneDescription::Parse(Json json, const std::string& where,
                                         const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) Assign(json, assignment);
  return {std::move(json), where, {}};
}

SceneDescription SceneDescription::Load(const std::string& scene,
                                        const std::vector<std::string>& assignments) {
  const SceneText found = FindScene(scene);
  Json json = ParseJson(found.text, found.where);
  for (const std::string& assignment : assignments) Assign(json, assignment);
  return {std::move(json), found.where, found.folder};
}

std::string RenderKeyText(const SceneDescription& scene) {
  nlohmann::json key = Canonical(scene.json());
  const nlohmann::json blur = Canonical(scene.sensor()).value("motion_blur", nlohmann::json());
  for (const char* other : {"name", "about", "seed", "detector", "sensor"}) key.erase(other);
  if (!blur.is_null()) key["sensor"]["motion_blur"] = blur;
  // Meshes are identified by content instead of path: the same file may be elsewhere.
  for (nlohmann::json& object : key["objects"]) object.erase("file");
  for (const ObjectDescription& object : scene.parts().objects) {
    if (!object.model.file.empty()) key["meshes"][object.name] = MeshHash(object.model.file);
  }
  return key.dump(1) + "\n";
}

}  // namespace cvo::synth
