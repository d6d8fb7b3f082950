// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/crf_lanes.h"
#include "core/features/cpu_level.h"

#if defined(CVO_WITH_AVX2)
#include <immintrin.h>

#include <algorithm>
#include <limits>
#endif

namespace cvo {

#if defined(CVO_WITH_AVX2)
namespace {

// Rows of the kernel matrix that are multiplied at a time. Each element is loaded once for two
// products, and the operands for this many rows just fit into the 16 registers.
constexpr int kRows = 6;
static_assert(kCrfTile % kRows == 0 && kCrfTile % kCrfLanes == 0);

// exp(x) for x in [-87, 0] with a relative error of 2e-7; 0 below `lowest`. Computed as 2^n times
// the Taylor series of the remainder, whose magnitude is at most ln(2) / 2.
__attribute__((target("avx2,fma"), always_inline)) inline __m256 ExpOrZero(__m256 x,
                                                                           __m256 lowest) {
  const __m256 is_kept = _mm256_cmp_ps(x, lowest, _CMP_GE_OQ);
  const __m256 kept = _mm256_max_ps(x, lowest);
  const __m256 n = _mm256_round_ps(_mm256_mul_ps(kept, _mm256_set1_ps(1.44269504F)),
                                   _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
  // ln 2 is split into two parts, such that n times the first one is exact.
  __m256 r = _mm256_fnmadd_ps(n, _mm256_set1_ps(0.693359375F), kept);
  r = _mm256_fmadd_ps(n, _mm256_set1_ps(2.12194440e-4F), r);
  __m256 sum = _mm256_set1_ps(1.0F / 5040.0F);
  for (const float coefficient :
       {1.0F / 720.0F, 1.0F / 120.0F, 1.0F / 24.0F, 1.0F / 6.0F, 0.5F, 1.0F, 1.0F}) {
    sum = _mm256_fmadd_ps(sum, r, _mm256_set1_ps(coefficient));
  }
  const __m256i exponent = _mm256_add_epi32(_mm256_cvtps_epi32(n), _mm256_set1_epi32(127));
  const __m256 power = _mm256_castsi256_ps(_mm256_slli_epi32(exponent, 23));
  return _mm256_and_ps(_mm256_mul_ps(sum, power), is_kept);
}

__attribute__((target("avx2,fma"))) void Fill(const CrfTilePoints& rows,
                                              const CrfTilePoints& columns, float scale,
                                              CrfTile& tile) {
  const __m256 lowest = _mm256_set1_ps(kLowestCrfExponent);
  const __m256 minus_scale = _mm256_set1_ps(-scale);
  for (int i = 0; i < kCrfTile; ++i) {
    const __m256 x = _mm256_set1_ps(rows.x[i]);
    const __m256 y = _mm256_set1_ps(rows.y[i]);
    const __m256 z = _mm256_set1_ps(rows.z[i]);
    for (int j = 0; j < kCrfTile; j += kCrfLanes) {
      const __m256 dx = _mm256_sub_ps(_mm256_load_ps(columns.x + j), x);
      const __m256 dy = _mm256_sub_ps(_mm256_load_ps(columns.y + j), y);
      const __m256 dz = _mm256_sub_ps(_mm256_load_ps(columns.z + j), z);
      const __m256 square = _mm256_fmadd_ps(dx, dx, _mm256_fmadd_ps(dy, dy, _mm256_mul_ps(dz, dz)));
      _mm256_store_ps(tile.k[i] + j, ExpOrZero(_mm256_mul_ps(square, minus_scale), lowest));
    }
  }
}

__attribute__((target("avx2,fma"))) void Multiply(const CrfTile& tile, const CrfLanes* q_rows,
                                                  const CrfLanes* q_columns, CrfLanes* message_rows,
                                                  CrfLanes* message_columns) {
  for (int first = 0; first < kCrfTile; first += kRows) {
    __m256 sums[kRows];
    __m256 q[kRows];
    for (int r = 0; r < kRows; ++r) {
      sums[r] = _mm256_load_ps(message_rows[first + r].label);
      q[r] = _mm256_load_ps(q_rows[first + r].label);
    }
    for (int j = 0; j < kCrfTile; ++j) {
      const __m256 of_column = _mm256_load_ps(q_columns[j].label);
      __m256 message = _mm256_load_ps(message_columns[j].label);
      for (int r = 0; r < kRows; ++r) {
        const __m256 k = _mm256_broadcast_ss(&tile.k[first + r][j]);
        sums[r] = _mm256_fmadd_ps(k, of_column, sums[r]);
        message = _mm256_fmadd_ps(k, q[r], message);
      }
      _mm256_store_ps(message_columns[j].label, message);
    }
    for (int r = 0; r < kRows; ++r) _mm256_store_ps(message_rows[first + r].label, sums[r]);
  }
}

__attribute__((target("avx2,fma"), always_inline)) inline float Largest(__m256 values) {
  __m128 half = _mm_max_ps(_mm256_castps256_ps128(values), _mm256_extractf128_ps(values, 1));
  half = _mm_max_ps(half, _mm_movehl_ps(half, half));
  return _mm_cvtss_f32(_mm_max_ss(half, _mm_movehdup_ps(half)));
}

__attribute__((target("avx2,fma"), always_inline)) inline float Sum(__m256 values) {
  __m128 half = _mm_add_ps(_mm256_castps256_ps128(values), _mm256_extractf128_ps(values, 1));
  half = _mm_add_ps(half, _mm_movehl_ps(half, half));
  return _mm_cvtss_f32(_mm_add_ss(half, _mm_movehdup_ps(half)));
}

// Updates one node. Returns the elementwise maximum of `change` and |next - q|.
__attribute__((target("avx2,fma"), always_inline)) inline __m256 UpdateNode(const CrfUpdate& u,
                                                                            int node,
                                                                            __m256 change) {
  const std::ptrdiff_t end = u.blocks * u.stride + node;
  const __m256 weight = _mm256_set1_ps(u.weight[node]);
  __m256 best = _mm256_set1_ps(-std::numeric_limits<float>::infinity());
  for (std::ptrdiff_t at = node; at < end; at += u.stride) {
    const __m256 logit = _mm256_fmsub_ps(weight, _mm256_load_ps(u.message[at].label),
                                         _mm256_load_ps(u.energy[at].label));
    best = _mm256_max_ps(best, logit);
    _mm256_store_ps(u.next[at].label, logit);
  }
  const __m256 largest = _mm256_set1_ps(Largest(best));
  const __m256 lowest = _mm256_set1_ps(kLowestCrfLogit);
  __m256 sum = _mm256_setzero_ps();
  for (std::ptrdiff_t at = node; at < end; at += u.stride) {
    const __m256 logit = _mm256_sub_ps(_mm256_load_ps(u.next[at].label), largest);
    const __m256 value = ExpOrZero(logit, lowest);
    sum = _mm256_add_ps(sum, value);
    _mm256_store_ps(u.next[at].label, value);
  }
  const __m256 share = _mm256_set1_ps(1.0F / Sum(sum));
  const __m256 sign = _mm256_set1_ps(-0.0F);
  for (std::ptrdiff_t at = node; at < end; at += u.stride) {
    const __m256 next = _mm256_mul_ps(_mm256_load_ps(u.next[at].label), share);
    const __m256 moved = _mm256_sub_ps(next, _mm256_load_ps(u.q[at].label));
    change = _mm256_max_ps(change, _mm256_andnot_ps(sign, moved));
    _mm256_store_ps(u.next[at].label, next);
  }
  return change;
}

__attribute__((target("avx2,fma"))) float Update(const CrfUpdate& update) {
  __m256 change = _mm256_setzero_ps();
  for (int node = 0; node < update.nodes; ++node) change = UpdateNode(update, node, change);
  return Largest(change);
}

}  // namespace
#endif

CrfLoops FastCrfLoops() {
#if defined(CVO_WITH_AVX2)
  if (UsesAvx2()) return {Fill, Multiply, Update};
#endif
  return PlainCrfLoops();
}

}  // namespace cvo
