// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <memory>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "experiments/cli/command.h"
#include "experiments/cli/reports/reports.h"
#include "reports/overlays/canvas.h"
#include "reports/overlays/draw_overlay.h"
#include "reports/page/page.h"
#include "variants/registry.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxImageBytes = 4'500'000;   // all images of a page, 6 MB in base64
constexpr std::size_t kTypicalImageBytes = 12'000;  // one image
constexpr int kWidth = 320;                         // of those in the page
constexpr int kQuality = 60;
constexpr std::size_t kMinFrames = 8;
constexpr std::size_t kMaxFrames = 150;

// Adds left images of a run, evenly spaced and drawn upon. Throws Error if that is impossible.
void AddImages(const fs::path& run_folder, std::size_t most, std::vector<std::string>& missing,
               reports::PageScene& scene) {
  reports::OverlayRun run = reports::ReadOverlayRun(run_folder, reports::LandmarkLabel::kCluster);
  AddDetections("", run);
  const RunImages images(run, "");
  const reports::CameraInfo& camera = run.sequence.camera;
  const reports::OverlayStyle style = reports::StyleFor(camera, std::min(kWidth, camera.width_px));
  for (const std::size_t i : reports::EvenlySpaced(run.detail.camera.size(), most)) {
    const int number = run.detail.camera[i].frame;
    const cv::Mat image = images.Left(number);
    if (image.empty()) continue;
    const reports::OverlayFrame frame = reports::FrameOf(run, number);
    const cv::Mat drawn = reports::DrawOverlay(image, frame, camera, style);
    scene.images.push_back(
        {number, reports::JpegBytes(drawn, kQuality), reports::StatusText(frame)});
  }
  for (const std::string& line : run.missing) {
    // Suites write landmarks only if asked; boxes and paths are drawn without.
    if (!line.ends_with("landmarks.csv: no such file")) missing.push_back(line);
  }
  if (scene.images.empty()) throw Error("none of the run's images can be read");
}

// Adds to each scene as many images as fit into kMaxImageBytes.
void AddSceneImages(const fs::path& folder, reports::PageContent& content) {
  const std::size_t scenes = std::max<std::size_t>(content.scenes.size(), 1);
  const std::size_t most =
      std::clamp(kMaxImageBytes / scenes / kTypicalImageBytes, kMinFrames, kMaxFrames);
  for (reports::PageScene& scene : content.scenes) {
    try {
      AddImages(folder / "jobs" / content.runs[scene.run].planned.job, most, content.missing,
                scene);
    } catch (const Error& error) {
      scene.no_images = error.what();
      const std::string path = (folder / "").string();  // private, and differs between machines
      const auto at = scene.no_images.find(path);
      if (at != std::string::npos) scene.no_images.erase(at, path.size());
    }
  }
}

reports::PageRequest RequestOf(const ReportFlags& flags) {
  reports::PageRequest request;
  request.folder = NormalFolder(flags.folder);
  request.default_options = DefaultOptions();
  for (const VariantInfo& variant : Variants()) {
    request.variants.emplace_back(variant.name, variant.changes);
  }
  return request;
}

}  // namespace

int WriteReport(const ReportFlags& flags) {
  const reports::PageRequest request = RequestOf(flags);
  reports::PageContent content = reports::ReadPage(request);
  const fs::path out = flags.out.empty() ? fs::path(flags.folder) / "report" : fs::path(flags.out);
  const OutputFolder output = OpenOutput(out, {"index.html"}, {request.folder});
  if (!flags.no_images) {
    AddSceneImages(request.folder, content);
  } else {
    for (reports::PageScene& scene : content.scenes) scene.no_images = "left out by --no-images";
  }
  WriteFilesAtomically(out, {{"index.html", reports::PageHtml(content)}});
  std::cout << "written: " << (out / "index.html").string() << '\n';
  for (const std::string& problem : content.problems) std::cerr << "missing: " << problem << '\n';
  return content.problems.empty() ? 0 : 1;
}

Command AddReportCommand(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("report", "Write the results of a suite as a single HTML page");
  const FlagAdder add{*app};
  const auto flags = std::make_shared<ReportFlags>();
  add("DIR", flags->folder, "", "output folder of a suite")->required();
  add("-o,--output", flags->out, "OUT", "output folder for index.html; default: DIR/report");
  app->add_flag("--no-images", flags->no_images, "write the page without images");
  app->footer(
      "The page is self-contained and works offline. It lists what is missing or failed.\nExit "
      "code 1 if a whole section of the page could not be made.\n"
      "Example: clustervo report results/ablation");
  return {app, [flags] { return WriteReport(*flags); }};
}

}  // namespace cvo
