// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/sequence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <system_error>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/calibration/stereo_rig.h"
#include "experiments/datasets/plausibility.h"
#include "experiments/datasets/sequence_parts.h"

namespace cvo {

namespace fs = std::filesystem;
namespace {

constexpr const char* kWhere = "--frames";

// Returns `if_empty` for an empty text.
int ParseFrame(std::string_view text, int if_empty, const std::string& whole) {
  if (text.empty()) return if_empty;
  const std::optional<std::int64_t> value = ParseInteger(text);
  if (!value || *value < 0 || *value > std::numeric_limits<int>::max()) {
    ThrowError(kWhere, "\"" + whole + "\"", "A:B, A: or :B with frame numbers from 0 on");
  }
  return static_cast<int>(*value);
}

bool IsNumber(const std::string& name) {
  return !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
}

// Returns the folders in `folder`, sorted; none if it cannot be read.
std::vector<fs::path> SubFolders(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (IsFolder(entry.path())) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

// Returns <folder>/<number> of each sequence of KITTI tracking, sorted.
std::vector<fs::path> TrackingSequences(const fs::path& set_folder) {
  std::vector<fs::path> sequences;
  for (const fs::path& images : SubFolders(set_folder / "image_02")) {
    if (IsNumber(images.filename().string())) sequences.push_back(set_folder / images.filename());
  }
  return sequences;
}

const SequenceLayout* LayoutOf(const fs::path& folder) {
  for (const SequenceLayout& layout : SequenceLayouts()) {
    if (layout.knows(folder)) return &layout;
  }
  return nullptr;
}

// Visits each folder once, so that cycles of symbolic links end.
void Collect(const fs::path& folder, std::set<fs::path>& visited,
             std::vector<FoundSequence>& found) {
  std::error_code error;
  if (!visited.insert(fs::weakly_canonical(folder, error)).second) return;
  if (const SequenceLayout* layout = LayoutOf(folder)) {
    if (layout->has_images(folder)) found.push_back({folder, layout->type});
    return;
  }
  if (IsTrackingSet(folder)) {
    for (const fs::path& number : TrackingSequences(folder)) {
      const SequenceLayout* layout = LayoutOf(number);
      if (layout != nullptr && layout->has_images(number)) found.push_back({number, layout->type});
    }
    return;
  }
  for (const fs::path& child : SubFolders(folder)) {
    if (!child.filename().string().starts_with('.')) Collect(child, visited, found);
  }
}

// Whether the folder is a recording of KITTI: a rendered scene and images of the user's own may be
// in the same layouts.
bool IsOfKitti(const Sequence& sequence) {
  return sequence.type.starts_with("kitti") && !fs::exists(sequence.folder / "scene.json") &&
         !fs::exists(sequence.folder / "import.json");
}

void RefuseSeveral(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  const std::vector<FoundSequence> found = FindSequences(folder);
  if (found.empty()) return;
  ThrowError(folder.string(), StrCat("a folder that contains ", Counted(found.size(), "sequence")),
             StrCat("one of them: `clustervo info ", folder.string(), "` lists them"));
}

std::string TypeOf(const SequenceRequest& request) {
  if (!request.type.empty()) return request.type;
  const fs::path& folder = request.folder;
  const std::string type = DetectSequenceType(folder);
  if (!type.empty()) return type;
  RefuseSeveral(folder);
  const std::string found = fs::is_directory(folder) ? "a folder of no known type"
                            : fs::exists(folder)     ? "a file"
                                                     : "no such folder";
  ThrowError(folder.string(), found,
             "the folder of a sequence: " + Joined(SequenceLayouts(), ", ", &SequenceLayout::type));
}

const SequenceLayout& LayoutOfType(const std::string& type) {
  for (const SequenceLayout& layout : SequenceLayouts()) {
    if (layout.type == type) return layout;
  }
  std::vector<std::string> types;
  for (const SequenceLayout& layout : SequenceLayouts()) types.push_back(layout.type);
  ThrowError("option --type", Quoted(type) + DidYouMean(type, types), Joined(types, ", "));
}

void CheckSettings(const Json& given, const SequenceLayout& layout) {
  std::vector<std::string> known;
  for (const auto& [key, value] : layout.settings.items()) known.push_back(key);
  for (const auto& [key, value] : given.items()) {
    if (layout.settings.contains(key)) continue;
    ThrowError("layout settings", "key " + Quoted(key) + DidYouMean(key, known),
               known.empty() ? "none for " + layout.type
                             : "keys of " + layout.settings.dump() + " for " + layout.type);
  }
}

}  // namespace

FrameRange ParseFrameRange(std::string_view text) {
  const std::string whole(text);
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) {
    ThrowError(kWhere, "\"" + whole + "\"", "A:B, A: or :B with frame numbers from 0 on");
  }
  const FrameRange range = {ParseFrame(text.substr(0, colon), 0, whole),
                            ParseFrame(text.substr(colon + 1), -1, whole)};
  if (range.end >= 0 && range.end <= range.begin) {
    ThrowError(kWhere, "\"" + whole + "\", an empty range", "A:B with A < B");
  }
  return range;
}

FrameRange ResolveFrameRange(const FrameRange& range, int total) {
  const FrameRange resolved = {range.begin, range.end == -1 ? total : range.end};
  if (resolved.begin < 0 || resolved.begin >= resolved.end || resolved.end > total) {
    ThrowError(kWhere, StrCat(range.begin, ":", range.end == -1 ? "" : std::to_string(range.end)),
               StrCat("a range A:B with 0 <= A < B <= ", total, ", the frames of the sequence"));
  }
  return resolved;
}

const std::vector<SequenceLayout>& SequenceLayouts() {
  static const std::vector<SequenceLayout> layouts = {
      ClusterslamLayout(), EurocLayout(),         KittiOdometryLayout(),
      KittiRawLayout(),    KittiTrackingLayout(), OxfordMultimotionLayout()};
  return layouts;
}

bool IsFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool AreFolders(const fs::path& left, const fs::path& right) {
  return IsFolder(left) && IsFolder(right);
}

bool HasImages(const fs::path& folder) {
  const SequenceLayout* layout = LayoutOf(folder);
  return layout != nullptr && layout->has_images(folder);
}

bool IsTrackingSet(const fs::path& folder) {
  if (!IsFolder(folder / "calib")) return false;
  return IsFolder(folder / "image_02") || IsFolder(folder / "image_03");
}

std::string DetectSequenceType(const fs::path& folder) {
  const SequenceLayout* layout = LayoutOf(folder);
  return layout == nullptr ? "" : layout->type;
}

std::vector<FoundSequence> FindSequences(const fs::path& root) {
  const fs::path folder = NormalFolder(root);
  std::vector<FoundSequence> found;
  std::set<fs::path> visited;
  Collect(folder, visited, found);
  if (found.empty() && !fs::exists(folder)) {
    ThrowError(root.string(), "no such folder", "a folder to look for sequences in");
  }
  std::ranges::sort(found, {}, &FoundSequence::folder);
  return found;
}

fs::path NormalFolder(const fs::path& folder) {
  fs::path normal = folder.lexically_normal();
  if (!normal.has_filename()) normal = normal.parent_path();
  const bool named = normal.has_filename() && normal.filename() != "." && normal.filename() != "..";
  if (named && normal.has_parent_path()) return normal;
  normal = fs::absolute(folder).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

Sequence OpenSequence(const SequenceRequest& request) try {
  SequenceRequest resolved = request;
  resolved.folder = NormalFolder(request.folder);
  resolved.type = TypeOf(resolved);
  const SequenceLayout& layout = LayoutOfType(resolved.type);
  CheckSettings(resolved.layout, layout);
  Sequence sequence;
  sequence.folder = resolved.folder;
  sequence.name = resolved.folder.filename().string();
  layout.read(resolved, sequence);
  if (const fs::path import = sequence.folder / "import.json"; fs::exists(import)) {
    for (const Json& note : ReadJson(import).value("notes", Json::array())) {
      if (note.is_string()) sequence.notes.push_back(note.get<std::string>());
    }
  }
  sequence.type = resolved.type;
  sequence.layout = resolved.layout;
  sequence.box_sources = {resolved.labels_file, resolved.detections_file,
                          resolved.detections_camera, resolved.min_score};
  sequence.dataset = IsOfKitti(sequence) ? "kitti" : "other";
  // KITTI names its odometry sequences by number only.
  if (sequence.dataset == "kitti" && sequence.type == kKittiOdometry && IsNumber(sequence.name)) {
    sequence.name.insert(0, "odometry_");
  }
  sequence.camera.right_shift_px = request.right_shift_px.value_or(0.0);
  if (sequence.groundtruth.empty()) sequence.groundtruth = "none";
  sequence.groundtruth_world_from_camera.resize(sequence.images.size());
  CheckCamera(sequence.camera, sequence.folder.string() + ", calibration");
  RefuseImpossible(sequence);
  CutFrames(resolved, sequence);
  PerturbSequence(resolved.perturbation, sequence);
  return sequence;
} catch (const fs::filesystem_error& error) {
  ThrowError(error.path1().string(), error.code().message(), "a folder or file that can be read");
}

}  // namespace cvo
