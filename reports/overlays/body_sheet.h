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

// What happened to a body in one picture: `lines` of text, its frames by stage with detections,
// landmarks and error, and for every event its surroundings twice, with landmarks in the colour of
// their true body and as estimated. `true_boxes`: of the body, by frame; where there is none, its
// true position is marked. `image` gives the left image of a frame; empty: not there.
cv::Mat BodySheet(const OverlayRun& run, const BodyStory& story,
                  const std::vector<std::string>& lines, const std::map<int, PixelBox>& true_boxes,
                  const std::function<cv::Mat(int frame)>& image);

// The frames as bands: stage, detections, landmarks, error; events are numbered.
cv::Mat BodyTimeline(const BodyStory& story, int width_px, int text_px);

Rgb ColorOf(BodyStage stage);

}  // namespace cvo::reports
