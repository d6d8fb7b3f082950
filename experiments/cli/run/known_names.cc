// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/known_names.h"

#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "synth/family/family.h"
#include "synth/scene/description.h"

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

}  // namespace

const VariantInfo& VariantNamed(const std::string& name) {
  std::vector<std::string> names;
  for (const VariantInfo& variant : Variants()) names.emplace_back(variant.name);
  const std::string meant = DidYouMean(name, names);
  const bool known = std::find(names.begin(), names.end(), name) != names.end();
  if (known) return FindVariant(name);
  FailUsage("--variant", Quoted(name) + meant,
            meant.empty() ? OneOfKnown(name, names)
                          : "one of those that `clustervo list variants` lists");
}

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

void CheckDetections(const std::string& detections, const fs::path& folder) {
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

}  // namespace cvo
