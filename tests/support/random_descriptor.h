// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/rng.h"
#include "core/features/descriptor.h"

namespace cvo::test {

// Returns a random descriptor: unique as far as matching is concerned.
inline Descriptor RandomDescriptor(Rng& rng) {
  return {rng.NextU64(), rng.NextU64(), rng.NextU64(), rng.NextU64()};
}

}  // namespace cvo::test
