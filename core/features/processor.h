// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

// Before a function: compiled twice, for any processor and for those with AVX2, of which
// the program takes what fits when it starts. Both compute the same: neither fuses or reorders
// arithmetic.
#if defined(__x86_64__)
#define CVO_FOR_EACH_PROCESSOR [[gnu::target_clones("avx2", "default")]]
#else
#define CVO_FOR_EACH_PROCESSOR
#endif

namespace cvo {

using SixteenBytes = std::uint8_t __attribute__((vector_size(16)));

// The bytes of `from` with the indices `at`: one instruction, but for Clang, which cannot say so.
[[gnu::always_inline]] inline SixteenBytes Pick(const SixteenBytes& from, const SixteenBytes& at) {
#if defined(__clang__)
  SixteenBytes picked;
  for (int i = 0; i < 16; ++i) picked[i] = from[at[i]];
  return picked;
#else
  return __builtin_shuffle(from, at);
#endif
}

}  // namespace cvo
