// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "reports/overlays/drawing/palette.h"
#include "reports/overlays/overlay_run.h"
#include "reports/runs/body_story.h"

namespace cvo::reports {

// Draws what happened to a body as one picture: `lines` of text, the timeline (BodyTimeline), and
// for every event two crops of the frame around the body, with landmarks in the colour of their
// true body on the left and as estimated on the right. `true_boxes` holds the true 2D box of the
// body by frame; where there is none, its projected true position is marked. `image` returns the
// left image of a frame, empty if there is none.
cv::Mat BodySheet(const OverlayRun& run, const BodyStory& story,
                  const std::vector<std::string>& lines, const std::map<int, PixelBox>& true_boxes,
                  const std::function<cv::Mat(int frame)>& image);

// Draws the frames of the story as horizontal bands: stage, detections, landmarks and position
// error. Events are numbered.
cv::Mat BodyTimeline(const BodyStory& story, int width_px, int text_px);

Rgb ColorOf(BodyStage stage);

}  // namespace cvo::reports
