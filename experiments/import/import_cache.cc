// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/import/import_cache.h"

#include <exception>

#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/cache/content_hash.h"
#include "experiments/import/stereo_source.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

void AddImages(const fs::path& path, Sha256& hash) {
  if (!fs::is_directory(path)) {
    hash.Add(HashFile(path));
    return;
  }
  for (const fs::path& file : OpenImages(path)->files()) {
    hash.Add(file.filename().string() + "\n" + HashFile(file) + "\n");
  }
}

// Returns "kitchen" for kitchen/left.
std::string NameOf(const fs::path& left) {
  const std::string name = fs::absolute(left).lexically_normal().parent_path().filename().string();
  return name.empty() ? "stereo" : name;
}

bool IsWhole(const fs::path& folder) try {
  const Json record = ReadJson(folder / kImportRecord);
  for (const auto& [name, sha256] : record.at("files").items()) {
    if (HashFile(folder / name) != sha256) return false;
  }
  return true;
} catch (const std::exception&) {  // also those of the JSON library
  return false;
}

}  // namespace

fs::path ImportIntoCache(const StereoImport& request, const fs::path& cache,
                         const std::function<void(std::size_t done, std::size_t total)>& progress) {
  constexpr const char* kMadeBy =
      "import 2\n";  // to be changed if the same input yields other images or an error
  constexpr std::size_t kShortHash = 16;
  Sha256 hash;
  hash.Add(kMadeBy);
  hash.Add(HashFile(request.calibration));
  if (!request.times.empty()) hash.Add(HashFile(request.times));
  hash.Add(request.rate_hz ? "rate " + FormatDouble(*request.rate_hz) : "10");
  AddImages(request.left, hash);
  AddImages(request.right, hash);
  const fs::path folder =
      cache / "imported" / hash.Hex().substr(0, kShortHash) / NameOf(request.left);
  if (IsWhole(folder)) return folder;
  fs::remove_all(folder);
  ImportStereo(request, folder, progress);
  return folder;
}

}  // namespace cvo
