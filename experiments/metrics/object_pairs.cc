// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/object_pairs.h"

#include <cmath>

namespace cvo {
namespace {

std::optional<PairedBody> PairErrors(const BodyScore& a, const BodyScore& b) {
  PairedBody pair;
  pair.id = a.id;
  double sum_a = 0.0;
  double sum_b = 0.0;
  auto other = b.errors.begin();
  for (const ObjectFrameError& error : a.errors) {
    while (other != b.errors.end() && other->frame < error.frame) ++other;
    if (other == b.errors.end()) break;
    if (other->frame != error.frame) continue;
    sum_a += error.position_m * error.position_m;
    sum_b += other->position_m * other->position_m;
    ++pair.frames;
  }
  if (pair.frames == 0) return std::nullopt;
  pair.ate_a_m = std::sqrt(sum_a / pair.frames);
  pair.ate_b_m = std::sqrt(sum_b / pair.frames);
  return pair;
}

}  // namespace

std::vector<PairedBody> PairBodies(const std::vector<BodyScore>& a,
                                   const std::vector<BodyScore>& b) {
  std::vector<PairedBody> pairs;
  auto other = b.begin();
  for (const BodyScore& body : a) {
    while (other != b.end() && other->id < body.id) ++other;
    if (other == b.end()) break;
    if (other->id != body.id || !body.mover) continue;
    if (const auto pair = PairErrors(body, *other)) pairs.push_back(*pair);
  }
  return pairs;
}

std::optional<PairedAte> MeanPairedAte(const std::vector<PairedBody>& pairs) {
  if (pairs.empty()) return std::nullopt;
  PairedAte mean;
  for (const PairedBody& pair : pairs) {
    mean.ate_a_m += pair.ate_a_m;
    mean.ate_b_m += pair.ate_b_m;
    mean.frames += pair.frames;
  }
  mean.bodies = static_cast<int>(pairs.size());
  mean.ate_a_m /= mean.bodies;
  mean.ate_b_m /= mean.bodies;
  return mean;
}

}  // namespace cvo
