// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/crf_lanes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include "core/features/processor.h"

namespace cvo {
namespace {

using Floats = CrfLanes::Values;
using Ints [[gnu::vector_size(sizeof(Floats))]] = std::int32_t;

// Rows of the kernel matrix that are multiplied at a time: each element is loaded once for two
// products, and the operands for this many rows just fit into 16 registers.
constexpr int kRows = 6;
static_assert(kCrfTile % kRows == 0 && kCrfTile % kCrfLanes == 0);

// Vectors are passed by reference: without AVX, values of them have no agreed place.
[[gnu::always_inline]] inline void Raise(const Floats& least, Floats& x) {
  x = x > least ? x : least;
}

// x = exp(x) for x in [-87, 0] with a relative error of 3e-7; 0 below `lowest`. Computed as 2^n
// times the Taylor series of the remainder, whose magnitude is at most ln(2) / 2.
[[gnu::always_inline]] inline void ExpOrZero(float lowest, Floats& x) {
  constexpr float kRounding = 12582912.0F;  // 1.5 * 2^23: once it is added, no fraction is left
  Floats kept = x;
  Raise(Floats{} + lowest, kept);
  const Floats n = (kept * 1.44269504F + kRounding) - kRounding;
  // ln 2 is split into two parts, such that n times the first one is exact.
  const Floats r = (kept - n * 0.693359375F) + n * 2.12194440e-4F;
  Floats sum = Floats{} + 1.0F / 5040.0F;
  for (const float coefficient :
       {1.0F / 720.0F, 1.0F / 120.0F, 1.0F / 24.0F, 1.0F / 6.0F, 0.5F, 1.0F, 1.0F}) {
    sum = sum * r + coefficient;
  }
  const Ints exponent = __builtin_convertvector(n, Ints) + 127;
  x = x < lowest ? Floats{} : sum * __builtin_bit_cast(Floats, exponent << 23);
}

float Largest(const Floats& values) {
  float largest = values[0];
  for (int l = 1; l < kCrfLanes; ++l) largest = std::max(largest, values[l]);
  return largest;
}

// Updates one node. Raises `change` to |next - q|.
[[gnu::always_inline]] inline void UpdateNode(const CrfUpdate& u, int node, Floats& change) {
  const std::ptrdiff_t end = u.blocks * u.stride + node;
  Floats best = Floats{} - std::numeric_limits<float>::infinity();
  for (std::ptrdiff_t at = node; at < end; at += u.stride) {
    u.next[at].label = u.weight[node] * u.message[at].label - u.energy[at].label;
    Raise(u.next[at].label, best);
  }
  const float largest = Largest(best);
  Floats sums = {};
  for (std::ptrdiff_t at = node; at < end; at += u.stride) {
    u.next[at].label -= largest;
    ExpOrZero(kLowestCrfLogit, u.next[at].label);
    sums += u.next[at].label;
  }
  float sum = 0.0F;
  for (int l = 0; l < kCrfLanes; ++l) sum += sums[l];
  for (std::ptrdiff_t at = node; at < end; at += u.stride) {
    u.next[at].label *= 1.0F / sum;
    const Floats moved = u.next[at].label - u.q[at].label;
    Raise(moved, change);
    Raise(-moved, change);
  }
}

[[gnu::always_inline]] inline void Load(const float* from, Floats& values) {
  std::memcpy(&values, from, sizeof(values));
}

}  // namespace

CVO_FOR_EACH_PROCESSOR
void FillTile(const CrfTilePoints& rows, const CrfTilePoints& columns, float scale, CrfTile& tile) {
  for (int i = 0; i < kCrfTile; ++i) {
    for (int j = 0; j < kCrfTile; j += kCrfLanes) {
      Floats dx, dy, dz;
      Load(columns.x + j, dx);
      Load(columns.y + j, dy);
      Load(columns.z + j, dz);
      dx -= rows.x[i];
      dy -= rows.y[i];
      dz -= rows.z[i];
      Floats k = (dx * dx + dy * dy + dz * dz) * -scale;
      ExpOrZero(kLowestCrfExponent, k);
      std::memcpy(tile.k[i] + j, &k, sizeof(k));
    }
  }
}

CVO_FOR_EACH_PROCESSOR
void MultiplyTile(const CrfTile& tile, const CrfLanes* q_rows, const CrfLanes* q_columns,
                  CrfLanes* message_rows, CrfLanes* message_columns) {
  for (int first = 0; first < kCrfTile; first += kRows) {
    Floats sums[kRows];
    Floats q[kRows];
    for (int r = 0; r < kRows; ++r) {
      sums[r] = message_rows[first + r].label;
      q[r] = q_rows[first + r].label;
    }
    for (int j = 0; j < kCrfTile; ++j) {
      const Floats of_column = q_columns[j].label;
      Floats message = message_columns[j].label;
      for (int r = 0; r < kRows; ++r) {
        const float k = tile.k[first + r][j];
        sums[r] += k * of_column;
        message += k * q[r];
      }
      message_columns[j].label = message;
    }
    for (int r = 0; r < kRows; ++r) message_rows[first + r].label = sums[r];
  }
}

CVO_FOR_EACH_PROCESSOR
float UpdateNodes(const CrfUpdate& update) {
  Floats change = {};
  for (int node = 0; node < update.nodes; ++node) UpdateNode(update, node, change);
  return Largest(change);
}

}  // namespace cvo
