// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/write/manifest.h"

#include <mutex>

#include "core/base/error.h"
#include "core/files/json/json.h"
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
  if (!json.is_object() || json.value("kind", "") != kKind ||
      json.value("schema_version", 0) != kSchemaVersion) {
    ThrowError(path.string(), "another JSON file", expected());
  }
  Manifest manifest;
  try {
    manifest.scene = json.at("scene");
    if (!json.at("seed").is_null()) manifest.seed = json.at("seed").get<std::uint64_t>();
    manifest.first_frame = json.at("frames").at("first");
    manifest.frames = json.at("frames").at("count");
    manifest.width_px = json.at("image").at("width_px");
    manifest.height_px = json.at("image").at("height_px");
    if (json.contains("rig_error")) {
      const Json& error = json.at("rig_error");
      manifest.rig_error.shift_px = error.at("shift_px");
      for (int i = 0; i < 3; ++i)
        manifest.rig_error.rotation_deg[i] = error.at("rotation_deg").at(i);
      manifest.rig_error.focal = error.at("focal");
    }
    manifest.renderer.gl = json.at("renderer").at("gl");
    manifest.renderer.renderer = json.at("renderer").at("renderer");
    manifest.program_sources = json.at("program_sources");
    for (const Json& file : json.at("files")) {
      manifest.files.push_back({file.at("name"), file.at("size_bytes"), file.at("sha256")});
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
