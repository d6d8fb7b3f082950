// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// If defined, code for AVX2 and FMA is compiled. All such code has a plain counterpart.
#if defined(__x86_64__)
#define CVO_WITH_AVX2
#endif

namespace cvo {

enum class CpuLevel { kPlain, kAvx2 };

// Detects the processor as OpenCV sees it, so that our code and that of OpenCV take the same paths.
// OPENCV_CPU_DISABLE=AVX2 forces the plain ones.
CpuLevel DetectCpuLevel();

inline bool UsesAvx2() {
  static const bool uses = DetectCpuLevel() == CpuLevel::kAvx2;
  return uses;
}

// Returns "avx2", "plain x86-64", "plain aarch64" or "plain". Results of different levels differ by
// rounding.
const char* CpuLevelName();

}  // namespace cvo
