// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/descriptor.h"

#include <bit>

#include "core/features/cpu_level.h"

namespace cvo {
namespace {

#if defined(CVO_WITH_AVX2)
__attribute__((target("popcnt"))) int HammingDistancePopcnt(const Descriptor& a,
                                                            const Descriptor& b) {
  return std::popcount(a[0] ^ b[0]) + std::popcount(a[1] ^ b[1]) + std::popcount(a[2] ^ b[2]) +
         std::popcount(a[3] ^ b[3]);
}
#endif

}  // namespace

// Counts bits in parallel within each word (Warren, Hacker's Delight, 5-1).
int HammingDistancePlain(const Descriptor& a, const Descriptor& b) {
  constexpr std::uint64_t kPairs = 0x5555555555555555u;
  constexpr std::uint64_t kFours = 0x3333333333333333u;
  constexpr std::uint64_t kBytes = 0x0F0F0F0F0F0F0F0Fu;
  std::uint64_t counts = 0;  // by byte, at most 4 * 8
  for (std::size_t word = 0; word < a.size(); ++word) {
    std::uint64_t x = a[word] ^ b[word];
    x -= (x >> 1) & kPairs;
    x = (x & kFours) + ((x >> 2) & kFours);
    counts += (x + (x >> 4)) & kBytes;
  }
  // Sums up in 16-bit lanes, as 256 does not fit into a byte.
  constexpr std::uint64_t kLow = 0x00FF00FF00FF00FFu;
  counts = (counts & kLow) + ((counts >> 8) & kLow);
  return static_cast<int>((counts * 0x0001000100010001u) >> 48);
}

int HammingDistance(const Descriptor& a, const Descriptor& b) {
#if defined(CVO_WITH_AVX2)
  if (UsesAvx2()) return HammingDistancePopcnt(a, b);
#endif
  return HammingDistancePlain(a, b);
}

}  // namespace cvo
