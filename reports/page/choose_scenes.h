// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/page/page_content.h"

namespace cvo::reports {

struct SceneChoice {
  std::vector<std::pair<std::size_t, bool>> scenes;  // index of the run, images wanted
  std::size_t left_out = 0;
};

// Chooses at most `most` runs to be shown frame by frame: per sequence the lowest seed of each
// estimator, those with images first. Images are shown for one estimator per sequence: `full`, else
// the reference of the table, else the first one of the sequence. If there are more than `most`
// runs, failures come first: those with the smallest share of frames of moving bodies within 10 cm.
SceneChoice ChooseScenes(const std::vector<PageRun>& runs, const std::string& reference,
                         std::size_t most);

}  // namespace cvo::reports
