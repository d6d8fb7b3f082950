// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// ClusterSLAM's data (SUNCG-*, CARLA-*): images/{left,right}/%04d.png, intrinsic.txt with two
// projection matrices, pose/%04d.txt with the camera in line 0 and cluster k in line k,
// landmarks/{left,right}/%04d.txt with "id u v", and landmark_mapping.txt with "id cluster".

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text_file.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/images.h"
#include "experiments/datasets/sequence.h"
#include "experiments/datasets/sequence_parts.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

struct Settings {
  double rate_hz = 10.0;        // images have no timestamps
  double mover_travel_m = 0.0;  // 0: indoors for SUNCG-*, outdoors for CARLA-*

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Added("rate_hz", self.rate_hz);
    archive.Added("mover_travel_m", self.mover_travel_m);
  }
};

constexpr int kMinLandmarks = 5;  // that a body needs to be judged

bool KnowsClusterSlam(const fs::path& folder) {
  return fs::exists(folder / "landmark_mapping.txt") ||
         (IsFolder(folder / "images/left") && IsFolder(folder / "pose"));
}

bool ClusterSlamHasImages(const fs::path& folder) {
  return AreFolders(folder / "images/left", folder / "images/right");
}

std::string FileOf(std::size_t frame) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "%04zu.txt", frame);
  return name.data();
}

// The data set's web page spells the name in two ways.
fs::path IntrinsicFile(const fs::path& folder) {
  const fs::path other = folder / "instrinsic.txt";
  return fs::exists(other) ? other : folder / "intrinsic.txt";
}

void ReadCamera(Sequence& sequence) {
  constexpr double kRounding_px = 1e-6;
  const fs::path path = IntrinsicFile(sequence.folder);
  const DataRows rows(path, 4, "3 rows of the left projection matrix, then 3 of the right");
  if (rows.size() != 6) {
    ThrowError(path.string(), StrCat(rows.size(), " rows"), "6, of two matrices of 3 x 4");
  }
  // The two matrices differ in the offset of the right camera alone.
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const bool free = i % 3 < 2 && (k == 2 || k == i % 3);
      const double expected = free ? rows.Number(i % 3, k) : i % 3 == 2 && k == 2 ? 1.0 : 0.0;
      if ((i == 3 && k == 3) || std::abs(rows.Number(i, k) - expected) <= kRounding_px) continue;
      rows.Fail(i, StrCat(rows.Text(i, k), " in column ", k + 1),
                StrCat(expected, ": a rectified pair, left camera first"));
    }
  }
  StereoCamera& camera = sequence.camera;
  camera.fx = rows.Number(0, 0);
  camera.fy = rows.Number(1, 1);
  camera.cx = rows.Number(0, 2);
  camera.cy = rows.Number(1, 2);
  camera.baseline_m = -rows.Number(3, 3) / camera.fx;
  if (!(camera.baseline_m > 0.0)) {
    rows.Fail(3, StrCat(rows.Text(3, 3)), "a negative number: the right camera is the second");
  }
  camera.Check();
  sequence.other_files.push_back(path);
}

// Returns value(row) of each row by the id of its landmark.
template <typename Value>
auto ReadById(const DataRows& rows, const Value& value) {
  std::map<std::int64_t, decltype(value(0))> by_id;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::int64_t id = rows.Integer(i, 0);
    if (!by_id.emplace(id, value(i)).second) {
      rows.Fail(i, StrCat("landmark ", id, " a second time"), "each once");
    }
  }
  return by_id;
}

std::map<std::int64_t, Eigen::Vector2d> ReadLandmarks(const fs::path& path) {
  const DataRows rows(path, 3, "id u v");
  return ReadById(
      rows, [&](std::size_t i) { return Eigen::Vector2d(rows.Number(i, 1), rows.Number(i, 2)); });
}

std::map<std::int64_t, int> ReadMapping(const fs::path& path, std::size_t clusters) {
  const DataRows rows(path, 2, "landmark, cluster");
  return ReadById(rows, [&](std::size_t i) {
    const std::int64_t cluster = rows.Integer(i, 1);
    if (cluster < 0 || cluster > static_cast<std::int64_t>(clusters)) {
      rows.Fail(i, StrCat("cluster ", cluster), StrCat("0 to ", clusters, ", as in pose/"));
    }
    return static_cast<int>(cluster);
  });
}

// [frame][0] is the camera, [frame][k] is cluster k.
using Poses = std::vector<std::vector<RigidTransform>>;

Poses ReadPoses(const std::vector<fs::path>& files, bool w_first) {
  Poses poses;
  for (const fs::path& file : files) {
    const DataRows rows(file, 7, "position and quaternion of the camera, then of each cluster");
    if (!poses.empty() && rows.size() != poses.front().size()) {
      ThrowError(file.string(), StrCat(rows.size(), " rows"),
                 StrCat(poses.front().size(), ", as in ", files.front().string()));
    }
    std::vector<RigidTransform>& frame = poses.emplace_back();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      frame.emplace_back(rows.Quaternion(i, 3, w_first), rows.Vector(i, 0));
    }
  }
  return poses;
}

// An observation of a landmark of the static scene, with its point in the camera.
struct Seen {
  std::size_t frame;
  std::int64_t id;
  Eigen::Vector3d p_in_camera;
};

// Returns how far landmarks of the static scene move in the world between consecutive observations,
// relative to their depth (median). Zero for true poses.
double Drift(const std::vector<Seen>& all, const Poses& poses) {
  std::map<std::int64_t, const Seen*> last;
  std::vector<double> drifts;
  for (const Seen& seen : all) {
    const Seen*& before = last[seen.id];
    if (before != nullptr && before->frame != seen.frame) {
      const Eigen::Vector3d a = poses[before->frame][0] * before->p_in_camera;
      const Eigen::Vector3d b = poses[seen.frame][0] * seen.p_in_camera;
      drifts.push_back((a - b).norm() / seen.p_in_camera.z());
    }
    before = &seen;
  }
  return drifts.empty() ? 0.0 : Median(std::move(drifts));
}

// Either order gives unit quaternions, and sources disagree. The landmarks decide.
Poses ChoosePoses(const std::vector<fs::path>& files, const std::vector<Seen>& seen,
                  Sequence& sequence) {
  constexpr double kStill = 0.02;  // fraction of the depth
  constexpr double kClear = 0.5;   // fraction of the drift with the other order
  Poses w_first = ReadPoses(files, true);
  Poses w_last = ReadPoses(files, false);
  const double drift_first = Drift(seen, w_first);
  const double drift_last = Drift(seen, w_last);
  const double least = std::min(drift_first, drift_last);
  if (least > kStill) {
    ThrowError(files.front().parent_path().string(),
               StrCat("poses by which landmarks of the static scene move by ", 100.0 * least,
                      " % of their depth from frame to frame, in either order of quaternions"),
               "poses of the camera in the world (x right, y down, z ahead)");
  }
  if (least >= kClear * std::max(drift_first, drift_last)) {
    sequence.missing.emplace_back("landmarks that tell the order of quaternions: w x y z is taken");
    return w_first;
  }
  return drift_first < drift_last ? w_first : w_last;
}

struct Observations {
  std::vector<std::vector<LabelledPixel>> pixels;  // [frame], of the left image
  std::vector<std::vector<int>> counts;            // [frame][cluster]
  std::vector<Seen> still;
};

Observations ReadObservations(const std::map<std::int64_t, int>& cluster_of, std::size_t clusters,
                              Sequence& sequence) {
  Observations all;
  for (std::size_t frame = 0; frame < sequence.images.size(); ++frame) {
    const fs::path left_file = sequence.folder / "landmarks/left" / FileOf(frame);
    const fs::path right_file = sequence.folder / "landmarks/right" / FileOf(frame);
    const auto left = ReadLandmarks(left_file);
    const auto right = ReadLandmarks(right_file);
    sequence.other_files.insert(sequence.other_files.end(), {left_file, right_file});
    all.pixels.emplace_back();
    all.counts.emplace_back(clusters + 1, 0);
    for (const auto& [id, at_px] : left) {
      const auto cluster = cluster_of.find(id);
      if (cluster == cluster_of.end()) continue;
      all.pixels.back().push_back({at_px, cluster->second});
      ++all.counts.back()[static_cast<std::size_t>(cluster->second)];
      const auto other = right.find(id);
      if (cluster->second != 0 || other == right.end()) continue;
      const auto p = sequence.camera.BackProject({at_px.x(), at_px.y(), other->second.x()});
      if (p) all.still.push_back({frame, id, *p});
    }
  }
  return all;
}

// Adds boxes around the landmarks of each cluster as labels. These are boxes of an oracle, as the
// data has none.
void AddBoxesOfLandmarks(const Observations& observed, const std::string& category,
                         Sequence& sequence) {
  for (std::size_t frame = 0; frame < observed.pixels.size(); ++frame) {
    std::map<int, ObjectBox> boxes;
    for (const LabelledPixel& pixel : observed.pixels[frame]) {
      const auto cluster = static_cast<std::size_t>(pixel.body);
      if (cluster == 0 || observed.counts[frame][cluster] < kMinLandmarks) continue;
      const double u = pixel.at_px.x();
      const double v = pixel.at_px.y();
      const auto [box, is_new] = boxes.try_emplace(pixel.body);
      ObjectBox& of = box->second;
      of.left_px = is_new ? u : std::min(of.left_px, u);
      of.right_px = is_new ? u : std::max(of.right_px, u);
      of.top_px = is_new ? v : std::min(of.top_px, v);
      of.bottom_px = is_new ? v : std::max(of.bottom_px, v);
    }
    for (auto& [cluster, box] : boxes) {
      box.frame = static_cast<int>(frame);
      box.track = cluster;
      box.type = category;
      sequence.labels.push_back(std::move(box));
    }
  }
}

void AddTruth(const Settings& settings, Sequence& sequence) {
  std::vector<fs::path> files;
  for (const auto& [number, file] : NumberedFiles(sequence.folder / "pose", ".txt")) {
    if (number == static_cast<std::int64_t>(files.size())) files.push_back(file);
  }
  const fs::path folder = sequence.folder / "pose";
  const auto of_images = OfImages(files, folder.string() + ": files", sequence);
  if (!of_images) FailTooFew(folder, StrCat(files.size(), " files"), sequence);
  files = *of_images;
  sequence.other_files.insert(sequence.other_files.end(), files.begin(), files.end());
  const std::size_t clusters = ReadPoses({files.front()}, true).front().size() - 1;
  const fs::path mapping = sequence.folder / "landmark_mapping.txt";
  Observations observed;
  observed.counts.assign(files.size(), std::vector<int>(clusters + 1, kMinLandmarks));
  if (fs::exists(mapping)) {
    sequence.other_files.push_back(mapping);
    observed = ReadObservations(ReadMapping(mapping, clusters), clusters, sequence);
  } else {
    sequence.missing.push_back(mapping.string() + ": clustering is not judged");
  }
  const bool street = sequence.name.starts_with("CARLA");
  const std::string category = street ? "Car" : "Block";
  AddBoxesOfLandmarks(observed, category, sequence);
  const Poses poses = ChoosePoses(files, observed.still, sequence);
  BodyTracks tracks;
  ObjectTruth& truth = tracks.objects;
  truth.contract.truth = reports::TruthSource::kOfficial;
  truth.contract.visible = reports::Visibility{reports::VisibleBy::kLandmarks, 0, kMinLandmarks};
  truth.mover_travel_m = settings.mover_travel_m > 0.0 ? settings.mover_travel_m
                         : street                      ? kOutdoorTravel_m
                                                       : kIndoorTravel_m;
  tracks.pixels = std::move(observed.pixels);
  std::vector<std::optional<RigidTransform>> cameras;
  for (const auto& frame : poses) cameras.emplace_back(frame[0]);
  for (std::size_t k = 1; k <= clusters; ++k) {
    const int id = static_cast<int>(k);
    TruthBody body{id, id, StrCat("cluster ", k), category, Eigen::Vector3d::Ones(), {}};
    for (std::size_t i = 0; i < poses.size(); ++i) {
      body.frames.push_back(BodyFrame{poses[i][k], observed.counts[i][k] >= kMinLandmarks});
    }
    truth.bodies.push_back(std::move(body));
  }
  if (clusters > 0) sequence.bodies = std::move(tracks);
  AddCameraTruth(std::move(cameras), sequence);
}

void ReadClusterSlam(const SequenceRequest& request, Sequence& sequence) {
  const auto settings = LayoutSettings<Settings>(request);
  if (!(settings.rate_hz > 0.0)) {
    ThrowError("layout settings, rate_hz", StrCat(settings.rate_hz), "a positive number");
  }
  AddPair(request, "colour",
          ListStereoImages(request.folder / "images/left", request.folder / "images/right"),
          sequence);
  sequence.timestamps_ns = NominalTimes(sequence.images.size(), settings.rate_hz);
  sequence.is_rate_assumed = !request.layout.contains("rate_hz");
  ReadCamera(sequence);
  if (IsFolder(request.folder / "pose")) {
    AddTruth(settings, sequence);
  } else {
    sequence.missing.push_back((request.folder / "pose").string() +
                               ": no ground truth of camera and bodies");
  }
  AddBoxes(request, sequence);
}

}  // namespace

SequenceLayout ClusterslamLayout() {
  return {"clusterslam", KnowsClusterSlam, ClusterSlamHasImages, ReadClusterSlam,
          ToJson(Settings())};
}

}  // namespace cvo
