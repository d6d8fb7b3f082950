// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "reports/overlays/body_sheet.h"
#include "reports/overlays/drawing/strokes.h"
#include "reports/overlays/drawing/text_plate.h"

namespace cvo::reports {
namespace {

constexpr Rgb kTimeGround{16, 18, 24};
constexpr Rgb kTimeInk{190, 192, 198};
constexpr Rgb kTimeFaint{70, 73, 80};
constexpr Rgb kLandmarkBar{120, 124, 134};
constexpr Rgb kOwnBar{86, 180, 233};
constexpr double kMostError_m = 0.3;

// The rectangles of the bands, from top to bottom.
struct Bands {
  cv::Rect stage;
  cv::Rect detections;
  cv::Rect landmarks;
  cv::Rect errors;
};

Bands Layout(int width_px, int text_px) {
  const int row = 2 * text_px;
  const int left = 14 * text_px;
  const int wide = width_px - left - row;
  Bands bands;
  bands.stage = {left, 2 * row, wide, row};
  bands.detections = {left, bands.stage.br().y + 4, wide, row / 2};
  bands.landmarks = {left, bands.detections.br().y + 6, wide, 3 * row};
  bands.errors = {left, bands.landmarks.br().y + row / 2, wide, 3 * row};
  return bands;
}

// The part of a band that belongs to a frame.
cv::Rect Slot(const BodyStory& story, int frame, const cv::Rect& band) {
  const int first = story.frames.front().frame;
  const double count = story.frames.back().frame - first + 1;
  const int from = band.x + static_cast<int>((frame - first) / count * band.width);
  const int to = band.x + static_cast<int>((frame - first + 1) / count * band.width);
  return {from, band.y, std::max(1, to - from), band.height};
}

void Fill(const cv::Rect& area, Rgb color, cv::Mat& picture) {
  picture(area & cv::Rect({0, 0}, picture.size())).setTo(Bgr(color));
}

// The lower part of a slot, `share` of its height.
cv::Rect Bar(cv::Rect slot, double share) {
  const int height = static_cast<int>(std::clamp(share, 0.0, 1.0) * slot.height);
  return {slot.x, slot.br().y - height, slot.width, height};
}

void DrawFrames(const BodyStory& story, const Bands& bands, cv::Mat& picture) {
  int most = 1;
  for (const BodyFrame& frame : story.frames) most = std::max(most, frame.Seen());
  for (const BodyFrame& frame : story.frames) {
    Fill(Slot(story, frame.frame, bands.stage), ColorOf(frame.stage), picture);
    if (frame.detected) {
      Fill(Slot(story, frame.frame, bands.detections),
           *frame.detected ? Rgb{230, 230, 230} : kTimeFaint, picture);
    }
    const cv::Rect landmarks = Slot(story, frame.frame, bands.landmarks);
    Fill(Bar(landmarks, 1.0 * frame.Seen() / most), kLandmarkBar, picture);
    Fill(Bar(landmarks, 1.0 * frame.Labelled(story.body.cluster) / most), kOwnBar, picture);
    if (!frame.error_m) continue;
    Fill(Bar(Slot(story, frame.frame, bands.errors), *frame.error_m / kMostError_m),
         ColorOf(*frame.error_m > kGoodError_m ? BodyStage::kMotion : BodyStage::kGood), picture);
  }
}

void DrawLabels(const BodyStory& story, const Bands& bands, int text_px, cv::Mat& picture) {
  const PlateStyle text{text_px, kTimeGround, kTimeInk};
  const auto put = [&](const std::string& words, int y) {
    DrawPlate(words, {0, y}, text, picture);
  };
  put("stage", bands.stage.y);
  put("detected", bands.detections.y - 3);
  const bool known = std::any_of(story.frames.begin(), story.frames.end(),
                                 [](const BodyFrame& frame) { return frame.detected.has_value(); });
  if (!known) {
    DrawPlate("boxes not known", {bands.detections.x, bands.detections.y - 3}, text, picture);
  }
  put("landmarks, own", bands.landmarks.y);
  put("error to 30 cm", bands.errors.y);
  std::vector<Stroke> strokes;
  const double y = bands.errors.br().y - kGoodError_m / kMostError_m * bands.errors.height;
  strokes.push_back({{{1.0 * bands.errors.x, y}, {1.0 * bands.errors.br().x, y}}, kTimeInk, 1});
  for (const BodyEvent& event : story.events) {
    const cv::Rect slot = Slot(story, event.frame, bands.stage);
    strokes.push_back({{{1.0 * slot.x, slot.y - 4.0}, {1.0 * slot.x, 1.0 * bands.errors.br().y}},
                       {255, 255, 255},
                       1});
  }
  DrawStrokes(strokes, 0.0, picture);
  int right = 0;  // end of the last number, which the next one must not cover
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const std::string number = StrCat("(", i + 1, ")");
    const int x = std::max(right, Slot(story, story.events[i].frame, bands.stage).x);
    const cv::Size size = PlateSize(number, text_px);
    DrawPlate(number, {std::min(x, picture.cols - size.width), bands.stage.y - size.height - 4},
              text, picture);
    right = x + size.width;
  }
}

// Draws the names of the stages that occur, in their colours.
void DrawKey(const BodyStory& story, int text_px, cv::Mat& picture) {
  int x = 0;
  for (int i = 0; i <= static_cast<int>(BodyStage::kMotion); ++i) {
    const auto stage = static_cast<BodyStage>(i);
    if (story.Count(stage) == 0) continue;
    const std::string name(StageName(stage));
    DrawPlate(name, {x, 0}, {text_px, ColorOf(stage), TextColorOn(ColorOf(stage))}, picture);
    x += PlateSize(name, text_px).width + text_px;
  }
}

}  // namespace

Rgb ColorOf(BodyStage stage) {
  switch (stage) {
    case BodyStage::kHidden:
      return {52, 55, 62};
    case BodyStage::kGood:
      return {64, 160, 96};
    case BodyStage::kNoDetection:
      return {240, 228, 66};
    case BodyStage::kNoLandmarks:
      return {150, 150, 150};
    case BodyStage::kLabel:
      return {230, 130, 30};
    case BodyStage::kJoined:
      return {200, 60, 160};
    case BodyStage::kUnconfirmed:
      return {160, 200, 220};
    case BodyStage::kIdentity:
      return {90, 120, 220};
    case BodyStage::kMotion:
      return {215, 60, 50};
  }
  return {};
}

cv::Mat BodyTimeline(const BodyStory& story, int width_px, int text_px) {
  const Bands bands = Layout(width_px, text_px);
  cv::Mat picture(bands.errors.br().y + 2 * text_px + 6, width_px, CV_8UC3, Bgr(kTimeGround));
  DrawKey(story, text_px, picture);
  if (story.frames.empty()) return picture;
  DrawFrames(story, bands, picture);
  DrawLabels(story, bands, text_px, picture);
  const PlateStyle text{text_px, kTimeGround, kTimeInk};
  DrawPlate(StrCat("frame ", story.frames.front().frame), {bands.errors.x, bands.errors.br().y + 2},
            text, picture);
  const std::string last = StrCat(story.frames.back().frame);
  DrawPlate(last, {bands.errors.br().x - PlateSize(last, text_px).width, bands.errors.br().y + 2},
            text, picture);
  return picture;
}

}  // namespace cvo::reports
