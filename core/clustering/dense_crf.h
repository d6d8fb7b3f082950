// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/clustering/crf_lanes.h"
#include "core/clustering/crf_options.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

namespace cvo {

// A landmark seen in the current frame (section 3.2 of the paper).
struct CrfNode {
  Eigen::Vector3d z_px = Eigen::Vector3d::Zero();         // z_t^i
  Eigen::Vector3d p_in_camera = Eigen::Vector3d::Zero();  // Z_t^i, triangulated from z_t^i alone
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Identity();  // of p_in_camera
  // Its observation in the past frame t', z_{t'}^i.
  struct Past {
    Eigen::Vector3d z_px = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance_px2 = Eigen::Matrix3d::Identity();
  };
  std::optional<Past> past;  // empty: its motion is unknown
  // Position of the landmark in the current camera frame, for the motion and pairwise terms. Where
  // the body's pose places a landmark is taken as exact.
  struct Place {
    Eigen::Vector3d p_in_camera = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  };
  std::optional<Place> estimate;  // p_t^i of the landmark; empty: Z_t^i is used
  Place MovingPlace() const { return estimate.value_or(Place{p_in_camera, covariance_m2}); }
};

// Kinds of the M classes, in the order of the labels: the static scene, live clusters, boxes that
// belong to no cluster, and the outlier class.
enum class LabelKind { kStatic, kCluster, kNewBox, kOutlier };

struct CrfLabel {
  LabelKind kind = LabelKind::kStatic;
  ClusterId cluster = {};            // of kStatic and kCluster
  int detection = -1;                // the associated one, or that of the new box; -1: none
  BodyId given_body = {};            // see GivenKnowledge; invalid: unknown
  std::optional<ImageBox> box = {};  // of the detection
  // Where the cluster is expected in the image, if no detection is associated with it.
  std::optional<ImageBox> predicted_box = {};
  // Centre and size of a cluster or new box: half sides along the columns of camera_from_axes.
  struct Extent {
    Eigen::Vector3d center_in_camera = Eigen::Vector3d::Zero();
    Eigen::Matrix3d camera_from_axes = Eigen::Matrix3d::Identity();
    Eigen::Vector3d half_size_m = Eigen::Vector3d::Ones();
  };
  std::optional<Extent> extent = {};
  // Maps points of this body from the current camera frame to that of the past frame t':
  // T_{t'}^{cq} (P_t^q)^-1 P_t^c of the paper. Empty if the body had no pose then.
  std::optional<RigidTransform> past_from_now = {};
};

// The nodes and the M = N1 + N2 + 1 classes of the CRF in one frame: in this order, the static
// scene and the live clusters, the detections that belong to none of them, and the outlier class.
struct CrfScene {
  StereoCamera camera;
  std::vector<CrfNode> nodes;
  std::vector<CrfLabel> labels;
};

// Where the pairwise term has the nodes: their MovingPlace, 3 x N.
Eigen::Matrix3Xd MovingPlaces(const CrfScene& scene);

// The cluster of a landmark and the confidence w in it (section 3.2 of the paper).
struct LabelState {
  ClusterId cluster;  // invalid: none yet
  int confidence = 1;
};

enum class LabelOutcome { kKept, kChanged, kRemove };

// Policies for how a landmark seen in the current frame adopts the cluster inferred for it, after
// labels were matched with clusters; an invalid id is the outlier class. An outlier label lowers
// the confidence but is never adopted: instead, kRemove is returned and the state stays as it was.

// Policy: w + 1 for the same label, w - 1 for another one, which is adopted with w = 1 when w
// reaches 0.
struct CountLabels {
  [[nodiscard]] static LabelOutcome Update(ClusterId inferred, LabelState& state) {
    if (inferred.valid() && inferred == state.cluster) {
      ++state.confidence;
      return LabelOutcome::kKept;
    }
    if (state.confidence > 1) {
      --state.confidence;
      return LabelOutcome::kKept;
    }
    if (!inferred.valid()) return LabelOutcome::kRemove;
    state = {inferred, 1};
    return LabelOutcome::kChanged;
  }
};

// Policy: the label inferred last is adopted, without memory.
struct TakeLabelsAtOnce {
  [[nodiscard]] static LabelOutcome Update(ClusterId inferred, LabelState& state) {
    if (!inferred.valid()) return LabelOutcome::kRemove;
    const bool is_same = inferred == state.cluster;
    state = {inferred, 1};
    return is_same ? LabelOutcome::kKept : LabelOutcome::kChanged;
  }
};

// Nodes (rows) by labels (columns).
using CrfMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct CrfResult {
  CrfMatrix q;     // probabilities; rows sum to 1
  int sweeps = 0;  // performed
};

// Kernel policies of Eq. 9 define bandwidth and normalisation: k_ij = s_i s_j g_ij for i != j,
// where g_ij = exp(-d_ij^2 / (2 BandwidthM^2)) and s_i = Scale(sum_{j != i} g_ij).

// Policy: D^-1/2 K D^-1/2. D includes the node itself, so that the only neighbour of a remote node
// does not get full weight however weak it is; a node receives no message from itself. Rows sum to
// less than about 1.
struct NormalizedGaussianKernel {
  static double BandwidthM(const PairwiseOptions& options) { return options.bandwidth_m; }
  static double Scale(double degree);
};

// Policy: exp(-d^2) with d in m, as printed in the paper (Eq. 9): not normalised, and
// independent of the options.
struct RawGaussianKernel {
  static double BandwidthM(const PairwiseOptions& options);
  static double Scale(double degree);
};

// Policy: no pairwise term.
struct NoPairwise {};

// Mean-field inference for E(q) = sum_i U_i(q_i) + alpha sum_{i<j} k_ij [q_i != q_j] (Eq. 4 of the
// paper): Q_i(l) ~ exp(-U_i(l) + alpha sum_j k_ij Q_j(l)), for all nodes at once, starting
// from softmax(-U). `energies` is N x M in nats, `points` is 3 x N in m; throws Error if the two N
// differ, a value is not finite, or there are nodes but no labels. k_ij = 0 beyond 6 bandwidths,
// where it is below the rounding of float. With the default options, Q is within 1e-5 of the result
// in double precision without this cutoff (raw kernel: 1e-3). Needs at most 2 N^2 + 40 N M bytes;
// `memory` is reused from call to call.
template <typename Kernel>
CrfResult InferDenseCrf(const CrfMatrix& energies, const Eigen::Matrix3Xd& points,
                        const PairwiseOptions& options, CrfMemory& memory);

// Returns the most likely label of each node, the first one in case of a tie.
std::vector<int> MostLikelyLabels(const CrfMatrix& q);

// Result of the CRF for landmarks that existed before this frame. Both spans have one entry per
// node.
struct LabeledNodes {
  std::span<const int> label;
  std::span<const ClusterId> previous;  // invalid for a landmark without a cluster
};

// Returns for each label the cluster that it continues (section 3.2 of the paper, Kuhn-Munkres over
// intersection over union). All labels of clusters and new boxes compete for all clusters; the
// label of a cluster that matches none keeps its cluster if no other label took it. The id is
// invalid for the outlier class and for labels that start a new cluster.
std::vector<ClusterId> MatchLabels(std::span<const CrfLabel> labels, const LabeledNodes& nodes);

}  // namespace cvo
