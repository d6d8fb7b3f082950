// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/thumbnails.h"

#include <algorithm>

#include "core/base/error.h"
#include "reports/overlays/drawing/draw_overlay.h"
#include "reports/overlays/encode.h"
#include "reports/overlays/sheet.h"

namespace cvo::reports {
namespace {

struct DrawnFrame {
  Thumbnail thumbnail;
  cv::Mat picture;
};

std::string StatusText(const OverlayFrame& frame, const CameraInfo& camera) {
  std::string words;
  for (const std::string& word : StatusWords(frame, camera)) {
    words += (words.empty() ? "" : "; ") + word;
  }
  return words;
}

std::vector<DrawnFrame> DrawFrames(const OverlayRun& run, const ImageOfFrame& image_of_frame,
                                   const ThumbnailOptions& options, ThumbnailStrip& strip) {
  const OverlayStyle style =
      StyleFor(run.sequence.camera, std::min(options.width_px, run.sequence.camera.width_px));
  std::vector<DrawnFrame> drawn;
  int without = 0;
  for (const std::size_t index :
       EvenlySpaced(run.detail.camera.size(), static_cast<std::size_t>(options.most_frames))) {
    const OverlayFrame frame = FrameOf(run, run.detail.camera[index].frame);
    const cv::Mat image = image_of_frame(frame.frame);
    if (image.empty()) {
      ++without;
      continue;
    }
    drawn.push_back({{frame.frame, frame.time_s, "", StatusText(frame, run.sequence.camera)},
                     DrawOverlay(image, frame, run.sequence.camera, style)});
  }
  if (without > 0) strip.missing.push_back(StrCat(without, " frames have no image"));
  return drawn;
}

std::size_t Encode(const std::vector<DrawnFrame>& drawn, int quality, ThumbnailStrip& strip) {
  std::size_t bytes = 0;
  strip.thumbnails.clear();
  for (const DrawnFrame& frame : drawn) {
    strip.thumbnails.push_back(frame.thumbnail);
    strip.thumbnails.back().jpeg = JpegBytes(frame.picture, quality);
    bytes += strip.thumbnails.back().jpeg.size();
  }
  return bytes;
}

}  // namespace

void ThumbnailOptions::Check() const {
  if (width_px < 32 || width_px > 320) ThrowError("width_px", StrCat(width_px), "32 to 320");
  if (most_frames < 1) ThrowError("most_frames", StrCat(most_frames), "at least 1");
  if (quality < 1 || quality > 100) ThrowError("quality", StrCat(quality), "1 to 100");
}

ThumbnailStrip MakeThumbnails(const OverlayRun& run, const ImageOfFrame& image_of_frame,
                              const ThumbnailOptions& options) {
  options.Check();
  ThumbnailStrip strip;
  strip.missing = run.missing;
  const std::vector<DrawnFrame> drawn = DrawFrames(run, image_of_frame, options, strip);
  if (drawn.empty()) return strip;
  strip.width_px = drawn.front().picture.cols;
  strip.height_px = drawn.front().picture.rows;
  constexpr int kLowestQuality = 20;
  constexpr int kStep = 10;
  for (int quality = options.quality;; quality -= kStep) {
    if (Encode(drawn, quality, strip) <= options.most_bytes || quality - kStep < kLowestQuality) {
      break;
    }
  }
  return strip;
}

}  // namespace cvo::reports
