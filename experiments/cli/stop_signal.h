// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cvo {

// Exit code of a command that was stopped by SIGINT or SIGTERM.
inline constexpr int kStopped = 130;

// While an instance exists, the first SIGINT and the first SIGTERM are only recorded; a second
// signal of the same kind ends the program.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  bool Requested() const;
};

}  // namespace cvo
