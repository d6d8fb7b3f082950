// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "reports/overlays/drawing/palette.h"
#include "reports/overlays/overlay_run.h"

namespace cvo::reports {
namespace {

using Counts = std::map<std::int64_t, std::int64_t>;  // by what is counted

// What was counted most often; of equals the smallest.
std::int64_t MostOften(const Counts& counts) {
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// By cluster: the body that most of its landmarks are on, the static scene left aside.
std::map<std::int64_t, std::int64_t> BodiesOfClusters(const OverlayRun& run) {
  std::map<std::int64_t, Counts> seen;
  for (const auto& [frame, dots] : run.landmarks) {
    for (const LandmarkDot& dot : dots) {
      if (dot.label > kStaticLabel && dot.truth_body > 0) ++seen[dot.label][dot.truth_body];
    }
  }
  std::map<std::int64_t, std::int64_t> bodies;
  for (const auto& [cluster, counts] : seen) bodies[cluster] = MostOften(counts);
  return bodies;
}

using Pixel = std::pair<float, float>;

// The labels of a frame's landmarks by where they are.
std::map<Pixel, std::int64_t> LabelsByPixel(const std::vector<LandmarkDot>& dots) {
  std::map<Pixel, std::int64_t> labels;
  for (const LandmarkDot& dot : dots) {
    if (dot.label > kStaticLabel) labels[{dot.u_px, dot.v_px}] = dot.label;
  }
  return labels;
}

// How many landmarks each cluster shares with each of the other run.
std::map<std::int64_t, Counts> SharedLandmarks(const OverlayRun& run, const OverlayRun& other) {
  std::map<std::int64_t, Counts> shared;
  for (const auto& [frame, dots] : run.landmarks) {
    const auto there = other.landmarks.find(frame);
    if (there == other.landmarks.end()) continue;
    const std::map<Pixel, std::int64_t> labels = LabelsByPixel(there->second);
    for (const LandmarkDot& dot : dots) {
      if (dot.label <= kStaticLabel) continue;
      const auto same = labels.find({dot.u_px, dot.v_px});
      if (same != labels.end()) ++shared[dot.label][same->second];
    }
  }
  return shared;
}

}  // namespace

void MarkWrongLabels(OverlayRun& run) {
  if (run.detail.bodies.empty()) return;
  std::set<std::int64_t> movers;
  for (const BodyDetail& body : run.detail.bodies) {
    if (body.mover) movers.insert(body.id);
  }
  const std::map<std::int64_t, std::int64_t> bodies = BodiesOfClusters(run);
  for (auto& [frame, dots] : run.landmarks) {
    for (LandmarkDot& dot : dots) {
      if (dot.truth_body < 0) continue;
      run.has_truth = true;
      const auto body = bodies.find(dot.label);
      if (dot.label > kStaticLabel) {
        dot.wrong = body == bodies.end() || body->second != dot.truth_body;
      } else if (dot.label == kStaticLabel) {
        dot.wrong = movers.contains(dot.truth_body);
      }
    }
  }
}

std::map<std::int64_t, std::int64_t> ApartColors(const std::vector<ClusterRow>& rows) {
  std::map<std::int64_t, std::set<int>> frames;  // by cluster
  for (const ClusterRow& row : rows) frames[row.id].insert(row.frame);
  std::array<std::set<int>, kClusterColors> used;  // frames by colour
  std::map<std::int64_t, std::int64_t> chosen;
  for (const auto& [id, of_cluster] : frames) {
    const std::size_t own = (static_cast<std::uint64_t>(id) - 1U) % kClusterColors;
    std::size_t best = own;
    std::size_t least = of_cluster.size() + 1;
    for (std::size_t i = 0; i < kClusterColors && least > 0; ++i) {
      const std::size_t color = (own + i) % kClusterColors;
      const auto shared = static_cast<std::size_t>(
          std::count_if(of_cluster.begin(), of_cluster.end(),
                        [&](int frame) { return used[color].contains(frame); }));
      if (shared >= least) continue;
      best = color;
      least = shared;
    }
    used[best].insert(of_cluster.begin(), of_cluster.end());
    if (best != own) chosen[id] = static_cast<std::int64_t>(best) + 1;
  }
  return chosen;
}

void AgreeOnColors(std::vector<OverlayRun>& runs) {
  const std::map<std::int64_t, std::int64_t>& last = runs.back().color_ids;
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
    for (const auto& [cluster, counts] : SharedLandmarks(runs[i], runs.back())) {
      const std::int64_t id = MostOften(counts);
      const auto color = last.find(id);
      runs[i].color_ids[cluster] = color == last.end() ? id : color->second;
    }
  }
}

}  // namespace cvo::reports
