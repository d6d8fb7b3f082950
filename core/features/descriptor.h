// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace cvo {

// 256-bit binary descriptor (rBRIEF).
using Descriptor = std::array<std::uint64_t, 4>;

// Number of differing bits, 0 ... 256.
int HammingDistance(const Descriptor& a, const Descriptor& b);
// The same, of one descriptor from each of the others.
void HammingDistances(const Descriptor& from, std::span<const Descriptor> to,
                      std::span<int> distances);

}  // namespace cvo
