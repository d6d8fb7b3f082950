// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace cvo {

// Frames begin, ..., end - 1, counted from zero. An end of -1 means up to the last frame.
struct FrameRange {
  int begin = 0;
  int end = -1;
};

// Parses "A:B", "A:", ":B" or ":". Throws Error for anything else and for empty ranges.
FrameRange ParseFrameRange(std::string_view text);

// Returns the range within a sequence of `total` frames, with its end filled in. Throws Error if
// the range is empty or exceeds the sequence.
FrameRange ResolveFrameRange(const FrameRange& range, int total);

}  // namespace cvo
