// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// Virtual KITTI 2: images in <..._rgb>/SceneXX/<variation>/frames/rgb/Camera_{0,1}/rgb_%05d.jpg.
// <..._textgt>/SceneXX/<variation> contains the tables extrinsic, intrinsic, pose, bbox and info;
// <..._instanceSegmentation>/SceneXX/<variation>/frames contains the masks. All archives may be
// unpacked into one folder.

#include <array>
#include <cstdio>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/formats/image_format.h"
#include "experiments/datasets/sequence.h"
#include "experiments/datasets/sequence_parts.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct Settings {
  double mover_travel_m = kOutdoorTravel_m;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Added("mover_travel_m", self.mover_travel_m);
  }
};

bool KnowsVirtualKitti(const fs::path& folder) {
  return IsFolder(folder / "frames/rgb/Camera_0") || IsFolder(folder / "frames/rgb/Camera_1");
}

bool VirtualKittiHasImages(const fs::path& folder) {
  return AreFolders(folder / "frames/rgb/Camera_0", folder / "frames/rgb/Camera_1");
}

// Returns the folder of the sequence in another archive: `folder` itself if it contains `below`,
// else the one in which "_rgb" is replaced, such as ..._textgt/SceneXX/<variation>.
fs::path FolderOf(const fs::path& folder, const std::string& archive, const fs::path& below) {
  if (fs::exists(folder / below)) return folder;
  fs::path other;
  for (const fs::path& part : folder) {
    std::string name = part.string();
    if (name.ends_with("_rgb")) name.replace(name.size() - 3, 3, archive);
    other /= name;
  }
  return other;
}

// Frame and camera of a row, from its first two columns.
struct Place {
  int frame;
  int camera;
};
Place PlaceOf(const DataRows& rows, std::size_t row, std::size_t frames) {
  const std::int64_t frame = rows.Integer(row, 0);
  const std::int64_t camera = rows.Integer(row, 1);
  if (frame < 0 || frame >= static_cast<std::int64_t>(frames) || camera < 0 || camera > 1) {
    rows.Fail(row, StrCat("frame ", frame, ", camera ", camera),
              StrCat("frame 0 to ", frames - 1, ", camera 0 or 1"));
  }
  return {static_cast<int>(frame), static_cast<int>(camera)};
}

// Returns the rows as [camera][frame]. The file must have one row for each, in any order.
std::array<std::vector<std::size_t>, 2> RowsByPlace(const DataRows& rows, const fs::path& path,
                                                    std::size_t frames) {
  std::array<std::vector<std::size_t>, 2> found;
  found.fill(std::vector<std::size_t>(frames, rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Place place = PlaceOf(rows, i, frames);
    std::size_t& row =
        found[static_cast<std::size_t>(place.camera)][static_cast<std::size_t>(place.frame)];
    if (row != rows.size()) {
      rows.Fail(i, StrCat("frame ", place.frame, ", camera ", place.camera, " a second time"),
                "one row for each");
    }
    row = i;
  }
  for (std::size_t camera = 0; camera < 2; ++camera) {
    for (std::size_t frame = 0; frame < frames; ++frame) {
      if (found[camera][frame] != rows.size()) continue;
      ThrowError(path.string(), StrCat("no row of frame ", frame, ", camera ", camera),
                 StrCat("one for each of ", frames, " frames and both cameras"));
    }
  }
  return found;
}

void ReadCamera(const fs::path& text, Sequence& sequence) {
  const fs::path path = text / "intrinsic.txt";
  const DataRows rows(path, 6, "frame, camera, fx, fy, cx, cy");
  const auto found = RowsByPlace(rows, path, sequence.images.size());
  const std::size_t first = found[0][0];
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t column = 2; column < 6; ++column) {
      if (rows.Number(i, column) == rows.Number(first, column)) continue;
      rows.Fail(i, StrCat(rows.Text(i, column)),
                StrCat(rows.Text(first, column), ", as in frame 0 of camera 0"));
    }
  }
  sequence.camera.fx = rows.Number(first, 2);
  sequence.camera.fy = rows.Number(first, 3);
  sequence.camera.cx = rows.Number(first, 4);
  sequence.camera.cy = rows.Number(first, 5);
  sequence.other_files.push_back(path);
}

// Reads left_from_world of camera 0, and the baseline from the poses of camera 1.
std::vector<RigidTransform> ReadPoses(const fs::path& text, Sequence& sequence) {
  constexpr double kRounding = 1e-3;
  const fs::path path = text / "extrinsic.txt";
  const DataRows rows(path, 18, "frame, camera, 16 numbers of [R t; 0 1]");
  const auto found = RowsByPlace(rows, path, sequence.images.size());
  std::vector<RigidTransform> left_from_world;
  double baseline_m = 0.0;
  for (std::size_t i = 0; i < found[0].size(); ++i) {
    left_from_world.push_back(rows.Matrix(found[0][i], 2));
    const RigidTransform right_from_left =
        rows.Matrix(found[1][i], 2) * left_from_world.back().Inverse();
    const Eigen::Vector3d t = right_from_left.translation();
    if (i == 0) baseline_m = -t.x();
    if (!(t.x() < 0.0) || std::abs(t.x() + baseline_m) > kRounding ||
        t.tail<2>().norm() > kRounding || RotationAngle(right_from_left.rotation()) > kRounding) {
      rows.Fail(found[1][i],
                StrCat("camera 1 at ", -t.x(), ", ", -t.y(), ", ", -t.z(), " m in camera 0"),
                i == 0 ? "to the right of camera 0, without a turn"
                       : StrCat("at ", baseline_m, ", 0, 0, as in frame 0"));
    }
  }
  sequence.camera.baseline_m = baseline_m;
  sequence.camera.Check();
  sequence.other_files.push_back(path);
  return left_from_world;
}

Eigen::Quaterniond Turn(const Eigen::Vector3d& yxz_rad, bool y_first) {
  const Eigen::Quaterniond y = ExpSo3(yxz_rad[0] * Eigen::Vector3d::UnitY());
  const Eigen::Quaterniond x = ExpSo3(yxz_rad[1] * Eigen::Vector3d::UnitX());
  const Eigen::Quaterniond z = ExpSo3(yxz_rad[2] * Eigen::Vector3d::UnitZ());
  return y_first ? y * x * z : z * y * x;
}

// Reads world_from_object. Sources disagree on the order of the rotations; the right one is that in
// which the pose in the world agrees with the one in the camera.
RigidTransform ReadPose(const DataRows& rows, std::size_t row,
                        const RigidTransform& left_from_world) {
  constexpr double kSame_m = 0.05;
  constexpr double kSame_rad = 0.02;
  const Eigen::Vector3d at = left_from_world * rows.Vector(row, 7);
  const double apart_m = (at - rows.Vector(row, 13)).norm();
  if (apart_m > kSame_m) {
    rows.Fail(row, StrCat("a place in the camera ", apart_m, " m from that in the world"),
              "the same place by extrinsic.txt");
  }
  double least_rad = 10.0;
  for (const bool y_first : {true, false}) {
    const RigidTransform world_from_object(Turn(rows.Vector(row, 10), y_first),
                                           rows.Vector(row, 7));
    const Eigen::Quaterniond in_camera = Turn(rows.Vector(row, 16), y_first);
    const double apart_rad = RotationAngle(
        in_camera.conjugate() * (left_from_world.rotation() * world_from_object.rotation()));
    if (apart_rad < kSame_rad) return world_from_object;
    least_rad = std::min(least_rad, apart_rad);
  }
  rows.Fail(row, StrCat("turns in world and camera ", least_rad, " rad apart"),
            "angles y, x, z of Ry Rx Rz or Rz Ry Rx");
}

std::map<int, std::string> ReadCategories(const fs::path& path) {
  const DataRows rows(path, 2, "track, label");
  std::map<int, std::string> categories;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto track = static_cast<int>(rows.Integer(i, 0));
    if (!categories.emplace(track, rows.Text(i, 1)).second) {
      rows.Fail(i, StrCat("track ", track, " a second time"), "each once");
    }
  }
  return categories;
}

// Number of pixels of each body, by frame and track. ReadBoxes also adds the boxes of camera 0.
using Pixels = std::map<std::pair<int, int>, int>;
Pixels ReadBoxes(const fs::path& text, const std::map<int, std::string>& categories,
                 Sequence& sequence) {
  const fs::path path = text / "bbox.txt";
  const DataRows rows(path, 8, "frame, camera, track, left, right, top, bottom, pixels");
  Pixels pixels;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Place place = PlaceOf(rows, i, sequence.images.size());
    const auto track = static_cast<int>(rows.Integer(i, 2));
    const auto category = categories.find(track);
    if (category == categories.end()) {
      rows.Fail(i, StrCat("track ", track), "one of those in info.txt");
    }
    ObjectBox box;
    box.frame = place.frame;
    box.track = track;
    box.type = category->second;
    box.left_px = rows.Number(i, 3);
    box.right_px = rows.Number(i, 4);
    box.top_px = rows.Number(i, 5);
    box.bottom_px = rows.Number(i, 6);
    if (box.right_px < box.left_px || box.bottom_px < box.top_px) {
      rows.Fail(i, "a box with right < left or bottom < top", "left, right, top, bottom");
    }
    if (place.camera != 0) continue;
    if (!pixels.emplace(std::pair(place.frame, track), static_cast<int>(rows.Number(i, 7)))
             .second) {
      rows.Fail(i, StrCat("frame ", place.frame, ", track ", track, " a second time"), "one row");
    }
    sequence.labels.push_back(std::move(box));
  }
  sequence.other_files.push_back(path);
  return pixels;
}

void ReadBodies(const fs::path& text, const std::vector<RigidTransform>& left_from_world,
                const Settings& settings, Sequence& sequence) {
  constexpr int kMinVisible_px = 400;
  const std::map<int, std::string> categories = ReadCategories(text / "info.txt");
  const Pixels pixels = ReadBoxes(text, categories, sequence);
  const fs::path path = text / "pose.txt";
  const DataRows rows(
      path, 19,
      "frame, camera, track, alpha, width, height, length, place and turns y x z in "
      "world, the same in the camera");
  BodyTracks tracks;
  tracks.visible = {reports::VisibleBy::kMask, kMinVisible_px, 0};
  tracks.mover_travel_m = settings.mover_travel_m;
  std::map<int, BodyTrack> bodies;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Place place = PlaceOf(rows, i, sequence.images.size());
    if (place.camera != 0) continue;
    const auto track = static_cast<int>(rows.Integer(i, 2));
    const auto category = categories.find(track);
    if (category == categories.end()) {
      rows.Fail(i, StrCat("track ", track), "one of those in info.txt");
    }
    BodyTrack& body = bodies[track];
    body.id = track + 1;
    body.track = track;
    body.name = StrCat("track ", track);
    body.category = category->second;
    body.size_m = {rows.Number(i, 6), rows.Number(i, 5), rows.Number(i, 4)};
    body.frames.resize(sequence.images.size());
    const auto frame = static_cast<std::size_t>(place.frame);
    if (body.frames[frame]) {
      rows.Fail(i, StrCat("frame ", place.frame, ", track ", track, " a second time"), "one row");
    }
    // Moves the origin from the centre of the bottom face to that of the box: y is down.
    const RigidTransform bottom_from_centre(Eigen::Quaterniond::Identity(),
                                            Eigen::Vector3d(0.0, -0.5 * body.size_m.y(), 0.0));
    const auto seen = pixels.find({place.frame, track});
    body.frames[frame] = BodyFrame{ReadPose(rows, i, left_from_world[frame]) * bottom_from_centre,
                                   seen != pixels.end() && seen->second >= kMinVisible_px};
  }
  for (auto& [track, body] : bodies) tracks.bodies.push_back(std::move(body));
  sequence.other_files.insert(sequence.other_files.end(), {path, text / "info.txt"});
  sequence.bodies = std::move(tracks);
}

void AddMasks(const fs::path& folder, Sequence& sequence) {
  const fs::path below = "frames/instanceSegmentation/Camera_0";
  const fs::path masks = FolderOf(folder, "instanceSegmentation", below) / below;
  if (!IsFolder(masks)) {
    sequence.missing.push_back(masks.string() + ": no masks, so clustering is not judged");
    return;
  }
  const auto file_of = [masks](int frame) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "instancegt_%05d.png", frame);
    return masks / name.data();
  };
  for (std::size_t i = 0; i < sequence.images.size(); ++i) {
    const fs::path file = file_of(static_cast<int>(i));
    if (fs::exists(file)) sequence.other_files.push_back(file);
  }
  const cv::Size size(sequence.camera.width_px, sequence.camera.height_px);
  sequence.bodies->mask = [file_of, size](int frame) {
    return ReadPaletteIndexes(file_of(frame), size);
  };
}

void ReadVirtualKitti(const SequenceRequest& request, Sequence& sequence) {
  sequence.name.insert(0, request.folder.parent_path().filename().string() + "_");
  const fs::path images = request.folder / "frames/rgb";
  AddPair(request, "colour",
          ListStereoImages(images / "Camera_0", images / "Camera_1", {"rgb_", ".jpg"}), sequence);
  sequence.timestamps_ns = NominalTimes(sequence.images.size());
  sequence.is_rate_assumed = true;
  const fs::path text = FolderOf(request.folder, "textgt", "extrinsic.txt");
  ReadCamera(text, sequence);
  const std::vector<RigidTransform> left_from_world = ReadPoses(text, sequence);
  std::vector<std::optional<RigidTransform>> poses;
  for (const RigidTransform& pose : left_from_world) poses.emplace_back(pose.Inverse());
  if (fs::exists(text / "pose.txt")) {
    ReadBodies(text, left_from_world, LayoutSettings<Settings>(request), sequence);
    AddMasks(request.folder, sequence);
  } else {
    sequence.missing.push_back((text / "pose.txt").string() + ": no poses of bodies");
  }
  AddCameraTruth(std::move(poses), sequence);
  AddBoxes(request, sequence);
}

}  // namespace

SequenceLayout VirtualKittiLayout() {
  return {"virtual-kitti",
          KnowsVirtualKitti,
          VirtualKittiHasImages,
          ReadVirtualKitti,
          "Virtual KITTI has no other",
          ToJson(Settings())};
}

}  // namespace cvo
