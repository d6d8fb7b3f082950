// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <optional>
#include <vector>

#include "core/clustering/crf_options.h"
#include "core/clustering/dense_crf.h"
#include "core/clustering/label_matching.h"
#include "core/clustering/unary_terms.h"
#include "core/labelling/new_bodies.h"

namespace cvo {

// The nodes and classes of the CRF in one frame. The M = N1 + N2 + 1 classes are, in this order,
// the static scene and the live clusters, the detections that belong to none of them, and the
// outlier class.
struct LabelScene {
  CrfScene crf;                    // one node per point
  std::vector<int> detection;      // per label: that of the cluster or new box; -1: none
  std::vector<BodyId> given_body;  // per label, see GivenKnowledge; invalid: unknown
  int clusters = 0;                // labels 1 ... clusters are map.live[0], ...

  int Outlier() const { return static_cast<int>(crf.labels.size()) - 1; }
  bool IsNewBox(int label) const { return label > clusters && label < Outlier(); }
};

// Options of BuildLabelScene.
struct LabelSceneOptions {
  FeatureNoise noise;
  UnaryOptions unary;
  ExtentOptions extent;
  ClusterOptions clusters;
};

// Collects what is known of every point and every class (section 3.2 of the paper). The current
// frame is the one after the newest frame of the window.
LabelScene BuildLabelScene(const FrameView& view, const LabelSceneOptions& options,
                           const Window& window, const ClusterMap& map,
                           const std::vector<ClusterTrack>& tracks,
                           const std::vector<FramePoint>& points, const NewBodyRule& new_body);

// Labels of one point of the current frame.
struct PointLabel {
  ClusterId inferred;      // by the CRF; invalid: outlier
  LabelState assigned;     // q^i and w^i after the confidence rule; invalid: of no body
  LandmarkId landmark;     // that it observes (set by UpdateLandmarks); invalid: none
  double energy_2d = 0.0;  // of the inferred label, nats
  double energy_3d = 0.0;
  double energy_motion = 0.0;
  ClusterId second;  // the other label with the lowest unary energy; invalid: outlier
  double second_2d = 0.0;
  double second_3d = 0.0;
  double second_motion = 0.0;
};

// Labels of all points of a frame, and the detections that became clusters or join existing ones.
struct FrameLabels {
  std::vector<PointLabel> points;
  struct Birth {
    ClusterId id;
    int detection = -1;  // index; -1: from given labels alone
    BodyId given_body;
  };
  std::vector<Birth> births;  // sorted by id, consecutive from map.next
  // A detection that label matching (Kuhn-Munkres) assigned to a live cluster.
  struct Adoption {
    ClusterId id;
    int detection = -1;
  };
  std::vector<Adoption> adoptions;
};

namespace internal {

// Returns for each node the most probable label, or that of its given body if there is one.
std::vector<int> DecideLabels(const FrameView& view, const std::vector<FramePoint>& points,
                              const LabelScene& scene, const CrfResult& crf);
// Inputs of MatchLabels: what the labels represent, and the decided labels and previous clusters of
// the points that have a landmark.
struct DecidedLabels {
  std::vector<LabelIdentity> identities;
  std::vector<int> label_of_old;
  std::vector<ClusterId> previous;
};
DecidedLabels DescribeDecision(const Window& window, const ClusterMap& map,
                               const std::vector<FramePoint>& points, const LabelScene& scene,
                               const std::vector<int>& decided);
// Turns the clusters that labels were matched with into adoptions and births: a label that
// continues a cluster other than its own is an adoption; a label without a cluster is a birth and
// gets the next id, from map.next on, which is also written to cluster_of.
void NameLabels(const ClusterMap& map, const LabelScene& scene, std::vector<ClusterId>& cluster_of,
                FrameLabels& labels);
// Removes births with fewer than `min_landmarks` accepted points and renumbers the others.
void DropWeakBirths(int min_landmarks, const Window& window, const ClusterMap& map,
                    const std::vector<FramePoint>& points, FrameLabels& labels);
// Returns the label with the lowest energy other than `decided`. There must be at least two labels.
int SecondLabel(const EnergyMatrix& total, Eigen::Index node, int decided);
// Returns the labels of a frame without detections and clusters: everything is inferred static.
FrameLabels AllStatic(const Window& window, const ClusterMap& map,
                      const std::vector<FramePoint>& points);

}  // namespace internal

// Gives the tracks the detections that their clusters adopted. A detection that went to another or
// a new cluster is removed from its previous track.
void AdoptDetections(const FrameLabels& labels, const ClusterMap& map,
                     std::vector<ClusterTrack>& tracks);

// Options of LabelPoints.
struct LabelOptions {
  LabelSceneOptions scene;
  PairwiseOptions pairwise;
  LabelMatchingOptions matching;
};

// Infers which body every point of the frame belongs to (section 3.2 of the paper).
template <UnaryTerm Box, UnaryTerm Affinity, UnaryTerm Motion, PairwisePolicy Pairwise,
          ConfidencePolicy Confidence>
FrameLabels LabelPoints(const FrameView& view, const LabelOptions& options, const Window& window,
                        const ClusterMap& map, const std::vector<ClusterTrack>& tracks,
                        const std::vector<FramePoint>& points, const NewBodyRule& new_body,
                        CrfMemory& memory) {
  if (tracks.empty() && view.shown.detections.empty() && view.shown.feature_body.empty()) {
    return internal::AllStatic(window, map, points);
  }
  const LabelScene scene =
      BuildLabelScene(view, options.scene, window, map, tracks, points, new_body);
  const UnaryEnergies unary = ComputeUnaries<Box, Affinity, Motion>(scene.crf, options.scene.unary);
  Eigen::Matrix3Xd positions(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    positions.col(static_cast<Eigen::Index>(i)) = scene.crf.nodes[i].MovingPlace().p_in_camera;
  }
  const CrfResult crf = InferDenseCrf<Pairwise>(unary.total, positions, options.pairwise, memory);
  const std::vector<int> decided = internal::DecideLabels(view, points, scene, crf);

  FrameLabels labels;
  const internal::DecidedLabels decision =
      internal::DescribeDecision(window, map, points, scene, decided);
  std::vector<ClusterId> cluster_of = MatchLabels(
      decision.identities, {decision.label_of_old, decision.previous}, options.matching);
  internal::NameLabels(map, scene, cluster_of, labels);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Index row = static_cast<Eigen::Index>(i);
    PointLabel label;
    label.inferred = cluster_of[decided[i]];
    const Landmark* landmark = FindLandmark(points[i], window, map);
    label.assigned = landmark ? landmark->label : LabelState{label.inferred, 1};
    if (landmark && Confidence::Update(label.inferred, label.assigned) == LabelOutcome::kRemove) {
      label.assigned.cluster = ClusterId{};
    }
    label.energy_2d = unary.box(row, decided[i]);
    label.energy_3d = unary.affinity(row, decided[i]);
    label.energy_motion = unary.motion(row, decided[i]);
    const int second = internal::SecondLabel(unary.total, row, decided[i]);
    label.second = cluster_of[second];
    label.second_2d = unary.box(row, second);
    label.second_3d = unary.affinity(row, second);
    label.second_motion = unary.motion(row, second);
    labels.points.push_back(label);
  }
  internal::DropWeakBirths(options.scene.clusters.min_landmarks, window, map, points, labels);
  return labels;
}

}  // namespace cvo
