// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace cvo {

// Frames begin, ..., end - 1 counted from zero; end -1: to the last.
struct FrameRange {
  int begin = 0;
  int end = -1;
};

// "A:B", "A:", ":B" or ":". Throws Error for anything else and for ranges that are empty.
FrameRange ParseFrameRange(std::string_view text);

// The range within a sequence of `total` frames, its end filled in. Throws Error where it is empty
// or reaches outside.
FrameRange ResolveFrameRange(const FrameRange& range, int total);

}  // namespace cvo
