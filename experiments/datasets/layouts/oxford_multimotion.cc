// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// Oxford Multimotion, original release: <segment>/stereo/%06d_{left,right}.png with stereo.csv,
// <segment>/vicon.csv with the poses of the apparatus and of every body, and calibrations
// kalibr*.yaml (or manufacturer*.yaml) and vicon*.yaml in the segment or above.

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text_file.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/calibration/rig_file.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/sequence.h"
#include "experiments/datasets/sequence_parts.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// MultimotionSettings of a body, found by its name in vicon.csv.
struct BodySettings {
  std::string name;  // displayed name; empty: that of vicon.csv
  std::array<double, 3> size_m = {0.3, 0.3, 0.3};

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Added("name", self.name);
    archive.Added("size_m", self.size_m);
  }
};

struct MultimotionSettings {
  std::string calibration;    // file name; empty: kalibr*.yaml
  std::string left = "cam0";  // key of the left camera in this file
  std::string right = "cam1";
  std::string vicon_calibration;  // file name; empty: vicon*.yaml
  std::string apparatus = "sensor_payload";
  std::map<std::string, BodySettings> bodies;  // by name in vicon.csv; empty: all others
  double clock_offset_s = 0.0;                 // time of Vicon minus time of an image

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Added("calibration", self.calibration);
    archive.Added("left", self.left);
    archive.Added("right", self.right);
    archive.Added("vicon_calibration", self.vicon_calibration);
    archive.Added("apparatus", self.apparatus);
    archive.Added("bodies", self.bodies);
    archive.Added("clock_offset_s", self.clock_offset_s);
  }
};

bool KnowsMultimotion(const fs::path& folder) {
  return fs::exists(folder / "stereo/stereo.csv") ||
         (IsFolder(folder / "stereo") && fs::exists(folder / "vicon.csv"));
}

bool MultimotionHasImages(const fs::path& folder) { return IsFolder(folder / "stereo"); }

// Looks in the segment and the two folders above it, as archives may be unpacked.
fs::path FindCalibration(const fs::path& segment, const std::string& name, const char* begin) {
  fs::path folder = segment;
  for (int i = 0; i < 3; ++i, folder = folder.parent_path()) {
    if (!name.empty() && fs::exists(folder / name)) return folder / name;
    if (!name.empty()) continue;
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string file = entry.path().filename().string();
      if (file.starts_with(begin) && file.ends_with(".yaml")) found.push_back(entry.path());
    }
    if (found.size() > 1) {
      std::sort(found.begin(), found.end());
      ThrowError(folder.string(),
                 StrCat(found[0].filename().string(), " and ", found[1].filename().string()),
                 StrCat("one ", begin, "*.yaml, or its name in the layout settings"));
    }
    if (found.size() == 1) return found.front();
  }
  ThrowError(segment.string(), name.empty() ? StrCat("no ", begin, "*.yaml") : "no " + name,
             "the calibration of the data set there or in one of the two folders above");
}

void AddListedImages(const SequenceRequest& request, Sequence& sequence) {
  const fs::path stereo = sequence.folder / "stereo";
  const DataRows rows(stereo / "stereo.csv", 3, "frame, time in seconds, nanoseconds");
  std::vector<StereoPaths> pairs;
  std::vector<std::int64_t> times_ns;
  std::optional<std::int64_t> last;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::int64_t number = rows.Integer(i, 0);
    if (number < 0 || number > 999'999 || (last && number != *last + 1)) {
      rows.Fail(i, StrCat("frame ", number),
                last ? StrCat("frame ", *last + 1, ", the one after the row before")
                     : "a frame of six digits");
    }
    last = number;
    const std::int64_t time_ns = rows.SecondsAndNs(i, 1);
    CheckLater(rows, i, time_ns, i > 0 ? std::optional(times_ns.back()) : std::nullopt,
               "the images");
    times_ns.push_back(time_ns);
    std::array<char, 16> digits{};
    std::snprintf(digits.data(), digits.size(), "%06d", static_cast<int>(number));
    pairs.push_back({stereo / StrCat(digits.data(), "_left.png"),
                     stereo / StrCat(digits.data(), "_right.png")});
  }
  // The rows after the last image are left out, as of a part of the recording.
  while (pairs.size() > 1 && !fs::exists(pairs.back().left) && !fs::exists(pairs.back().right)) {
    pairs.pop_back();
  }
  AddPair(request, "colour", CheckedImages(std::move(pairs)), sequence);
  AddTimes(stereo / "stereo.csv", std::move(times_ns), sequence);
}

// Reads world_from_object of all objects, whose rows are interleaved. Checks the quaternion against
// the matrix in the same row, if there is one, which verifies the quaternion's order.
std::map<std::string, Trajectory> ReadVicon(const fs::path& path) {
  constexpr std::size_t kWithMatrix = 26;
  constexpr double kSame_rad = 0.05;
  const DataRows rows(path, 10, "seconds, nanoseconds, object, quaternion x y z w, position x y z");
  std::map<std::string, Trajectory> tracks;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string name(rows.Text(i, 2));
    if (name.empty()) rows.Fail(i, "no name of an object", "one in the third column");
    Trajectory& track = tracks[name];
    const std::int64_t time_ns = rows.SecondsAndNs(i, 0);
    CheckLater(rows, i, time_ns,
               track.empty() ? std::nullopt : std::optional(track.back().timestamp_ns), name);
    const RigidTransform pose(rows.Quaternion(i, 3, false), rows.Vector(i, 7));
    if (rows.columns() >= kWithMatrix) {
      const RigidTransform matrix = rows.Matrix(i, 10);
      const double apart_rad = RotationAngle(matrix.rotation().conjugate() * pose.rotation());
      if (apart_rad > kSame_rad) {
        rows.Fail(i, StrCat("a quaternion ", apart_rad, " rad from the matrix beside it"),
                  "the same rotation (quaternion x y z w, matrix row by row)");
      }
    }
    track.push_back({time_ns, pose});
  }
  return tracks;
}

const Trajectory& Find(const std::map<std::string, Trajectory>& tracks, const std::string& name,
                       const fs::path& path) {
  const auto found = tracks.find(name);
  if (found != tracks.end()) return found->second;
  const std::string names = Joined(tracks, ", ", [](const auto& track) { return track.first; });
  ThrowError(path.string(), names, "object " + Quoted(name) + " of the layout settings");
}

void AddMultimotionTruth(const MultimotionSettings& settings, Sequence& sequence) {
  const fs::path path = sequence.folder / "vicon.csv";
  if (!fs::exists(path)) {
    sequence.missing.push_back(path.string() + ": no ground truth of camera and bodies");
    return;
  }
  const fs::path calibration =
      FindCalibration(sequence.folder, settings.vicon_calibration, "vicon");
  const RigidTransform apparatus_from_left =
      YamlMap::Read(calibration).Transform("T_apparatus_left");
  const std::map<std::string, Trajectory> tracks = ReadVicon(path);
  sequence.other_files.insert(sequence.other_files.end(), {path, calibration});
  std::map<std::string, BodySettings> bodies = settings.bodies;
  if (bodies.empty()) {
    for (const auto& [name, track] : tracks) {
      if (name != settings.apparatus) bodies[name] = {};
    }
  }
  ObjectTruth truth;
  truth.contract.truth = reports::TruthSource::kOfficial;
  truth.contract.visible = reports::Visibility{.by = reports::VisibleBy::kCentre};
  truth.mover_travel_m = kIndoorTravel_m;
  for (const auto& [name, body] : bodies) {
    Find(tracks, name, path);
    truth.bodies.push_back({static_cast<int>(truth.bodies.size()) + 1,
                            -1,
                            body.name.empty() ? name : body.name,
                            "Block",
                            Eigen::Vector3d(body.size_m.data()),
                            {}});
  }
  const auto offset_ns = static_cast<std::int64_t>(std::llround(1e9 * settings.clock_offset_s));
  for (const std::int64_t image_ns : sequence.timestamps_ns) {
    std::size_t i = 0;
    for (const auto& [name, body] : bodies) {
      const std::optional<RigidTransform> pose =
          InterpolatePose(tracks.at(name), image_ns + offset_ns);
      truth.bodies[i++].frames.push_back(pose ? std::optional(BodyFrame{*pose, false})
                                              : std::nullopt);
    }
  }
  if (!bodies.empty()) sequence.bodies = BodyTracks{std::move(truth), {}, {}};
  Trajectory apparatus = Find(tracks, settings.apparatus, path);
  for (TimedPose& pose : apparatus) pose.timestamp_ns -= offset_ns;
  AddCameraTruth(apparatus, apparatus_from_left, "Vicon starts later or ends earlier", sequence);
}

void ReadMultimotion(const SequenceRequest& request, Sequence& sequence) {
  const auto settings = LayoutSettings<MultimotionSettings>(request);
  AddListedImages(request, sequence);
  const fs::path calibration = FindCalibration(request.folder, settings.calibration, "kalibr");
  AddRig(ReadKalibrRig(calibration, settings.left, settings.right), calibration, sequence);
  AddMultimotionTruth(settings, sequence);
  AddBoxes(request, sequence);
}

}  // namespace

SequenceLayout OxfordMultimotionLayout() {
  return {"oxford-multimotion", KnowsMultimotion, MultimotionHasImages, ReadMultimotion,
          ToJson(MultimotionSettings())};
}

}  // namespace cvo
