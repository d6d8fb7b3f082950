// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/descriptor.h"

#include <bit>

#include "core/features/processor.h"

namespace cvo {

namespace {

[[gnu::always_inline]] inline int Distance(const Descriptor& a, const Descriptor& b) {
  return std::popcount(a[0] ^ b[0]) + std::popcount(a[1] ^ b[1]) + std::popcount(a[2] ^ b[2]) +
         std::popcount(a[3] ^ b[3]);
}

}  // namespace

CVO_FOR_EACH_PROCESSOR
int HammingDistance(const Descriptor& a, const Descriptor& b) { return Distance(a, b); }

CVO_FOR_EACH_PROCESSOR
void HammingDistances(const Descriptor& from, std::span<const Descriptor> to,
                      std::span<int> distances) {
  for (std::size_t i = 0; i < to.size(); ++i) distances[i] = Distance(from, to[i]);
}

}  // namespace cvo
