// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "reports/runs/body_story.h"

namespace cvo::reports {

// Describes what happened to the body as a whole: the number of frames by stage, and the cause.
std::vector<std::string> StoryLines(const BodyStory& story);

// Describes what is known about a frame: landmarks, detection, error, energies of the labels.
// `bodies` provides the names of other bodies.
std::vector<std::string> FrameLines(const BodyStory& story, const BodyFrame& frame,
                                    const std::vector<BodyDetail>& bodies);

}  // namespace cvo::reports
