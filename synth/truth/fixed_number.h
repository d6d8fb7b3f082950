// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace cvo::synth {

// With this many digits after the point, in every locale.
std::string FixedNumber(double value, int digits);

// 7 as "000007", as KITTI names files.
std::string SixDigits(int number);

}  // namespace cvo::synth
