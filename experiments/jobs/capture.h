// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace cvo {

struct Captured {
  int exit_code = 0;  // 128 + signal where one ended it
  std::string out;
  std::string err;
};

// Runs a short program, found by PATH, without input and away from the terminal's signals.
// `give_up` is asked several times a second with what was printed so far: true kills the program.
// Throws Error where it cannot be started.
Captured Capture(const std::vector<std::string>& argv,
                 const std::function<bool(const Captured&)>& give_up);

}  // namespace cvo
