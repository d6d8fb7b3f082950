// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/manifest.h"

#include <array>
#include <mutex>

#include "core/base/error.h"
#include "core/files/json/json_record.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"

namespace cvo::synth {
namespace {

constexpr int kSchemaVersion = 1;
constexpr char kKind[] = "clustervo synthetic sequence";

std::optional<std::string> FileDamage(const std::filesystem::path& path, const FileRecord& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) return path.string() + " is missing";
  if (static_cast<std::int64_t>(size) != file.size_bytes) {
    return StrCat(path.string(), " has ", size, " bytes instead of ", file.size_bytes);
  }
  if (Sha256Hex(ReadFileBytes(path)) != file.sha256) {
    return path.string() + " has changed since it was written";
  }
  return std::nullopt;
}

}  // namespace

std::string FormatManifest(const Manifest& manifest) {
  Json json;
  json["kind"] = kKind;
  json["schema_version"] = kSchemaVersion;
  json["scene"] = manifest.scene;
  json["seed"] = manifest.seed ? Json(*manifest.seed) : Json();
  json["frames"] = {{"first", manifest.first_frame}, {"count", manifest.frames}};
  json["image"] = {{"width_px", manifest.width_px}, {"height_px", manifest.height_px}};
  if (!manifest.rig_error.IsZero()) {
    const RigError& error = manifest.rig_error;
    json["rig_error"] = {
        {"shift_px", error.shift_px},
        {"rotation_deg", {error.rotation_deg.x(), error.rotation_deg.y(), error.rotation_deg.z()}},
        {"focal", error.focal}};
  }
  json["renderer"] = {{"gl", manifest.renderer.gl}, {"renderer", manifest.renderer.renderer}};
  json["program_sources"] = manifest.program_sources;
  json["files"] = Json::array();
  for (const FileRecord& file : manifest.files) {
    json["files"].push_back(
        {{"name", file.name}, {"size_bytes", file.size_bytes}, {"sha256", file.sha256}});
  }
  return DumpJson(json);
}

Manifest ReadManifest(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kManifestName;
  const Json json = ReadJson(path);
  const auto expected = [] { return StrCat("a manifest \"", kKind, "\", ", kSchemaVersion); };
  if (!json.is_object() || json.value("kind", Json()) != kKind ||
      json.value("schema_version", Json()) != kSchemaVersion) {
    ThrowError(path.string(), "another JSON file", expected());
  }
  Manifest manifest;
  const auto read = [&]<typename T>(const Json& from, const char* key, T& value) {
    value = FromJson<T>(from.at(key), StrCat(path.string(), ", ", key));
  };
  try {
    read(json, "scene", manifest.scene);
    read(json, "seed", manifest.seed);
    read(json.at("frames"), "first", manifest.first_frame);
    read(json.at("frames"), "count", manifest.frames);
    read(json.at("image"), "width_px", manifest.width_px);
    read(json.at("image"), "height_px", manifest.height_px);
    if (json.contains("rig_error")) {
      const Json& error = json.at("rig_error");
      std::array<double, 3> rotation_deg;
      read(error, "shift_px", manifest.rig_error.shift_px);
      read(error, "rotation_deg", rotation_deg);
      read(error, "focal", manifest.rig_error.focal);
      manifest.rig_error.rotation_deg = Eigen::Vector3d(rotation_deg.data());
    }
    read(json.at("renderer"), "gl", manifest.renderer.gl);
    read(json.at("renderer"), "renderer", manifest.renderer.renderer);
    read(json, "program_sources", manifest.program_sources);
    for (const Json& file : json.at("files")) {
      FileRecord& record = manifest.files.emplace_back();
      read(file, "name", record.name);
      read(file, "size_bytes", record.size_bytes);
      read(file, "sha256", record.sha256);
    }
  } catch (const nlohmann::json::exception& error) {
    ThrowError(path.string(), StrCat("a damaged one (", error.what(), ")"), expected());
  }
  return manifest;
}

std::optional<std::string> FindDamage(const std::filesystem::path& folder, const Manifest& manifest,
                                      TaskPool& pool, const std::function<void()>& done) {
  std::vector<std::optional<std::string>> damages(manifest.files.size());
  std::mutex mutex;
  pool.ParallelFor(static_cast<int>(damages.size()), [&](int i) {
    const FileRecord& file = manifest.files[static_cast<std::size_t>(i)];
    damages[static_cast<std::size_t>(i)] = FileDamage(folder / file.name, file);
    const std::lock_guard lock(mutex);
    if (done) done();
  });
  for (const auto& damage : damages) {
    if (damage) return damage;
  }
  return std::nullopt;
}

}  // namespace cvo::synth
