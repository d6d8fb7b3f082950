// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/drawing/text_plate.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace cvo::reports {
namespace {

// Letters are drawn this much larger and then reduced, since OpenCV's strokes are whole pixels
// wide.
constexpr int kSuper = 4;
constexpr double kCapital_px = 21.0;  // height of a capital letter at font scale 1
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;

int Descent(int text_px) { return (text_px * 2 + 4) / 5; }
int Padding(int text_px) { return std::max(2, text_px * 2 / 5); }

struct Letters {
  double scale;
  int thickness;
};

Letters LettersOf(int text_px) {
  return {kSuper * text_px / kCapital_px, std::max(1, (kSuper * text_px * 4 + 15) / 30)};
}

int TextWidth(const std::string& text, int text_px) {
  const auto [scale, thickness] = LettersOf(text_px);
  int below = 0;
  return (cv::getTextSize(text, kFont, scale, thickness, &below).width + kSuper - 1) / kSuper;
}

// Coverage of pixels by the letters, from the top of a capital to below a "g".
cv::Mat TextMask(const std::string& text, int text_px) {
  const auto [scale, thickness] = LettersOf(text_px);
  const cv::Size size(TextWidth(text, text_px) + 1, text_px + 1 + Descent(text_px));
  cv::Mat large = cv::Mat::zeros(kSuper * size.height, kSuper * size.width, CV_8UC1);
  cv::putText(large, text, {thickness / 2, kSuper * (text_px + 1) - thickness / 2}, kFont, scale,
              255, thickness, cv::LINE_AA);
  cv::Mat mask;
  cv::resize(large, mask, size, 0.0, 0.0, cv::INTER_AREA);
  return mask;
}

}  // namespace

cv::Scalar Bgr(Rgb color) { return {double(color.blue), double(color.green), double(color.red)}; }

std::string DrawableText(std::string_view text, std::size_t longest) {
  std::string drawable;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U) continue;  // continuation byte: its character already has a '?'
    drawable += byte >= 0x20 && byte < 0x7F ? c : '?';
  }
  if (drawable.size() > longest) drawable = drawable.substr(0, longest - 2) + "..";
  return drawable;
}

cv::Size PlateSize(const std::string& text, int text_px) {
  const int padding = Padding(text_px);
  return {TextWidth(text, text_px) + 2 * padding, text_px + 2 * padding + 1};
}

void BlendMask(const cv::Mat& mask, cv::Point at, Rgb color, double opacity, cv::Mat& image) {
  const cv::Rect covered = cv::Rect(at, mask.size()) & cv::Rect({}, image.size());
  const int weight = static_cast<int>(opacity * 256.0 + 0.5);
  const int bgr[3] = {color.blue, color.green, color.red};
  for (int v = covered.y; v < covered.br().y; ++v) {
    const std::uint8_t* coverage = mask.ptr<std::uint8_t>(v - at.y);
    auto* row = image.ptr<cv::Vec3b>(v);
    for (int u = covered.x; u < covered.br().x; ++u) {
      const int part = coverage[u - at.x] * weight;  // out of 255 * 256
      for (int c = 0; c < 3; ++c) {
        const int old = row[u][c];
        row[u][c] = static_cast<std::uint8_t>(old + ((bgr[c] - old) * part) / (255 * 256));
      }
    }
  }
}

void DrawPlate(const std::string& text, cv::Point at, const PlateStyle& style, cv::Mat& image) {
  const cv::Size size = PlateSize(text, style.text_px);
  const cv::Mat plate(size, CV_8UC1, cv::Scalar(255));
  BlendMask(plate, at, style.fill, style.opacity, image);
  if (style.outline) cv::rectangle(image, cv::Rect(at, size), Bgr(*style.outline), 1);
  const int padding = Padding(style.text_px);
  BlendMask(TextMask(text, style.text_px), at + cv::Point(padding, padding - 1), style.ink, 1.0,
            image);
}

}  // namespace cvo::reports
