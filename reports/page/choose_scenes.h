// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/page/page_content.h"

namespace cvo::reports {

struct SceneChoice {
  std::vector<std::pair<std::size_t, bool>> scenes;  // run, and whether its images are wanted
  std::size_t left_out = 0;
};

// The runs to be looked at, at most `most`: per sequence the lowest seed of each estimator, those
// with images first. Images are of one estimator: `full`, else the table's reference, else the
// first one of the sequence. Where there are more runs than that, failures first: those that keep
// the smallest part of their moving bodies within 10 cm.
SceneChoice ChooseScenes(const std::vector<PageRun>& runs, const std::string& reference,
                         std::size_t most);

}  // namespace cvo::reports
