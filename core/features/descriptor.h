// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace cvo {

// 256-bit binary descriptor (rBRIEF).
using Descriptor = std::array<std::uint64_t, 4>;

// Number of differing bits, 0 ... 256.
int HammingDistance(const Descriptor& a, const Descriptor& b);

}  // namespace cvo
