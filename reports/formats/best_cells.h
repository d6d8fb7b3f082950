// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reports/formats/table_texts.h"

namespace cvo::reports {

// Marks the best of each column among lines on the same data: the same sequence, detections and
// scene options, where the keys tell these apart, the same correction of the calibration, and
// figures of others that compare with them. All that print as the best do are marked; none where
// all do, where lines stand on different scenes, or where no direction is known to be better; nor a
// row whose coverage is 0. Returns whether any is.
bool MarkBest(const Table& table, std::vector<TextLine>& lines);

}  // namespace cvo::reports
