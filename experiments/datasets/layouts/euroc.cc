// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// EuRoC in the ASL format: mav0/cam0 and cam1 with data/<ns>.png, data.csv and sensor.yaml, and the
// ground truth of the body in mav0/state_groundtruth_estimate0/data.csv. Images are not rectified.

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/datasets/calibration/rig_file.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/sequence.h"
#include "experiments/datasets/sequence_parts.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Returns the folder with the cameras: mav0 in `folder` if there is one, else `folder` itself.
fs::path MavFolder(const fs::path& folder) {
  return IsFolder(folder / "mav0") ? folder / "mav0" : folder;
}

bool KnowsEuroc(const fs::path& folder) {
  const fs::path mav = MavFolder(folder);
  return fs::exists(mav / "cam0/data.csv") || fs::exists(mav / "cam0/sensor.yaml");
}

bool EurocHasImages(const fs::path& folder) {
  return AreFolders(MavFolder(folder) / "cam0/data", MavFolder(folder) / "cam1/data");
}

struct Camera {
  Times times_ns;
  std::vector<fs::path> files;
};

Camera ReadCamera(const fs::path& folder, Sequence& sequence) {
  const fs::path list = folder / "data.csv";
  const DataRows rows(list, 2, "time in ns, file name");
  sequence.other_files.push_back(list);
  Camera camera;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::int64_t time_ns = rows.Integer(i, 0);
    CheckLater(rows, i, time_ns, i > 0 ? std::optional(camera.times_ns.back()) : std::nullopt,
               folder.filename().string());
    camera.times_ns.push_back(time_ns);
    camera.files.push_back(folder / "data" / rows.Text(i, 1));
    if (!fs::is_regular_file(camera.files.back())) {
      rows.Fail(i, "no image " + camera.files.back().string(), "one for each row");
    }
  }
  return camera;
}

// Some sequences lack an image of one of the cameras.
std::vector<StereoPaths> PairImages(const fs::path& mav, Sequence& sequence) {
  const Camera left = ReadCamera(mav / "cam0", sequence);
  const Camera right = ReadCamera(mav / "cam1", sequence);
  std::vector<StereoPaths> pairs;
  for (const auto& [i, j] :
       PairByTime(left.times_ns, right.times_ns, mav / "cam1/data.csv", sequence.missing)) {
    pairs.push_back({left.files[i], right.files[j]});
    sequence.timestamps_ns.push_back(left.times_ns[i]);
  }
  return pairs;
}

void AddTruth(const fs::path& mav, Sequence& sequence) {
  const fs::path path = mav / "state_groundtruth_estimate0/data.csv";
  if (!fs::exists(path)) {
    sequence.missing.push_back(path.string() + ": no ground truth of the camera");
    return;
  }
  const Trajectory body = ReadTrajectory(path).poses;
  sequence.other_files.push_back(path);
  const RigidTransform body_from_left = YamlMap::Read(mav / "cam0/sensor.yaml").Transform("T_BS");
  AddCameraTruth(body, body_from_left, "it starts later or ends earlier", sequence);
}

void ReadEuroc(const SequenceRequest& request, Sequence& sequence) {
  if (sequence.name == "mav0") sequence.name = request.folder.parent_path().filename().string();
  const fs::path mav = MavFolder(request.folder);
  AddPair(request, "grey", CheckedImages(PairImages(mav, sequence)), sequence);
  const fs::path right = mav / "cam1/sensor.yaml";
  AddRig(ReadSensorRig(mav / "cam0/sensor.yaml", right), right, sequence);
  sequence.other_files.push_back(mav / "cam0/sensor.yaml");
  AddTruth(mav, sequence);
  AddBoxes(request, sequence);
}

}  // namespace

SequenceLayout EurocLayout() { return {"euroc", KnowsEuroc, EurocHasImages, ReadEuroc}; }

}  // namespace cvo
