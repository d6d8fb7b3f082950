// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cvo {

// The exit code of what such a signal stopped.
inline constexpr int kStopped = 130;

// While one exists, the first SIGINT or SIGTERM is only noted; the next one ends the program.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  bool Requested() const;
};

}  // namespace cvo
