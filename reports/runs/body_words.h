// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/runs/body_story.h"

namespace cvo::reports {

// What happened to the body as a whole: its count of frames by stage, and the cause.
std::vector<std::string> StoryLines(const BodyStory& story);

// What is known of a frame: landmarks, detection, error, energies of the labels. `bodies` gives
// other bodies their names.
std::vector<std::string> FrameLines(const BodyStory& story, const BodyFrame& frame,
                                    const std::vector<BodyDetail>& bodies);

}  // namespace cvo::reports
