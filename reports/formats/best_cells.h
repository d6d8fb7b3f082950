// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/formats/table_texts.h"

namespace cvo::reports {

// Marks the best cells of each column among lines on the same data: the same sequence, detections
// and scene options, if the keys distinguish these, and the same correction of the calibration.
// Published figures that are comparable with them compete too. All cells that print the same as the
// best are marked. Nothing is marked if all print the same, if the lines cover different scenes, or
// if no direction is known to be better; nor is a row whose coverage is 0. Returns whether any cell
// is marked.
bool MarkBest(const Table& table, std::vector<TextLine>& lines);

}  // namespace cvo::reports
