// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/report_images.h"

#include <algorithm>

#include "core/base/error.h"
#include "experiments/cli/run_images.h"
#include "reports/overlays/thumbnails.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// Of all images of a page, which base64 makes 6 MB.
constexpr std::size_t kMostBytes = 4'500'000;
constexpr std::size_t kUsualBytes = 12'000;  // of one
constexpr int kFewestFrames = 8;
constexpr int kMostFrames = 150;

reports::ThumbnailOptions OptionsFor(std::size_t scenes, int every, std::size_t frames) {
  reports::ThumbnailOptions options;
  options.most_bytes = kMostBytes / scenes;
  options.most_frames =
      std::clamp(static_cast<int>(options.most_bytes / kUsualBytes), kFewestFrames, kMostFrames);
  if (every > 0) options.most_frames = std::max(1, static_cast<int>(frames) / every);
  return options;
}

void AddImages(const fs::path& run_folder, int every, std::size_t scenes,
               reports::PageScene& scene) {
  if (!fs::exists(run_folder / "landmarks.csv")) {
    scene.no_images = "the run has no landmarks.csv, so nothing is drawn on its images";
    return;
  }
  reports::OverlayRun run = reports::ReadOverlayRun(run_folder, reports::LandmarkLabel::kCluster);
  const RunImages images(run, "");
  AdoptDetections("", run);
  const reports::ThumbnailStrip strip = reports::MakeThumbnails(
      run, [&](int frame) { return images.Left(frame); },
      OptionsFor(scenes, every, run.detail.camera.size()));
  for (const reports::Thumbnail& thumbnail : strip.thumbnails) {
    scene.images.push_back({thumbnail.frame, thumbnail.jpeg, thumbnail.alt});
  }
  for (const std::string& line : strip.missing) scene.detail.missing.push_back("images: " + line);
  if (scene.images.empty()) scene.no_images = "none of the run's images can be read";
}

}  // namespace

void AddSceneImages(const fs::path& folder, int every, reports::PageContent& content) {
  const auto wanting =
      static_cast<std::size_t>(std::count_if(content.scenes.begin(), content.scenes.end(),
                                             [](const auto& scene) { return scene.wants_images; }));
  for (reports::PageScene& scene : content.scenes) {
    if (!scene.wants_images) continue;
    const fs::path run_folder = folder / "jobs" / content.runs[scene.run].run.planned.job;
    try {
      AddImages(run_folder, every, wanting, scene);
    } catch (const Error& error) {
      scene.no_images = error.what();
    }
  }
}

}  // namespace cvo
