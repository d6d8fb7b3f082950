// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// Oxford Multimotion as prepared by DynoSAM and VDO-SLAM: image_0/%06d.png, times.txt, a YAML file
// with Camera.*, pose_gt.txt (frame, world_from_camera as a 4 x 4 matrix), object_pose.txt (frame,
// object, position, axis times angle, in the same world) and semantic/*.txt with the object of
// every pixel. These systems use depth in place of right images, which must be added from the
// original release as image_1.

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/calibration/yaml_file.h"
#include "experiments/datasets/body_truth_parts.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/formats/timestamps.h"
#include "experiments/datasets/image_files.h"
#include "experiments/datasets/sequence_layout.h"
#include "experiments/datasets/sequence_parts.h"
#include "experiments/datasets/sequence_type.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct Settings {
  std::string calibration;                         // file name; empty: the only *.yaml
  std::array<double, 3> size_m = {0.3, 0.3, 0.3};  // of every object
  std::map<std::string, std::string> names;        // of the objects, by number

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Added("calibration", self.calibration);
    archive.Added("size_m", self.size_m);
    archive.Added("names", self.names);
  }
};

bool KnowsPrepared(const fs::path& folder) {
  return IsFolder(folder / "image_0") && fs::exists(folder / "pose_gt.txt");
}

bool PreparedHasImages(const fs::path& folder) {
  return AreFolders(folder / "image_0", folder / "image_1");
}

fs::path FindYaml(const fs::path& folder, const std::string& name) {
  if (!name.empty()) return folder / name;
  std::set<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") found.insert(entry.path());
  }
  if (found.size() != 1) {
    ThrowError(folder.string(), StrCat(found.size(), " YAML files"),
               "one, or its name in the layout settings (calibration)");
  }
  return *found.begin();
}

void ReadCamera(const fs::path& path, Sequence& sequence) {
  const YamlMap map = YamlMap::Read(path);
  StereoCamera& camera = sequence.camera;
  for (const auto& [key, size_px] :
       {std::pair("Camera.width", camera.width_px), std::pair("Camera.height", camera.height_px)}) {
    if (map.Has(key) && map.Number(key) != size_px) {
      map.Fail(key, StrCat(map.Number(key)), StrCat(size_px, " px, as the images"));
    }
  }
  for (const char* key : {"Camera.k1", "Camera.k2", "Camera.p1", "Camera.p2"}) {
    if (map.Has(key) && map.Number(key) != 0.0) {
      map.Fail(key, StrCat(map.Number(key)), "0: prepared images are rectified");
    }
  }
  camera.fx = map.Number("Camera.fx");
  camera.fy = map.Number("Camera.fy");
  camera.cx = map.Number("Camera.cx");
  camera.cy = map.Number("Camera.cy");
  camera.baseline_m = map.Number("Camera.baseline");
  camera.Check();
  sequence.other_files.push_back(path);
}

std::size_t FrameOf(const DataRows& rows, std::size_t row, std::size_t frames) {
  const std::int64_t frame = rows.Integer(row, 0);
  if (frame < 0 || frame >= static_cast<std::int64_t>(frames)) {
    rows.Fail(row, StrCat("frame ", frame), StrCat("0 to ", frames - 1));
  }
  return static_cast<std::size_t>(frame);
}

std::vector<std::optional<RigidTransform>> ReadCameraPoses(Sequence& sequence) {
  const fs::path path = sequence.folder / "pose_gt.txt";
  const DataRows rows(path, 17, "frame, 16 numbers of [R t; 0 1]");
  std::vector<std::optional<RigidTransform>> poses(sequence.images.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::optional<RigidTransform>& pose = poses[FrameOf(rows, i, poses.size())];
    if (pose) rows.Fail(i, StrCat("frame ", rows.Text(i, 0), " a second time"), "each once");
    pose = rows.Matrix(i, 1);
  }
  sequence.other_files.push_back(path);
  return poses;
}

BodyTracks ReadObjects(const fs::path& path, const Settings& settings, const Sequence& sequence) {
  const DataRows rows(path, 8, "frame, object, place x y z, axis times angle x y z");
  std::map<int, BodyTrack> bodies;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t frame = FrameOf(rows, i, sequence.images.size());
    if (rows.columns() != 8) {
      rows.Fail(i, StrCat(rows.columns(), " columns"), "8 (10 are of KITTI, not of Multimotion)");
    }
    const auto id = static_cast<int>(rows.Integer(i, 1));
    if (id < 1) rows.Fail(i, StrCat("object ", id), "1 or more");
    BodyTrack& body = bodies[id];
    body.id = id;
    const auto name = settings.names.find(std::to_string(id));
    body.name = name == settings.names.end() ? StrCat("object ", id) : name->second;
    body.category = "Block";
    body.size_m = Eigen::Vector3d(settings.size_m.data());
    body.frames.resize(sequence.images.size());
    if (body.frames[frame]) {
      rows.Fail(i, StrCat("frame ", frame, ", object ", id, " a second time"), "one row");
    }
    body.frames[frame] =
        BodyFrame{RigidTransform(ExpSo3(rows.Vector(i, 5)), rows.Vector(i, 2)), false};
  }
  for (const auto& [number, name] : settings.names) {
    const bool known = std::any_of(bodies.begin(), bodies.end(), [&n = number](const auto& body) {
      return std::to_string(body.first) == n;
    });
    if (!known) ThrowError(path.string(), "no object " + number, "those of the layout settings");
  }
  BodyTracks tracks;
  tracks.visible.by = reports::VisibleBy::kCentre;
  for (auto& [id, body] : bodies) tracks.bodies.push_back(std::move(body));
  return tracks;
}

cv::Mat ReadMask(const fs::path& path, const cv::Size& size) {
  const DataRows rows(path, static_cast<std::size_t>(size.width), "the object of every pixel");
  if (rows.size() != static_cast<std::size_t>(size.height) ||
      rows.columns() != static_cast<std::size_t>(size.width)) {
    ThrowError(path.string(), StrCat(rows.columns(), "x", rows.size(), " numbers"),
               StrCat(size.width, "x", size.height));
  }
  cv::Mat mask(size, CV_16UC1);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      mask.at<std::uint16_t>(v, u) = static_cast<std::uint16_t>(
          rows.Integer(static_cast<std::size_t>(v), static_cast<std::size_t>(u)));
    }
  }
  return mask;
}

void AddObjects(const Settings& settings, Sequence& sequence) {
  const fs::path path = sequence.folder / "object_pose.txt";
  if (!fs::exists(path)) {
    sequence.missing.push_back(path.string() + ": no poses of bodies");
    return;
  }
  sequence.bodies = ReadObjects(path, settings, sequence);
  sequence.other_files.push_back(path);
  const fs::path masks = sequence.folder / "semantic";
  if (!IsFolder(masks)) {
    sequence.missing.push_back(masks.string() + ": no masks, so clustering is not judged");
    return;
  }
  const std::vector<fs::path> files = ListNumberedFiles(masks, {"", ".txt"});
  if (files.size() != sequence.images.size()) {
    ThrowError(masks.string(), StrCat(files.size(), " files"),
               StrCat(sequence.images.size(), ", as many as images"));
  }
  const cv::Size size(sequence.camera.width_px, sequence.camera.height_px);
  sequence.other_files.insert(sequence.other_files.end(), files.begin(), files.end());
  sequence.bodies->mask = [files, size](int frame) {
    return ReadMask(files.at(static_cast<std::size_t>(frame)), size);
  };
}

Sequence ReadPrepared(const SequenceRequest& request) {
  RequireDevkitTruth(request, "Multimotion comes with one set of poses");
  const auto settings = LayoutSettings<Settings>(request);
  Sequence sequence;
  sequence.folder = request.folder;
  sequence.name = request.folder.filename().string();
  if (!IsFolder(request.folder / "image_1")) {
    ThrowError(
        request.folder.string(), "depth in place of right images",
        "image_1: right images of the original release, rectified (a stereo pair is needed)");
  }
  AddPair(request, "colour",
          ListStereoImages(request.folder / "image_0", request.folder / "image_1"), sequence);
  ReadCamera(FindYaml(request.folder, settings.calibration), sequence);
  const fs::path times = request.folder / "times.txt";
  AddTimes(times, ReadSecondsTimes(times), sequence);
  AddObjects(settings, sequence);
  AddCameraTruth(ReadCameraPoses(sequence), sequence);
  StateFramesWithoutTruth("pose_gt.txt has no row of them", sequence);
  AddBoxes(request, sequence);
  return sequence;
}

}  // namespace

SequenceLayout PreparedMultimotionLayout() {
  return {"prepared-multimotion", "image_0, pose_gt.txt, object_pose.txt",
          KnowsPrepared,          PreparedHasImages,
          ReadPrepared,           ToJson(Settings())};
}

}  // namespace cvo
