// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Code for AVX2 and FMA is compiled where this is defined; all of it has a plain twin.
#if defined(__x86_64__)
#define CVO_WITH_AVX2
#endif

namespace cvo {

enum class CpuLevel { kPlain, kAvx2 };

// As OpenCV sees the processor, so that ours and its code take the same paths;
// OPENCV_CPU_DISABLE=AVX2 forces the plain ones.
CpuLevel DetectCpuLevel();

inline bool UsesAvx2() {
  static const bool uses = DetectCpuLevel() == CpuLevel::kAvx2;
  return uses;
}

// "avx2", "plain x86-64", "plain aarch64" or "plain": results of different levels differ by
// rounding.
const char* CpuLevelName();

}  // namespace cvo
