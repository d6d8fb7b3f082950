// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/overlays/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"

namespace cvo::reports {
namespace {

constexpr int kFractionBits = 4;  // of pixel coordinates
constexpr double kFraction = 1 << kFractionBits;

cv::Point Fixed(cv::Point2d point) {
  return {static_cast<int>(std::lround(point.x * kFraction)),
          static_cast<int>(std::lround(point.y * kFraction))};
}

// The part of a segment in the image or near it, so that later steps meet no huge coordinates.
std::optional<Segment> Clip(const Segment& segment, cv::Size image) {
  constexpr double kMargin_px = 50.0;
  const bool finite = std::isfinite(segment.first.x + segment.first.y) &&
                      std::isfinite(segment.second.x + segment.second.y);
  if (!finite) return std::nullopt;
  const auto fixed = [](double pixel) {
    return static_cast<std::int64_t>(
        std::llround((std::clamp(pixel, -1e9, 1e9) + kMargin_px) * kFraction));
  };
  const auto back = [](const cv::Point2l& point) {
    return cv::Point2d(static_cast<double>(point.x) / kFraction - kMargin_px,
                       static_cast<double>(point.y) / kFraction - kMargin_px);
  };
  cv::Point2l a(fixed(segment.first.x), fixed(segment.first.y));
  cv::Point2l b(fixed(segment.second.x), fixed(segment.second.y));
  const cv::Size2l size(fixed(image.width + kMargin_px), fixed(image.height + kMargin_px));
  if (!cv::clipLine(size, a, b)) return std::nullopt;
  return Segment{back(a), back(b)};
}

std::vector<Segment> Dashes(const Segment& segment, double dash_px) {
  const cv::Point2d step = segment.second - segment.first;
  const double length_px = std::hypot(step.x, step.y);
  if (!(length_px > dash_px)) return {segment};
  std::vector<Segment> dashes;
  for (double begin_px = 0.0; begin_px < length_px; begin_px += 2.0 * dash_px) {
    const double end_px = std::min(begin_px + dash_px, length_px);
    dashes.emplace_back(segment.first + begin_px / length_px * step,
                        segment.first + end_px / length_px * step);
  }
  return dashes;
}

std::string Hex(Rgb color) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", color.red, color.green, color.blue);
  return text.data();
}

// A place in SVG, which counts from the corner of the first pixel.
std::string PlaceText(cv::Point2d at) {
  return StrCat(FormatFixed(at.x + 0.5, 2), " ", FormatFixed(at.y + 0.5, 2));
}

}  // namespace

cv::Scalar Bgr(Rgb color) { return {double(color.blue), double(color.green), double(color.red)}; }

Font::Font(int text_px)
    : scale(text_px / 21.0), thickness(std::max(1, text_px / 8)), gap_px(text_px / 3 + 1) {}

cv::Size Font::SizeOf(const std::string& text) const {
  int below_px = 0;
  const cv::Size size =
      cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, scale, thickness, &below_px);
  return {size.width + 2 * gap_px, size.height + 2 * gap_px};
}

void DrawStrokes(const std::vector<Stroke>& strokes, Canvas& canvas) {
  for (const bool rim : {true, false}) {
    for (const Stroke& stroke : strokes) {
      const std::optional<Segment> seen = Clip(stroke.segment, canvas.pixels.size());
      if (!seen) continue;
      const int width_px = stroke.width_px + (rim ? 2 : 0);
      const Rgb color = rim ? kDark : stroke.color;
      for (const auto& [a, b] : stroke.dashed ? Dashes(*seen, 4.0 + 2.0 * stroke.width_px)
                                              : std::vector<Segment>{*seen}) {
        if (canvas.svg != nullptr) {
          *canvas.svg += StrCat("<path d=\"M", PlaceText(a), "L", PlaceText(b), "\" stroke=\"",
                                Hex(color), "\" stroke-width=\"", width_px, "\"/>\n");
        } else {
          cv::line(canvas.pixels, Fixed(a), Fixed(b), Bgr(color), width_px, cv::LINE_AA,
                   kFractionBits);
        }
      }
    }
  }
}

void DrawDisc(cv::Point2d center, double radius_px, Rgb color, Canvas& canvas) {
  // Written so that NaN is outside, too.
  const bool inside = center.x > -radius_px && center.y > -radius_px &&
                      center.x < canvas.pixels.cols + radius_px &&
                      center.y < canvas.pixels.rows + radius_px;
  if (!inside) return;
  if (canvas.svg != nullptr) {
    *canvas.svg += StrCat("<circle transform=\"translate(", PlaceText(center), ")\" r=\"",
                          FormatFixed(radius_px, 2), "\" fill=\"", Hex(color), "\"/>\n");
    return;
  }
  cv::circle(canvas.pixels, Fixed(center), static_cast<int>(std::lround(radius_px * kFraction)),
             Bgr(color), cv::FILLED, cv::LINE_AA, kFractionBits);
}

void AddTail(const std::vector<Segment>& path, Rgb color, int width_px,
             std::vector<Stroke>& strokes) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(path.size());
    strokes.push_back({path[i], color, 1 + static_cast<int>(share * width_px)});
  }
}

void DrawText(const std::string& text, cv::Point top_left, const Font& font, Rgb color,
              cv::Mat& image) {
  const cv::Size size = font.SizeOf(text);
  cv::putText(image, text, top_left + cv::Point(font.gap_px, size.height - font.gap_px),
              cv::FONT_HERSHEY_SIMPLEX, font.scale, Bgr(color), font.thickness, cv::LINE_AA);
}

void DrawPlate(const std::string& text, cv::Point top_left, int text_px, Rgb fill, Canvas& canvas) {
  const Font font(text_px);
  const cv::Size size = font.SizeOf(text);
  const cv::Point at(std::clamp(top_left.x, 0, std::max(0, canvas.pixels.cols - size.width)),
                     std::clamp(top_left.y, 0, std::max(0, canvas.pixels.rows - size.height)));
  const double luma = 0.299 * fill.red + 0.587 * fill.green + 0.114 * fill.blue;
  const Rgb color = luma > 115.0 ? Rgb{0, 0, 0} : kWhite;
  if (canvas.svg == nullptr) {
    cv::rectangle(canvas.pixels, cv::Rect(at, size), Bgr(fill), cv::FILLED);
    DrawText(text, at, font, color, canvas.pixels);
    return;
  }
  constexpr double kEmPerCapital = 1.4;
  *canvas.svg += StrCat(
      "<g transform=\"translate(", at.x, " ", at.y, ")\"><rect width=\"", size.width,
      "\" height=\"", size.height, "\" fill=\"", Hex(fill), "\"/><text x=\"", font.gap_px,
      "\" y=\"", size.height - font.gap_px, "\" fill=\"", Hex(color), "\" font-size=\"",
      kEmPerCapital * text_px, "\" textLength=\"", size.width - 2 * font.gap_px,
      "\" lengthAdjust=\"spacingAndGlyphs\">", HtmlEscaped(Printable(text)), "</text></g>\n");
}

cv::Mat Grid(const std::vector<cv::Mat>& images, int columns) {
  constexpr int kGap_px = 4;
  Require(!images.empty() && columns > 0, "Grid: at least one image and one column");
  const cv::Size size = images.front().size();
  const int count = static_cast<int>(images.size());
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  cv::Mat grid(rows * (size.height + kGap_px) - kGap_px, columns * (size.width + kGap_px) - kGap_px,
               CV_8UC3, Bgr(kWhite));
  for (int i = 0; i < rows * columns; ++i) {
    const cv::Point corner(i % columns * (size.width + kGap_px),
                           i / columns * (size.height + kGap_px));
    cv::Mat cell = grid(cv::Rect(corner, size));
    if (i >= count) {
      cell.setTo(Bgr(kDark));
      continue;
    }
    const cv::Mat& image = images[static_cast<std::size_t>(i)];
    if (image.size() != size) {
      ThrowError("images side by side", StrCat(image.cols, "x", image.rows, " pixels"),
                 StrCat(size.width, "x", size.height, ", as the first has"));
    }
    image.copyTo(cell);
  }
  return grid;
}

std::vector<std::size_t> EvenlySpaced(std::size_t count, std::size_t most) {
  std::vector<std::size_t> indices;
  const std::size_t chosen = std::min(count, most);
  for (std::size_t i = 0; i < chosen; ++i) {
    indices.push_back(chosen == 1 ? 0 : i * (count - 1) / (chosen - 1));
  }
  return indices;
}

std::string PngBytes(const cv::Mat& image) {
  return EncodeImage(".png", image, {cv::IMWRITE_PNG_COMPRESSION, 6});
}

std::string JpegBytes(const cv::Mat& image, int quality) {
  return EncodeImage(".jpg", image,
                     {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_OPTIMIZE, 1});
}

}  // namespace cvo::reports
