// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/options.h"
#include "core/features/options.h"

namespace cvo {

// Every option of the estimator, front end included; policies read their own group.
struct Options {
  OrbOptions orb;
  StereoMatchOptions stereo;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Group("orb", self.orb);
    visit.Group("stereo", self.stereo);
  }
};

}  // namespace cvo
