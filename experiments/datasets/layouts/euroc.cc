// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

// EuRoC in the ASL format: mav0/cam0 and cam1 with data/<ns>.png, data.csv and sensor.yaml, and the
// ground truth of the body in mav0/state_groundtruth_estimate0/data.csv. Images are not rectified.
// TUM-VI in the same format has its ground truth, with gaps, in mav0/mocap0/data.csv, and may have
// its calibration in dso/camchain.yaml alone.

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
    const fs::path file = folder / "data" / rows.Text(i, 1);
    if (!fs::is_regular_file(file)) continue;  // of a part of the recording
    const std::int64_t time_ns = rows.Integer(i, 0);
    CheckLater(rows, i, time_ns,
               camera.files.empty() ? std::nullopt : std::optional(camera.times_ns.back()),
               folder.filename().string());
    camera.times_ns.push_back(time_ns);
    camera.files.push_back(file);
  }
  if (camera.files.empty())
    rows.Fail(0, StrCat("no image in ", (folder / "data").string()), "one per row");
  if (const std::size_t without = rows.size() - camera.files.size()) {
    sequence.notes.push_back(StrCat(list.string(), ": ", without, " rows without an image"));
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

fs::path Chain(const fs::path& mav) { return mav.parent_path() / "dso/camchain.yaml"; }

void AddTruth(const fs::path& mav, Sequence& sequence) {
  fs::path path = mav / "state_groundtruth_estimate0/data.csv";
  if (!fs::exists(path) && fs::exists(mav / "mocap0/data.csv")) path = mav / "mocap0/data.csv";
  if (!fs::exists(path)) {
    sequence.missing.push_back(path.string() + ": no ground truth of the camera");
    return;
  }
  const Trajectory body = ReadTrajectory(path).poses;
  sequence.other_files.push_back(path);
  const fs::path left = mav / "cam0/sensor.yaml";
  const RigidTransform body_from_left =
      fs::exists(left) ? YamlMap::Read(left).Transform("T_BS")
                       : YamlMap::Read(Chain(mav)).Map("cam0").Transform("T_cam_imu").Inverse();
  AddCameraTruth(body, body_from_left, "it starts later, ends earlier or has a gap", sequence);
}

void ReadEuroc(const SequenceRequest& request, Sequence& sequence) {
  if (sequence.name == "mav0") sequence.name = request.folder.parent_path().filename().string();
  const fs::path mav = MavFolder(request.folder);
  AddPair(request, "grey", CheckedImages(PairImages(mav, sequence)), sequence);
  const fs::path left = mav / "cam0/sensor.yaml";
  const fs::path right = mav / "cam1/sensor.yaml";
  if (!fs::exists(left) && fs::exists(Chain(mav))) {
    AddRig(ReadKalibrRig(Chain(mav), "cam0", "cam1"), Chain(mav), sequence);
  } else {
    AddRig(ReadSensorRig(left, right), right, sequence);
    sequence.other_files.push_back(left);
  }
  AddTruth(mav, sequence);
  AddBoxes(request, sequence);
}

}  // namespace

SequenceLayout EurocLayout() { return {"euroc", KnowsEuroc, EurocHasImages, ReadEuroc}; }

}  // namespace cvo
