// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/glossary.h"

namespace cvo::reports {
std::vector<Term> Terms() {
  return {
      {"variant",
       "A version of the estimator. full is the complete method; the others omit or change one "
       "part."},
      {"cluster", "A set of landmarks that move together: the estimate of one object."},
      {"landmark", "A point in the scene that is seen in the images."},
      {"sequence", "A recorded or rendered image sequence with its ground truth."},
      {"seed",
       "Initial value of the random number generator. Runs that differ only in the seed show the "
       "random variation."},
      {"interval",
       "95 % confidence interval of a mean, by bootstrap over its scenes, or the bodies of a "
       "single "
       "scene. Seeds are averaged first."},
      {"split",
       "What scenes are used for: options were chosen on development scenes, results are reported "
       "on test scenes. Recorded images are given."},
      {"pair", "A scene (or body of a single scene) that is present in both rows of a difference."},
      {"occluded, predicted",
       "Hidden by another object; its pose is then given only by the motion model."},
      {"left out", "What is excluded from a value, and why."},
  };
}

}  // namespace cvo::reports
