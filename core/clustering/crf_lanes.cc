// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/clustering/crf_lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cvo {
namespace {

float ExpOrZero(float x, float lowest) { return x < lowest ? 0.0F : std::exp(x); }

void Fill(const CrfTilePoints& rows, const CrfTilePoints& columns, float scale, CrfTile& tile) {
  for (int i = 0; i < kCrfTile; ++i) {
    for (int j = 0; j < kCrfTile; ++j) {
      const float dx = columns.x[j] - rows.x[i];
      const float dy = columns.y[j] - rows.y[i];
      const float dz = columns.z[j] - rows.z[i];
      tile.k[i][j] = ExpOrZero(-scale * (dx * dx + dy * dy + dz * dz), kLowestCrfExponent);
    }
  }
}

void Multiply(const CrfTile& tile, const CrfLanes* q_rows, const CrfLanes* q_columns,
              CrfLanes* message_rows, CrfLanes* message_columns) {
  for (int i = 0; i < kCrfTile; ++i) {
    CrfLanes sum = message_rows[i];
    const CrfLanes q = q_rows[i];
    for (int j = 0; j < kCrfTile; ++j) {
      const float k = tile.k[i][j];
      CrfLanes& message = message_columns[j];
      for (int l = 0; l < kCrfLanes; ++l) sum.label[l] += k * q_columns[j].label[l];
      for (int l = 0; l < kCrfLanes; ++l) message.label[l] += k * q.label[l];
    }
    message_rows[i] = sum;
  }
}

float UpdateNode(const CrfUpdate& u, int node) {
  const std::ptrdiff_t end = u.blocks * u.stride + node;
  float largest = -std::numeric_limits<float>::infinity();
  for (std::ptrdiff_t at = node; at < end; at += u.stride) {
    for (int l = 0; l < kCrfLanes; ++l) {
      u.next[at].label[l] = u.weight[node] * u.message[at].label[l] - u.energy[at].label[l];
      largest = std::max(largest, u.next[at].label[l]);
    }
  }
  float sum = 0.0F;
  for (std::ptrdiff_t at = node; at < end; at += u.stride) {
    for (float& value : u.next[at].label) {
      value = ExpOrZero(value - largest, kLowestCrfLogit);
      sum += value;
    }
  }
  float change = 0.0F;
  for (std::ptrdiff_t at = node; at < end; at += u.stride) {
    for (int l = 0; l < kCrfLanes; ++l) {
      u.next[at].label[l] /= sum;
      change = std::max(change, std::abs(u.next[at].label[l] - u.q[at].label[l]));
    }
  }
  return change;
}

float Update(const CrfUpdate& update) {
  float change = 0.0F;
  for (int node = 0; node < update.nodes; ++node) {
    change = std::max(change, UpdateNode(update, node));
  }
  return change;
}

}  // namespace

CrfLoops PlainCrfLoops() { return {Fill, Multiply, Update}; }

}  // namespace cvo
