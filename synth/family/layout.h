// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "core/base/rng.h"
#include "synth/family/placement.h"
#include "synth/scene/object_reader.h"

namespace cvo::synth {

// A body that needs a path. MakePath may change its size.
struct BodyRequest {
  ObjectReader& keys;  // the remaining keys of the body in the family file
  Eigen::Vector3d size_m;
  const Placement& placed;  // the camera and the bodies placed so far
  Rng& rng;
};

// Determines the path of the camera and the paths that bodies can take.
class Layout {
 public:
  virtual ~Layout() = default;

  virtual Json Camera() const = 0;            // as in a scene file
  virtual Json Street() const { return {}; }  // as in a scene file; null: the family file has it
  virtual PlacementLimits Limits() const = 0;
  // Returns a random path of the kind `motion`, as in a scene file, or nothing if the drawn path
  // does not fit. Throws Error for an unknown kind and for missing or invalid keys.
  virtual std::optional<Json> MakePath(const std::string& motion, BodyRequest& body) const = 0;
};

// `scene` is a scene file without camera and objects. `keys` are those of the layout, without the
// bodies.
std::unique_ptr<Layout> MakeRoomLayout(const Json& scene, double duration_s, ObjectReader& keys,
                                       Rng rng);
std::unique_ptr<Layout> MakeStreetLayout(double duration_s, ObjectReader& keys, Rng rng);

// A point [x, y] as in a scene file.
Json PointJson(const Eigen::Vector2d& point);

// A speed profile to make: `speed_mps` with up to `stops` stops on the way, and at rest before a
// distance of `length_m`.
struct SpeedRequest {
  double speed_mps = 0.0;
  int stops = 0;
  double duration_s = 0.0;
  double length_m = 0.0;
};
Json SpeedKnots(const SpeedRequest& request, Rng& rng);

}  // namespace cvo::synth
