// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/overlay_run.h"

#include <functional>

#include "reports/runs/detail_files.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

void CheckCamera(const CameraInfo& camera, const fs::path& file) {
  constexpr int kLargest_px = 20000;
  const bool good = camera.width_px > 0 && camera.height_px > 0 && camera.width_px <= kLargest_px &&
                    camera.height_px <= kLargest_px && camera.fx_px > 0.0 && camera.fy_px > 0.0;
  if (!good) ThrowError(file.string() + ", sequence, camera", ToJson(camera).dump(), "a camera");
}

void ReadHead(const fs::path& file, OverlayRun& run) {
  const auto head =
      ReadRecord<RunSummary>(file, {"bodies", "clusters", "frames", "metrics", "options"});
  run.variant = head.variant;
  run.seed = head.seed;
  run.sequence = head.sequence;
  CheckCamera(run.sequence.camera, file);
  if (head.given.contains("classes")) {
    run.classes = FromJson<std::vector<std::string>>(head.given["classes"],
                                                     file.string() + ", given, classes");
  }
}

}  // namespace

OverlayRun ReadOverlayRun(const fs::path& folder, LandmarkLabel label) {
  OverlayRun run;
  run.detail = ReadRunDetail(folder);
  ReadHead(folder / "result.json", run);
  const auto read = [&](const char* what, const char* name, const std::function<void()>& reader) {
    const fs::path file = folder / name;
    try {
      if (fs::exists(file)) {
        reader();
        return true;
      }
      run.missing.push_back(StrCat("drawn without ", what, ": ", file.string(), ": no such file"));
    } catch (const Error& error) {
      run.missing.push_back(StrCat("drawn without ", what, ": ", error.what()));
    }
    return false;
  };
  // Reads objects.csv a second time, since run.detail.missing does not say which file an error is
  // in.
  run.has_clusters =
      read("clusters", "objects.csv", [&] { ReadClusterTable(folder / "objects.csv"); });
  run.has_landmarks = read("landmarks", "landmarks.csv",
                           [&] { run.landmarks = ReadLandmarks(folder / "landmarks.csv", label); });
  MarkWrongLabels(run);
  run.color_ids = ApartColors(run.detail.clusters);
  if (run.has_clusters) {
    read("detections", "tracks.kitti", [&] { run.detections = ReadAssociatedBoxes(folder); });
  }
  return run;
}

}  // namespace cvo::reports
