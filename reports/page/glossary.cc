// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/page/glossary.h"

namespace cvo::reports {
std::vector<Term> Terms() {
  return {
      {"variant",
       "One form of the estimator. full is the whole method; the others lack or change one part."},
      {"cluster", "A set of landmarks that move together: the estimate of one object."},
      {"landmark", "A point in the scene that is seen in the images."},
      {"sequence", "A recorded or rendered drive of images with its truth."},
      {"seed",
       "A number that starts the random draws. Runs that differ only in the seed show how much is "
       "chance."},
      {"interval",
       "Where 95 % of the values lie when the bodies (or scenes) that a mean is made of are drawn "
       "again at random. Seeds are averaged first."},
      {"pair", "A body or scene that both rows of a difference have."},
      {"occluded, predicted", "Hidden by something else; then only the motion model says where."},
      {"left out", "What does not count in a value, and why."},
  };
}

}  // namespace cvo::reports
