// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/association/cluster_association_options.h"
#include "core/association/matching.h"
#include "core/base/options.h"
#include "core/clustering/crf_options.h"
#include "core/estimation/double_track.h"
#include "core/features/options.h"
#include "core/interface/body_box_options.h"
#include "core/interface/cluster_options.h"
#include "core/solvers/motion_prior.h"
#include "core/solvers/reprojection_cost.h"
#include "core/solvers/window_solver.h"

namespace cvo {

// All options of the estimator, including the front end.
struct Options {
  OrbOptions orb;
  StereoMatchOptions stereo;
  NoiseOptions noise;
  MatchingOptions matching;
  TrackingOptions tracking;
  WindowOptions window;
  SolverOptions solver;
  ClusterAssociationOptions association;
  UnaryOptions unary;
  PairwiseOptions pairwise;
  MotionPriorOptions motion_prior;
  ClusterOptions clusters;
  BodyBoxOptions boxes;

  FeatureNoise NoiseOfFeatures() const { return {noise, orb.scale_factor}; }
  // A length of 0 in the options stands for the length of T_t.
  int LiveFrames() const {
    return clusters.live_frames > 0 ? clusters.live_frames : window.temporal;
  }

  // Throws Error naming the first invalid option.
  void Check() const {
    CheckRanges(*this);
    orb.Check();
    stereo.Check();
  }

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor& visit) {
    visit.Group("orb", self.orb);
    visit.Group("stereo", self.stereo);
    visit.Group("noise", self.noise);
    visit.Group("matching", self.matching);
    visit.Group("tracking", self.tracking);
    visit.Group("window", self.window);
    visit.Group("solver", self.solver);
    visit.Group("association", self.association);
    visit.Group("unary", self.unary);
    visit.Group("pairwise", self.pairwise);
    visit.Group("motion_prior", self.motion_prior);
    visit.Group("clusters", self.clusters);
    visit.Group("boxes", self.boxes);
  }
};

}  // namespace cvo
