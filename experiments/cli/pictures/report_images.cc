// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/pictures/report_images.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "experiments/cli/pictures/run_images.h"
#include "reports/figures/numbers.h"
#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/encode.h"
#include "reports/overlays/thumbnails.h"
#include "reports/page/page_html.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxPageBytes = 14'500'000;
constexpr std::size_t kMaxImageBytes = 4'500'000;   // all images of a page, 6 MB in base64
constexpr std::size_t kMinBytes = 1'000'000;        // left for images even if runs are long
constexpr std::size_t kTypicalImageBytes = 12'000;  // one image
constexpr int kAllWidth = 640;                      // pixels, of the images stored beside the page
constexpr int kAllQuality = 80;
constexpr int kMinFrames = 8;
constexpr int kMaxFrames = 150;

// Drops scenes from the end until there is room for images. Returns the number of bytes for images.
std::size_t MakeRoom(reports::PageContent& content) {
  constexpr std::size_t kMinBase64 = kMinBytes / 3 * 4;
  std::size_t size = reports::PageHtml(content).size();
  while (size + kMinBase64 > kMaxPageBytes && content.scenes.size() > 1) {
    content.scenes.pop_back();
    ++content.scenes_left_out;
    size = reports::PageHtml(content).size();
  }
  if (size + kMinBase64 > kMaxPageBytes) return kMinBytes;
  return std::min(kMaxImageBytes, (kMaxPageBytes - size) / 4 * 3);
}

reports::ThumbnailOptions OptionsFor(std::size_t most_bytes, int every, std::size_t frames) {
  reports::ThumbnailOptions options;
  options.most_bytes = most_bytes;
  options.most_frames =
      std::clamp(static_cast<int>(options.most_bytes / kTypicalImageBytes), kMinFrames, kMaxFrames);
  if (every > 0) options.most_frames = std::max(1, static_cast<int>(frames) / every);
  return options;
}

// Throws Error if there is nothing to draw.
reports::OverlayRun ReadDrawn(const fs::path& run_folder) {
  if (!fs::exists(run_folder / "landmarks.csv")) {
    throw Error("the run has no landmarks.csv, so its images are not shown");
  }
  reports::OverlayRun run = reports::ReadOverlayRun(run_folder, reports::LandmarkLabel::kCluster);
  AdoptDetections(FindDetections("", run), run);
  return run;
}

fs::path RunFolder(const fs::path& folder, const reports::PageScene& scene,
                   const reports::PageContent& content) {
  return folder / "jobs" / content.runs[scene.run].run.planned.job;
}

void AddImages(const fs::path& run_folder, int every, std::size_t most_bytes,
               reports::PageScene& scene) {
  const reports::OverlayRun run = ReadDrawn(run_folder);
  const RunImages images(run, "");
  const reports::ThumbnailStrip strip = reports::MakeThumbnails(
      run, [&](int frame) { return images.Left(frame); },
      OptionsFor(most_bytes, every, run.detail.camera.size()));
  for (const reports::Thumbnail& thumbnail : strip.thumbnails) {
    scene.images.push_back({thumbnail.frame, thumbnail.jpeg, thumbnail.alt});
  }
  for (const std::string& line : strip.missing) scene.detail.missing.push_back("images: " + line);
  if (scene.images.empty()) scene.no_images = "none of the run's images can be read";
}

std::string FileName(int frame) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "%06d.jpg", frame);
  return name.data();
}

std::vector<NamedContent> DrawAll(const fs::path& run_folder) {
  const reports::OverlayRun run = ReadDrawn(run_folder);
  const RunImages images(run, "");
  const reports::OverlayStyle style = reports::StyleFor(run.sequence.camera, kAllWidth);
  std::vector<NamedContent> files;
  for (const reports::CameraFrame& entry : run.detail.camera) {
    const cv::Mat image = images.Left(entry.frame);
    if (image.empty()) continue;
    const cv::Mat drawn =
        reports::DrawOverlay(image, reports::FrameOf(run, entry.frame), run.sequence.camera, style);
    files.push_back({FileName(entry.frame), reports::JpegBytes(drawn, kAllQuality)});
  }
  return files;
}

// Names in a suite need not be valid file names; the number keeps similar ones distinct.
std::string FolderName(std::size_t index, const reports::PlannedRun& run) {
  return StrCat(index, "-", reports::Slug(reports::KeyOf(run, "sequence")), "-",
                reports::Slug(reports::KeyOf(run, "variant")));
}

}  // namespace

void AddSceneImages(const fs::path& folder, int every, reports::PageContent& content) {
  const std::size_t most_bytes = MakeRoom(content);
  const auto wanting =
      static_cast<std::size_t>(std::count_if(content.scenes.begin(), content.scenes.end(),
                                             [](const auto& scene) { return scene.wants_images; }));
  for (reports::PageScene& scene : content.scenes) {
    if (!scene.wants_images) continue;
    try {
      AddImages(RunFolder(folder, scene, content), every, most_bytes / wanting, scene);
    } catch (const Error& error) {
      scene.no_images = error.what();
    }
  }
}

void WriteAllImages(const fs::path& folder, const fs::path& out, reports::PageContent& content) {
  for (std::size_t i = 0; i < content.scenes.size(); ++i) {
    reports::PageScene& scene = content.scenes[i];
    std::vector<NamedContent> files;
    try {
      files = DrawAll(RunFolder(folder, scene, content));
    } catch (const Error& error) {
      scene.detail.missing.push_back(StrCat("all images: ", error.what()));
      continue;
    }
    scene.images_folder = "images/" + FolderName(i, content.runs[scene.run].run.planned);
    fs::create_directories(out / scene.images_folder);
    WriteFilesAtomically(out / scene.images_folder, files);
  }
}

}  // namespace cvo
