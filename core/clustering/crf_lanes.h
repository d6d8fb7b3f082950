// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace cvo {

inline constexpr int kCrfLanes = 8;  // labels processed at a time
inline constexpr int kCrfTile = 48;  // nodes per side of a tile of the kernel matrix

// Values of eight labels of one node. A matrix of nodes by labels is stored as a sequence of blocks
// of eight labels, each of which holds all nodes.
struct alignas(32) CrfLanes {
  using Values [[gnu::vector_size(kCrfLanes * sizeof(float))]] = float;
  Values label;
};

struct alignas(32) CrfTilePoints {
  float x[kCrfTile];  // m, relative to a nearby origin
  float y[kCrfTile];
  float z[kCrfTile];
};

struct alignas(32) CrfTile {
  float k[kCrfTile][kCrfTile];
};

// Tiles that one kernel matrix leaves to the next for reuse: allocating so much memory takes longer
// than filling it.
using CrfMemory = std::vector<CrfTile>;

// next = softmax over all labels of (weight * message - energy).
struct CrfUpdate {
  int nodes;
  int blocks;
  std::ptrdiff_t stride;  // between blocks
  const CrfLanes* energy;
  const CrfLanes* message;
  const float* weight;  // per node
  const CrfLanes* q;
  CrfLanes* next;
};

inline constexpr float kLowestCrfExponent = -18.0F;  // of the kernel, at 6 bandwidths
inline constexpr float kLowestCrfLogit = -80.0F;     // relative to a node's best label; Q = 0 below

// The inner loops of inference, in single precision and in a form that compilers vectorise for any
// processor.

// k[i][j] = exp(-|rows_i - columns_j|^2 * scale), 0 where the exponent is below -18.
void FillTile(const CrfTilePoints& rows, const CrfTilePoints& columns, float scale, CrfTile& tile);
// message_rows += k * q_columns and message_columns += k^T * q_rows, over the nodes of a tile. The
// messages may not overlap each other.
void MultiplyTile(const CrfTile& tile, const CrfLanes* q_rows, const CrfLanes* q_columns,
                  CrfLanes* message_rows, CrfLanes* message_columns);
// Returns the largest |next - q|.
float UpdateNodes(const CrfUpdate& update);

}  // namespace cvo
