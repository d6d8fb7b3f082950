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

using Counts = std::map<std::int64_t, std::int64_t>;  // number of occurrences by id

// The most frequent id, the smallest one if several are. `counts` must not be empty.
std::int64_t MostOften(const Counts& counts) {
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// By cluster: the body that holds most of its landmarks, not counting the static scene.
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

// The labels of a frame's landmarks on clusters, by pixel.
std::map<Pixel, std::int64_t> LabelsByPixel(const std::vector<LandmarkDot>& dots) {
  std::map<Pixel, std::int64_t> labels;
  for (const LandmarkDot& dot : dots) {
    if (dot.label > kStaticLabel) labels[{dot.u_px, dot.v_px}] = dot.label;
  }
  return labels;
}

// The number of landmarks that each cluster shares with each cluster of the other run.
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

using FramesById = std::map<std::int64_t, std::set<int>>;
using UsedColors = std::array<std::set<int>, kClusterColors>;  // the frames that use it, by colour

std::size_t ColorIndex(std::int64_t id) {
  return (static_cast<std::uint64_t>(id) - 1U) % kClusterColors;
}

// Returns the first colour, starting at `wanted`, that is in use in the fewest of `frames`, and
// marks it as in use in them.
std::size_t TakeColor(std::size_t wanted, const std::set<int>& frames, UsedColors& used) {
  std::size_t best = wanted;
  std::size_t least = frames.size() + 1;
  for (std::size_t i = 0; i < kClusterColors && least > 0; ++i) {
    const std::size_t color = (wanted + i) % kClusterColors;
    const auto shared = static_cast<std::size_t>(std::count_if(
        frames.begin(), frames.end(), [&](int frame) { return used[color].contains(frame); }));
    if (shared >= least) continue;
    best = color;
    least = shared;
  }
  used[best].insert(frames.begin(), frames.end());
  return best;
}

// By cluster: the frames in which something is drawn in its colour.
FramesById FramesOfClusters(const OverlayRun& run) {
  FramesById frames;
  for (const ClusterRow& row : run.detail.clusters) frames[row.id].insert(row.frame);
  for (const auto& [frame, dots] : run.landmarks) {
    for (const LandmarkDot& dot : dots) {
      if (dot.label > kStaticLabel) frames[dot.label].insert(frame);
    }
  }
  return frames;
}

// The colour that a cluster should have, and how many shared landmarks support it.
struct Wish {
  std::int64_t id = 0;
  std::set<int> frames;
  std::size_t color = 0;
  std::int64_t shared = 0;
};

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
  FramesById frames;
  for (const ClusterRow& row : rows) frames[row.id].insert(row.frame);
  UsedColors used;
  std::map<std::int64_t, std::int64_t> chosen;
  for (const auto& [id, of_cluster] : frames) {
    const std::size_t color = TakeColor(ColorIndex(id), of_cluster, used);
    if (color != ColorIndex(id)) chosen[id] = static_cast<std::int64_t>(color) + 1;
  }
  return chosen;
}

void AgreeOnColors(std::vector<OverlayRun>& runs) {
  const std::map<std::int64_t, std::int64_t>& last = runs.back().color_ids;
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
    const std::map<std::int64_t, Counts> shared = SharedLandmarks(runs[i], runs.back());
    // Several clusters may share most landmarks with the same cluster. The one that shares the most
    // gets its colour.
    std::vector<Wish> wishes;
    for (const auto& [id, frames] : FramesOfClusters(runs[i])) {
      Wish wish{id, frames, ColorIndex(id), 0};
      if (const auto found = shared.find(id); found != shared.end()) {
        const std::int64_t there = MostOften(found->second);
        const auto color = last.find(there);
        wish.color = ColorIndex(color == last.end() ? there : color->second);
        wish.shared = found->second.at(there);
      }
      wishes.push_back(std::move(wish));
    }
    std::stable_sort(wishes.begin(), wishes.end(),
                     [](const Wish& a, const Wish& b) { return a.shared > b.shared; });
    UsedColors used;
    runs[i].color_ids.clear();
    for (const Wish& wish : wishes) {
      const std::size_t color = TakeColor(wish.color, wish.frames, used);
      if (color != ColorIndex(wish.id)) {
        runs[i].color_ids[wish.id] = static_cast<std::int64_t>(color) + 1;
      }
    }
  }
}

}  // namespace cvo::reports
