// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/overlay_run.h"

#include <functional>

#include "reports/runs/detail_files.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

OverlayCamera ReadCamera(const Fields& fields) {
  OverlayCamera camera;
  camera.width_px = static_cast<int>(fields.Integer("width_px"));
  camera.height_px = static_cast<int>(fields.Integer("height_px"));
  camera.fx_px = fields.Number("fx_px");
  camera.fy_px = fields.Number("fy_px");
  camera.cx_px = fields.Number("cx_px");
  camera.cy_px = fields.Number("cy_px");
  constexpr int kLargest_px = 20000;
  const bool good = camera.width_px > 0 && camera.height_px > 0 && camera.width_px <= kLargest_px &&
                    camera.height_px <= kLargest_px && camera.fx_px > 0.0 && camera.fy_px > 0.0;
  if (!good) ThrowError(fields.where(), fields.json().dump(), "a camera");
  return camera;
}

void ReadSequence(const Fields& fields, OverlayRun& run) {
  run.sequence_name = fields.Text("name");
  run.sequence_type = fields.Text("type");
  run.pair = fields.Text("pair");
  run.first_frame = static_cast<int>(fields.Integer("first_frame"));
  run.frames = static_cast<int>(fields.Integer("frames"));
  if (fields.Has("detections")) run.boxes = static_cast<int>(fields.Integer("detections"));
  if (fields.Has("detections_hash")) run.detections_hash = fields.Text("detections_hash");
  run.camera = ReadCamera(fields.Object("camera"));
}

// The members of result.json that a drawing needs; ReadRunDetail has checked what it is.
void ReadHead(const fs::path& file, OverlayRun& run) {
  const Json json = ReadJson(file, {"bodies", "clusters", "frames", "metrics", "options"});
  const Fields fields(json, file.string());
  run.variant = fields.Text("variant");
  run.seed = fields.Count("seed");
  ReadSequence(fields.Object("sequence"), run);
  if (!fields.Has("given")) return;
  const Fields given = fields.Object("given");
  if (given.Has("classes")) run.classes = given.Texts("classes");
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
  // The detail lists what is wrong with it, too, but not of which file.
  run.has_clusters =
      read("clusters", "objects.csv", [&] { ReadClusterTable(folder / "objects.csv"); });
  run.has_landmarks = read("landmarks", "landmarks.csv",
                           [&] { run.landmarks = ReadLandmarks(folder / "landmarks.csv", label); });
  MarkWrongLabels(run);
  if (run.has_clusters) {
    read("detections", "tracks.kitti", [&] { run.detections = ReadAssociatedBoxes(folder); });
  }
  return run;
}

}  // namespace cvo::reports
