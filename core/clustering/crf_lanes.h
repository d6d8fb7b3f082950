// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace cvo {

inline constexpr int kCrfLanes = 8;  // labels that are worked on at a time
inline constexpr int kCrfTile = 48;  // nodes in a side of a piece of the kernel matrix

// Eight labels of a node. A matrix of nodes by labels is a sequence of blocks of eight labels, each
// with all nodes.
struct alignas(32) CrfLanes {
  float label[kCrfLanes];
};

struct alignas(32) CrfTilePoints {
  float x[kCrfTile];  // m, from an origin near by
  float y[kCrfTile];
  float z[kCrfTile];
};

struct alignas(32) CrfTile {
  float k[kCrfTile][kCrfTile];
};

// What a matrix leaves to the next one: the system takes longer to give so much than the kernel to
// fill it.
using CrfMemory = std::vector<CrfTile>;

// next = softmax over all labels of (weight * message - energy).
struct CrfUpdate {
  int nodes;
  int blocks;
  std::ptrdiff_t stride;  // from block to block
  const CrfLanes* energy;
  const CrfLanes* message;
  const float* weight;  // by node
  const CrfLanes* q;
  CrfLanes* next;
};

inline constexpr float kLowestCrfExponent = -18.0F;  // of the kernel: 6 bandwidths
inline constexpr float kLowestCrfLogit = -80.0F;     // less than the best of a node by more: Q = 0

// The inner loops of inference, for one kind of processor. Single precision; the exponentials of
// the two kinds differ by at most 3e-7 of their value.
struct CrfLoops {
  // k[i][j] = exp(-|rows_i - columns_j|^2 * scale), 0 where the exponent is below -18.
  void (*fill)(const CrfTilePoints& rows, const CrfTilePoints& columns, float scale, CrfTile& tile);
  // message_rows += k * q_columns and message_columns += k^T * q_rows; a tile's nodes each.
  void (*multiply)(const CrfTile& tile, const CrfLanes* q_rows, const CrfLanes* q_columns,
                   CrfLanes* message_rows, CrfLanes* message_columns);
  // Largest |next - q|.
  float (*update)(const CrfUpdate& update);
};

CrfLoops PlainCrfLoops();
// With AVX2 and FMA where the processor has them, else the plain ones.
CrfLoops FastCrfLoops();

}  // namespace cvo
