// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "reports/overlays/drawing/overlay_frame.h"

namespace cvo::reports {

enum class Corner { kTopLeft, kTopRight, kBottomLeft, kBottomRight };

// How large things are drawn; see StyleFor.
struct OverlayStyle {
  double scale = 1.0;        // of the image, before anything is drawn on it
  int text_px = 9;           // height of a capital letter
  int line_px = 2;           // edges of the 3D boxes and arrows
  double landmark_px = 2.6;  // radius of a landmark of a body
  double static_px = 1.1;
  double rim_px = 1.0;  // dark, around landmarks
  double dash_px = 7.0;
  bool names = true;  // a class beside the id
  bool boxes = true;  // 3D boxes, arrows and trails; detections and landmarks are always drawn
  bool associations = false;  // boxes of detections in their cluster's colour, or dashed
  bool wrong = false;  // landmarks with a wrong label have a white ring, where the truth is known
  bool status = true;  // words below the image
  int status_rows = 1;
  bool inset = false;  // the bodies from above
  Corner inset_corner = Corner::kTopLeft;
  bool legend = false;  // what the marks mean, below the image
  // What there is in some frame of the run: the legend has nothing else.
  bool has_landmarks = true;
  bool has_detections = true;
  bool has_clusters = true;
};

// For drawings that are this wide, from thumbnails to screens.
OverlayStyle StyleFor(const CameraInfo& camera, int width_px);

// The inset's place in pictures of this camera.
cv::Rect InsetRect(const CameraInfo& scaled, const OverlayStyle& style, Corner corner);

// Left image (8 bit grey or BGR, of the camera's size) with what is known of the frame drawn on it;
// 8 bit BGR, higher than the image by the status line. Throws Error for an image of another size.
cv::Mat DrawOverlay(const cv::Mat& image, const OverlayFrame& frame, const CameraInfo& camera,
                    const OverlayStyle& style);

// The words of the status line, the most important first; the last is for the right end.
std::vector<std::string> StatusWords(const OverlayFrame& frame, const CameraInfo& camera);

// What the marks of this style mean, in as many rows as it needs; the same for all frames.
cv::Mat LegendBar(const OverlayStyle& style, int width_px);

// The bodies from above on what the picture already is: the camera at the middle of its lower edge,
// what is ahead of it upwards.
void DrawBirdsEye(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                  cv::Mat& picture);

// A bar of as many rows of text as it is high, with as many of the words as have room; the last of
// several is at the right end of the first row.
void DrawBar(const std::vector<std::string>& words, int text_px, cv::Mat& bar);
int BarHeight(int text_px, int rows);

}  // namespace cvo::reports
