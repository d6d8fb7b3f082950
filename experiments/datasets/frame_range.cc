// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/frame_range.h"

#include <limits>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/files/text/number.h"

namespace cvo {
namespace {

constexpr const char* kWhere = "--frames";

// Returns `if_empty` for an empty text.
int ParseFrame(std::string_view text, int if_empty, const std::string& whole) {
  if (text.empty()) return if_empty;
  const std::optional<std::int64_t> value = ParseInteger(text);
  if (!value || *value < 0 || *value > std::numeric_limits<int>::max()) {
    ThrowError(kWhere, "\"" + whole + "\"", "A:B, A: or :B with frame numbers from 0 on");
  }
  return static_cast<int>(*value);
}

}  // namespace

FrameRange ParseFrameRange(std::string_view text) {
  const std::string whole(text);
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) {
    ThrowError(kWhere, "\"" + whole + "\"", "A:B, A: or :B with frame numbers from 0 on");
  }
  const FrameRange range = {ParseFrame(text.substr(0, colon), 0, whole),
                            ParseFrame(text.substr(colon + 1), -1, whole)};
  if (range.end >= 0 && range.end <= range.begin) {
    ThrowError(kWhere, "\"" + whole + "\", an empty range", "A:B with A < B");
  }
  return range;
}

FrameRange ResolveFrameRange(const FrameRange& range, int total) {
  const FrameRange resolved = {range.begin, range.end == -1 ? total : range.end};
  if (resolved.begin < 0 || resolved.begin >= resolved.end || resolved.end > total) {
    ThrowError(kWhere, StrCat(range.begin, ":", range.end == -1 ? "" : std::to_string(range.end)),
               StrCat("a range A:B with 0 <= A < B <= ", total, ", the frames of the sequence"));
  }
  return resolved;
}

}  // namespace cvo
