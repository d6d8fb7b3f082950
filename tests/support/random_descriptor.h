// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/rng.h"
#include "core/features/descriptor.h"

namespace cvo::test {

// Unlike any other, for all that matching can tell.
inline Descriptor RandomDescriptor(Rng& rng) {
  return {rng.NextU64(), rng.NextU64(), rng.NextU64(), rng.NextU64()};
}

}  // namespace cvo::test
