// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text_file.h"
#include "experiments/calibration/camera_check.h"
#include "experiments/datasets/sequence.h"
#include "experiments/datasets/sequence_layout.h"
#include "experiments/datasets/sequence_parts.h"
#include "experiments/datasets/sequence_type.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKittiDataSet = "kitti";
constexpr const char* kOtherDataSet = "other";

struct Projection {
  double focal_px, cx_px, cy_px;
};

// The rectified cameras of KITTI's five recording days (2011_09_26, 28, 29, 30 and 10_03). The
// odometry, tracking, object and stereo benchmarks are parts of these recordings and have the same
// intrinsics.
constexpr std::array<Projection, 5> kKittiDays = {{{721.5377, 609.5593, 172.8540},
                                                   {707.0493, 604.0814, 180.5066},
                                                   {718.3351, 600.3891, 181.5122},
                                                   {707.0912, 601.8873, 183.1104},
                                                   {718.8560, 607.1928, 185.2157}}};

// The baselines of the grey and the colour pair are both 0.53 to 0.54 m.
bool IsKittiRig(const StereoCamera& camera) {
  const auto near = [](double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
  };
  constexpr double kDigits_px = 1e-4;
  return near(camera.baseline_m, 0.535, 0.01) &&
         std::any_of(kKittiDays.begin(), kKittiDays.end(), [&](const Projection& day) {
           return near(camera.fx, day.focal_px, kDigits_px) &&
                  near(camera.fy, day.focal_px, kDigits_px) &&
                  near(camera.cx, day.cx_px, kDigits_px) && near(camera.cy, day.cy_px, kDigits_px);
         });
}

// Returns Sequence::dataset: the one that was named, else the one whose calibration the sequence
// has. Folder names do not count. Throws Error for an unknown name.
std::string DataSetOf(const Sequence& sequence, const std::string& named) {
  if (named == kKittiDataSet || named == kOtherDataSet) return named;
  if (!named.empty()) {
    ThrowError("option --dataset",
               Quoted(named) + DidYouMean(named, {kKittiDataSet, kOtherDataSet}),
               StrCat(kKittiDataSet, " or ", kOtherDataSet));
  }
  // A rendered scene, or images of the user's own, may have been given KITTI's camera.
  const bool made =
      fs::exists(sequence.folder / "scene.json") || fs::exists(sequence.folder / "import.json");
  return !made && IsKittiRig(sequence.camera) ? kKittiDataSet : kOtherDataSet;
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
  if (IsTrackingSet(folder)) {
    const std::vector<fs::path> sequences = TrackingSequences(folder);
    ThrowError(folder.string(), "a folder of several KITTI tracking sequences",
               sequences.empty() ? "one with images"
                                 : StrCat("one of them, such as ", sequences.front().string()));
  }
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
  Sequence sequence = layout.read(resolved);
  sequence.type = resolved.type;
  sequence.layout = resolved.layout;
  sequence.box_sources = {resolved.labels_file, resolved.detections_file,
                          resolved.detections_camera, resolved.min_score};
  sequence.dataset = DataSetOf(sequence, resolved.dataset);
  // KITTI names its odometry sequences by number only.
  if (sequence.type == kKittiOdometry && sequence.dataset == kKittiDataSet) {
    sequence.name.insert(0, "odometry_");
  }
  sequence.camera.right_shift_px = request.right_shift_px.value_or(0.0);
  if (sequence.groundtruth.empty()) sequence.groundtruth = "none";
  sequence.groundtruth_world_from_camera.resize(sequence.images.size());
  CheckCamera(sequence.camera, sequence.folder.string() + ", calibration");
  CutFrames(resolved, sequence);
  PerturbSequence(resolved.perturbation, sequence);
  return sequence;
} catch (const fs::filesystem_error& error) {
  ThrowError(error.path1().string(), error.code().message(), "a folder or file that can be read");
}

}  // namespace cvo
