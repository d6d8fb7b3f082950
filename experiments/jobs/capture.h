// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace cvo {

struct Captured {
  int exit_code = 0;  // 128 + signal number if a signal ended it
  std::string out;
  std::string err;
};

// Runs a short program found in PATH, without input and detached from the terminal's signals.
// `give_up` is called several times a second with the output so far; if it returns true, the
// program is killed. Throws Error if the program cannot be started.
Captured Capture(const std::vector<std::string>& argv,
                 const std::function<bool(const Captured&)>& give_up);

}  // namespace cvo
