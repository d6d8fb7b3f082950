// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "reports/overlays/overlay_run.h"

namespace cvo::reports {

// What is drawn, and how large. See StyleFor.
struct OverlayStyle {
  double scale = 1.0;  // applied to the image before anything is drawn on it
  int text_px = 9;     // height of a capital letter
  int line_px = 2;
  double landmark_px = 2.6;  // radius of a landmark on a body
  double static_px = 1.1;
  bool names = true;   // the class beside the id
  bool boxes = true;   // 3D boxes and tails; detections and landmarks are always drawn
  bool wrong = false;  // a white ring around landmarks with a wrong label, if the truth is known
  bool status = true;  // a line of text below the image
  bool inset = false;  // a view of the bodies from above in the top left corner
  bool plain = false;  // the image with its marks alone: no names, status and inset
};

// The style for drawings of this width, from thumbnails to full screens.
OverlayStyle StyleFor(const CameraInfo& camera, int width_px);

// Draws what is known of a frame on its left image (8 bit grey or BGR, of the camera's size).
// Returns 8 bit BGR, scaled by `style.scale`, and higher than the image by the line of text. Equal
// input gives equal pixels. Throws Error for an image of another size or type.
cv::Mat DrawOverlay(const cv::Mat& image, const OverlayFrame& frame, const CameraInfo& camera,
                    const OverlayStyle& style);

// The same as SVG: marks and names as vectors over the image; neither status nor inset.
std::string OverlaySvg(const cv::Mat& image, const OverlayFrame& frame, const CameraInfo& camera,
                       const OverlayStyle& style);

// Draws a view of the bodies from above over what `picture` already shows. The camera is at the
// middle of the lower edge, looking up.
void DrawBirdsEye(const OverlayFrame& frame, const CameraInfo& camera, const OverlayStyle& style,
                  cv::Mat& picture);

// What a picture shows, in words: "full, seed 1  frame 40  1.33 s  tracked  7 bodies ...".
std::string StatusText(const OverlayFrame& frame);

// Height of the line of text in pixels.
int StatusHeight(const OverlayStyle& style);

}  // namespace cvo::reports
