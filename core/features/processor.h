// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Before a function: compiled twice, for any processor and for those with AVX2, of which
// the program takes what fits when it starts. Both compute the same: neither fuses or reorders
// arithmetic.
#if defined(__x86_64__)
#define CVO_FOR_EACH_PROCESSOR [[gnu::target_clones("avx2", "default")]]
#else
#define CVO_FOR_EACH_PROCESSOR
#endif
