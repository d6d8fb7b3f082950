// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "reports/overlays/drawing/overlay_frame.h"

namespace cvo::reports {

enum class Corner { kTopLeft, kTopRight, kBottomLeft, kBottomRight };

// What is drawn, and how large. See StyleFor.
struct OverlayStyle {
  double scale = 1.0;        // applied to the image before anything is drawn on it
  int text_px = 9;           // height of a capital letter
  int line_px = 2;           // edges of the 3D boxes and arrows
  double landmark_px = 2.6;  // radius of a landmark on a body
  double static_px = 1.1;
  double rim_px = 1.0;  // width of the dark rim around landmarks
  double dash_px = 7.0;
  bool names = true;  // the class beside the id
  bool boxes = true;  // 3D boxes, arrows and trails; detections and landmarks are always drawn
  bool associations = false;  // detections in their cluster's colour; dashed if they have none
  bool wrong = false;  // a white ring around landmarks with a wrong label, if the truth is known
  bool status = true;  // a status line below the image
  int status_rows = 1;
  bool inset = false;  // a view of the bodies from above
  Corner inset_corner = Corner::kTopLeft;
  bool legend = false;  // explains the marks, below the image
  // What occurs in at least one frame of the run. The legend explains nothing else.
  bool has_landmarks = true;
  bool has_detections = true;
  bool has_clusters = true;
};

// The style for drawings of this width, from thumbnails to full screens.
OverlayStyle StyleFor(const CameraInfo& camera, int width_px);

// The rectangle of the inset in pictures of this scaled camera.
cv::Rect InsetRect(const CameraInfo& scaled, const OverlayStyle& style, Corner corner);

// Draws what is known of a frame on its left image (8 bit grey or BGR, of the camera's size).
// Returns 8 bit BGR, scaled by `style.scale`, and higher than the image by the status line and the
// legend. Throws Error for an image of another size or type.
cv::Mat DrawOverlay(const cv::Mat& image, const OverlayFrame& frame, const CameraInfo& camera,
                    const OverlayStyle& style);

// The parts of the status line, the most important first. The last one belongs at the right end.
std::vector<std::string> StatusWords(const OverlayFrame& frame, const CameraInfo& camera);

// Draws the legend of the marks of this style, in as many rows as it needs. It is the same for all
// frames.
cv::Mat LegendBar(const OverlayStyle& style, int width_px);

// Draws a view of the bodies from above over what `picture` already shows. The camera is at the
// middle of the lower edge, looking up.
void DrawBirdsEye(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                  cv::Mat& picture);

// Fills `bar` with text: as many rows as its height allows, and as many of the words as fit. If
// there are several, the last one is at the right end of the first row.
void DrawBar(const std::vector<std::string>& words, int text_px, cv::Mat& bar);
int BarHeight(int text_px, int rows);

}  // namespace cvo::reports
