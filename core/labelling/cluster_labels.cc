// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/labelling/cluster_labels.h"

#include <algorithm>
#include <map>

namespace cvo {
namespace internal {

std::vector<int> DecideLabels(const FrameView& view, const std::vector<FramePoint>& points,
                              const LabelScene& scene, const CrfResult& crf) {
  std::vector<int> labels = MostLikelyLabels(crf.q);
  const std::span<const BodyId> given = view.shown.feature_body;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (given.empty() || !given[points[i].feature].valid()) continue;
    labels[i] = static_cast<int>(
        std::find(scene.given_body.begin(), scene.given_body.end(), given[points[i].feature]) -
        scene.given_body.begin());
  }
  return labels;
}

DecidedLabels DescribeDecision(const Window& window, const ClusterMap& map,
                               const std::vector<FramePoint>& points, const LabelScene& scene,
                               const std::vector<int>& decided) {
  DecidedLabels result;
  for (std::size_t l = 0; l < scene.crf.labels.size(); ++l) {
    const CrfLabel& label = scene.crf.labels[l];
    LabelIdentity identity{label.kind, l == 0 ? kStaticScene : ClusterId{}};
    if (label.kind == LabelKind::kCluster) identity.cluster = map.live[l - 1].id;
    result.identities.push_back(identity);
  }
  // New points have no previous cluster.
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Landmark* landmark = FindLandmark(points[i], window, map);
    if (!landmark) continue;
    result.previous.push_back(landmark->label.cluster);
    result.label_of_old.push_back(decided[i]);
  }
  return result;
}

void NameLabels(const ClusterMap& map, const LabelScene& scene, std::vector<ClusterId>& cluster_of,
                FrameLabels& labels) {
  ClusterId next = map.next;
  for (int l = 1; l < scene.Outlier(); ++l) {
    const ClusterId own = scene.IsNewBox(l) ? ClusterId{} : map.live[l - 1].id;
    if (!cluster_of[l].valid()) {
      labels.births.push_back({next, scene.detection[l], scene.given_body[l]});
      cluster_of[l] = next;
      ++next.value;
    } else if (cluster_of[l] != own) {
      labels.adoptions.push_back({cluster_of[l], scene.detection[l]});
    }
  }
}

void DropWeakBirths(int min_landmarks, const Window& window, const ClusterMap& map,
                    const std::vector<FramePoint>& points, FrameLabels& labels) {
  std::map<ClusterId, int> members;
  for (const PointLabel& label : labels.points) ++members[label.assigned.cluster];
  std::map<ClusterId, ClusterId> renamed;  // to consecutive ids, without dropped births
  std::vector<FrameLabels::Birth> kept;
  for (FrameLabels::Birth birth : labels.births) {
    const bool is_weak = members[birth.id] < min_landmarks;
    const ClusterId id{map.next.value + static_cast<std::int64_t>(kept.size())};
    renamed[birth.id] = is_weak ? ClusterId{} : id;
    birth.id = id;
    if (!is_weak) kept.push_back(birth);
  }
  labels.births = kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointLabel& label = labels.points[i];
    for (ClusterId* id : {&label.inferred, &label.second}) {
      const auto found = renamed.find(*id);
      if (found != renamed.end()) *id = found->second;
    }
    const auto assigned = renamed.find(label.assigned.cluster);
    if (assigned == renamed.end()) continue;
    label.assigned.cluster = assigned->second;
    if (assigned->second.valid()) continue;
    // The birth is dropped: a landmark stays with its previous owner, a new point becomes static.
    const Landmark* landmark = FindLandmark(points[i], window, map);
    label.assigned =
        landmark ? LabelState{landmark->label.cluster, 1} : LabelState{kStaticScene, 1};
  }
}

int SecondLabel(const EnergyMatrix& total, Eigen::Index node, int decided) {
  int second = decided == 0 ? 1 : 0;
  for (int label = 0; label < total.cols(); ++label) {
    if (label != decided && total(node, label) < total(node, second)) second = label;
  }
  return second;
}

FrameLabels AllStatic(const Window& window, const ClusterMap& map,
                      const std::vector<FramePoint>& points) {
  FrameLabels labels;
  for (const FramePoint& point : points) {
    const Landmark* landmark = FindLandmark(point, window, map);
    PointLabel label;
    label.inferred = kStaticScene;
    label.assigned = landmark ? landmark->label : LabelState{kStaticScene, 1};
    labels.points.push_back(label);
  }
  return labels;
}

}  // namespace internal

void AdoptDetections(const FrameLabels& labels, const ClusterMap& map,
                     std::vector<ClusterTrack>& tracks) {
  for (const FrameLabels::Adoption& adoption : labels.adoptions) {
    for (std::size_t q = 0; q < tracks.size(); ++q) {
      if (tracks[q].detection == adoption.detection) tracks[q].detection = -1;
      if (map.live[q].id == adoption.id) tracks[q].detection = adoption.detection;
    }
  }
  // A detection whose label became a new cluster no longer belongs to its previous cluster.
  for (const FrameLabels::Birth& birth : labels.births) {
    for (ClusterTrack& track : tracks) {
      if (birth.detection >= 0 && track.detection == birth.detection) track.detection = -1;
    }
  }
}

}  // namespace cvo
