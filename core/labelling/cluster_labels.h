// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/clustering/dense_crf.h"
#include "core/clustering/unary_terms.h"
#include "core/labelling/frame_points.h"

namespace cvo {

// The steps of the labelling in which variants differ.
struct LabelSteps {
  EnergyMatrix (*unaries)(const CrfScene&, const UnaryOptions&);
  CrfResult (*infer)(const CrfMatrix&, const Eigen::Matrix3Xd&, const PairwiseOptions&, CrfMemory&);
  LabelOutcome (*adopt)(ClusterId inferred, LabelState& state);
  NewBodyRule new_body;
};

// Labels of all points of a frame, and the detections that became clusters or join existing ones.
struct FrameLabels {
  // In the order of the points. `cluster` and `confidence` are q^i and w^i after the confidence
  // rule; UpdateLandmarks sets `id`.
  std::vector<LandmarkReport> points;
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
  CrfScene scene;  // in which the labels were inferred
};

// Collects what is known of every point and every class (section 3.2 of the paper). The current
// frame is the one after the newest frame of the window.
CrfScene BuildCrfScene(const FrameView& view, NewBodyRule new_body, const Window& window,
                       const ClusterMap& map, const std::vector<ClusterTrack>& tracks,
                       const std::vector<FramePoint>& points);

// Turns the clusters that labels were matched with into adoptions and births: a label that
// continues a cluster other than its own is an adoption; a label without a cluster is a birth and
// gets the next id, from `next` on, which is also written to cluster_of.
void NameLabels(ClusterId next, const std::vector<CrfLabel>& crf_labels,
                std::vector<ClusterId>& cluster_of, FrameLabels& labels);

// Removes births with fewer than `min_landmarks` accepted points and renumbers the others.
void DropWeakBirths(int min_landmarks, const Window& window, const ClusterMap& map,
                    const std::vector<FramePoint>& points, FrameLabels& labels);

// Gives the tracks the detections that their clusters adopted. A detection that went to another or
// a new cluster is removed from its previous track.
void AdoptDetections(const FrameLabels& labels, const ClusterMap& map,
                     std::vector<ClusterTrack>& tracks);

// Infers which body every point of the frame belongs to (section 3.2 of the paper).
FrameLabels LabelPoints(const FrameView& view, const LabelSteps& steps, const Window& window,
                        const ClusterMap& map, const std::vector<ClusterTrack>& tracks,
                        const std::vector<FramePoint>& points, CrfMemory& memory);

}  // namespace cvo
