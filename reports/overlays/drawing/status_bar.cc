// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "reports/overlays/drawing/draw_cluster.h"
#include "reports/overlays/drawing/text_plate.h"

namespace cvo::reports {
namespace {

constexpr Rgb kBarColor{24, 24, 28};
constexpr Rgb kBarInk{235, 235, 235};
constexpr Rgb kDimInk{175, 175, 180};
constexpr std::size_t kMaxWordLength = 80;
constexpr int kMargin_px = 2;

int RowHeight(int text_px) { return PlateSize("x", text_px).height; }

std::string CountClusters(const OverlayFrame& frame, const CameraInfo& camera) {
  int tracked = 0;
  int predicted = 0;
  int unseen = 0;
  for (const ClusterShape& cluster : frame.clusters) {
    ++(cluster.predicted ? predicted : tracked);
    unseen += SeenRect(cluster, camera) ? 0 : 1;
  }
  std::string words = StrCat("bodies ", tracked);
  if (predicted > 0) words += StrCat(" + ", predicted, " predicted");
  if (unseen > 0) words += StrCat(" (", unseen, " out of view)");
  return words;
}

std::string CountLandmarks(const OverlayFrame& frame) {
  int on_scene = 0;
  int on_bodies = 0;
  int outliers = 0;
  int wrong = 0;
  for (const LandmarkDot& dot : frame.landmarks) {
    wrong += dot.wrong ? 1 : 0;
    ++(dot.label == kStaticLabel ? on_scene : dot.label > kStaticLabel ? on_bodies : outliers);
  }
  std::string words = StrCat("landmarks ", on_scene, " static, ", on_bodies, " on bodies");
  if (outliers > 0) words += StrCat(", ", outliers, " outliers");
  if (frame.has_truth) words += StrCat(", ", wrong, " with a wrong label");
  return words;
}

}  // namespace

std::vector<std::string> StatusWords(const OverlayFrame& frame, const CameraInfo& camera) {
  return {StrCat("frame ", frame.frame),
          FormatFixed(frame.time_s, 2) + " s",
          "camera " + frame.status,
          frame.has_clusters ? CountClusters(frame, camera) : "bodies not recorded",
          frame.has_landmarks ? CountLandmarks(frame) : "landmarks not recorded",
          frame.run};
}

int BarHeight(int text_px, int rows) { return rows * RowHeight(text_px) + 2 * kMargin_px; }

void DrawBar(const std::vector<std::string>& words, int text_px, cv::Mat& bar) {
  bar.setTo(Bgr(kBarColor));
  PlateStyle style{text_px, kBarColor, kBarInk};
  const auto width_of = [&](const std::string& word) { return PlateSize(word, text_px).width; };
  cv::Point at(kMargin_px, kMargin_px);
  int right = bar.cols - kMargin_px;
  std::vector<std::string> drawable;
  for (const std::string& word : words) drawable.push_back(DrawableText(word, kMaxWordLength));
  const bool has_end =
      words.size() > 1 && width_of(drawable[0]) + width_of(drawable.back()) < right;
  for (std::size_t i = 0; i + (has_end ? 1 : 0) < drawable.size(); ++i) {
    const int width = width_of(drawable[i]);
    const int end = at.y == kMargin_px && has_end ? right - width_of(drawable.back()) : right;
    if (i > 0 && at.x + width > end) at = {kMargin_px, at.y + RowHeight(text_px)};
    if (at.y + RowHeight(text_px) > bar.rows) break;
    style.ink = i == 0 ? kBarInk : kDimInk;
    DrawPlate(drawable[i], at, style, bar);
    at.x += width + text_px / 2;
  }
  if (!has_end) return;
  DrawPlate(drawable.back(), {right - width_of(drawable.back()), kMargin_px}, style, bar);
}

}  // namespace cvo::reports
