// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/features/cpu_level.h"

#include <opencv2/core/utility.hpp>

namespace cvo {

CpuLevel DetectCpuLevel() {
#if defined(CVO_WITH_AVX2)
  if (cv::checkHardwareSupport(CV_CPU_AVX2) && cv::checkHardwareSupport(CV_CPU_FMA3)) {
    return CpuLevel::kAvx2;
  }
#endif
  return CpuLevel::kPlain;
}

const char* CpuLevelName() {
  if (UsesAvx2()) return "avx2";
#if defined(__x86_64__)
  return "plain x86-64";
#elif defined(__aarch64__)
  return "plain aarch64";
#else
  return "plain";
#endif
}

}  // namespace cvo
