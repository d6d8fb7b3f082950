// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/pictures/overlay_output.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/progress.h"
#include "experiments/cli/run/text_table.h"
#include "experiments/cli/scratch_folder.h"
#include "experiments/cli/stop_signal.h"
#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/encode.h"
#include "reports/overlays/panels.h"
#include "reports/overlays/sheet.h"
#include "reports/overlays/video.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSheet = "sheet.png";

std::string ImageName(int frame) {
  const std::string digits = StrCat(frame);
  return std::string(std::max<std::size_t>(digits.size(), 6) - digits.size(), '0') + digits +
         ".png";
}

// Layout of a contact sheet. Wide images have two columns, others four, or one if there are several
// runs.
struct SheetLayout {
  int columns;
  int width_px;  // of the drawing of one run
  std::size_t most;
};

SheetLayout LayoutOf(const OverlayJob& job) {
  const reports::CameraInfo& camera = job.runs.front().sequence.camera;
  const bool wide = camera.width_px > 2 * camera.height_px;
  if (job.runs.size() == 1) return wide ? SheetLayout{2, 800, 20} : SheetLayout{4, 480, 24};
  return wide ? SheetLayout{2, 800, 8} : SheetLayout{1, 480, 8};
}

// Draws all runs side by side, each `width_px` wide.
cv::Mat DrawFrame(const OverlayJob& job, const cv::Mat& image, int frame, int width_px,
                  bool on_sheet = false) {
  const reports::CameraInfo& camera = job.runs.front().sequence.camera;
  reports::OverlayStyle style = reports::StyleFor(camera, width_px);
  style.inset = style.inset && job.inset && job.boxes;
  style.inset_corner = job.inset_corner;
  reports::LimitTo(job.runs, style);
  const bool legend = style.legend && !on_sheet;
  style.legend = legend && job.runs.size() == 1;
  style.boxes = job.boxes;
  style.wrong = !job.boxes;
  std::vector<reports::TitledImage> panels;
  for (std::size_t i = 0; i < job.runs.size(); ++i) {
    const reports::OverlayFrame drawn = reports::FrameOf(job.runs[i], frame);
    panels.push_back({job.runs.size() > 1 ? job.titles[i] : "",
                      reports::DrawOverlay(image, drawn, camera, style)});
  }
  if (panels.size() == 1) return panels.front().image;
  cv::Mat all = reports::Panels(panels, style.text_px);
  if (!legend) return all;
  cv::vconcat(all, reports::LegendBar(style, all.cols), all);
  return all;
}

double FramesPerSecond(const OverlayJob& job) {
  if (job.frames.size() < 2) return 10.0;
  const reports::OverlayRun& run = job.runs.front();
  const double span_s = reports::FrameOf(run, job.frames.back()).time_s -
                        reports::FrameOf(run, job.frames.front()).time_s;
  const double rate = static_cast<double>(job.frames.size() - 1) / std::max(span_s, 1e-3);
  return std::clamp(std::round(1000.0 * rate) / 1000.0, 1.0, 60.0);
}

class OverlayWriter {
 public:
  OverlayWriter(const OverlayJob& job, const RunImages& images, const fs::path& folder)
      : job_(job), images_(images), folder_(folder), layout_(LayoutOf(job)) {
    if (!job.sheet) return;
    for (const std::size_t i : reports::EvenlySpaced(job.frames.size(), layout_.most)) {
      on_sheet_.push_back(job.frames[i]);
    }
  }

  void Draw(int frame) {
    const reports::CameraInfo& camera = job_.runs.front().sequence.camera;
    cv::Mat image = images_.Left(frame);
    if (image.empty()) image = cv::Mat::zeros(camera.height_px, camera.width_px, CV_8UC1);
    if (job_.images || job_.video) {
      const int width_px = std::max(1, static_cast<int>(std::lround(job_.scale * camera.width_px)));
      const cv::Mat picture = DrawFrame(job_, image, frame, width_px);
      if (job_.images) {
        WriteFilesAtomically(folder_, {{ImageName(frame), reports::PngBytes(picture)}});
      }
      if (job_.video) AddToVideo(picture);
    }
    if (std::find(on_sheet_.begin(), on_sheet_.end(), frame) != on_sheet_.end()) {
      tiles_.push_back(
          DrawFrame(job_, image, frame, std::min(layout_.width_px, camera.width_px), true));
    }
  }

  void Finish() {
    if (job_.sheet) {
      const cv::Mat sheet = reports::ContactSheet(tiles_, layout_.columns);
      WriteFilesAtomically(folder_, {{kSheet, reports::PngBytes(sheet)}});
      std::cout << "written: " << (folder_ / kSheet).string() << " (" << tiles_.size()
                << " frames)\n";
    }
    if (!video_) return;
    video_->Close();
    const std::string name = video_->path().filename().string();
    WriteFilesAtomically(folder_, {{name, ReadFileBytes(video_->path())}});
    std::cout << "written: " << (folder_ / name).string() << " (" << video_->format() << ", "
              << FrameRateText(FramesPerSecond(job_)) << ")\n";
  }

 private:
  void AddToVideo(const cv::Mat& picture) {
    if (!video_) {
      video_ = std::make_unique<reports::VideoFile>(work_.emplace().path() / "video",
                                                    picture.size(), FramesPerSecond(job_));
    }
    video_->Add(picture);
  }

  const OverlayJob& job_;
  const RunImages& images_;
  const fs::path& folder_;
  SheetLayout layout_;
  std::vector<int> on_sheet_;
  std::vector<cv::Mat> tiles_;
  std::optional<ScratchFolder> work_;
  std::unique_ptr<reports::VideoFile> video_;
};

}  // namespace

namespace {

int WritePanels(const OverlayJob& job, const RunImages& images) {
  constexpr const char* kPanels = "panels.jpg";
  constexpr int kQuality = 82;
  const OutputFolder output = OpenOutput(job.output, {kPanels}, job.read);
  const reports::OverlayRun& run = job.runs.front();
  const cv::Mat image = images.Left(job.frames.front());
  if (image.empty()) ThrowError(StrCat("frame ", job.frames.front()), "no image of it", "one");
  const int width_px =
      std::max(1, static_cast<int>(std::lround(job.scale * run.sequence.camera.width_px)));
  const cv::Mat picture = reports::FourPanels(image, run, job.frames.front(), width_px);
  WriteFilesAtomically(output.path(), {{kPanels, reports::JpegBytes(picture, kQuality)}});
  std::cout << "written: " << (output.path() / kPanels).string() << '\n';
  return 0;
}

}  // namespace

int WriteOverlays(const OverlayJob& job, const RunImages& images) {
  if (job.panels) return WritePanels(job, images);
  std::vector<std::string> names;
  for (const int frame : job.frames) {
    if (job.images) names.push_back(ImageName(frame));
  }
  if (job.sheet) names.emplace_back(kSheet);
  const OutputFolder output = OpenOutput(job.output, names, job.read);
  OverlayWriter writer(job, images, output.path());
  {
    const StopSignal stop;
    Progress progress(job.frames.size(), job.quiet);
    for (std::size_t i = 0; i < job.frames.size(); ++i) {
      writer.Draw(job.frames[i]);
      progress.Report(i + 1);
      if (!stop.Requested()) continue;
      std::cerr << "clustervo: stopped after " << i + 1 << " of " << job.frames.size()
                << " frames\n";
      return kStopped;
    }
  }
  if (job.images) {
    std::cout << "written: " << (output.path() / ImageName(job.frames.front())).string();
    if (job.frames.size() > 1) {
      std::cout << " to " << ImageName(job.frames.back()) << " (" << job.frames.size()
                << " images)";
    }
    std::cout << '\n';
  }
  writer.Finish();
  return 0;
}

}  // namespace cvo
