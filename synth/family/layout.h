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

// A body that needs a path. A path maker may change its size.
struct BodyRequest {
  ObjectReader& keys;  // the rest of what the family file says of it
  Eigen::Vector3d size_m;
  const Placement& placed;  // the camera and the bodies before it
  Rng& rng;
};

// Where the camera goes and which paths bodies can take.
class Layout {
 public:
  virtual ~Layout() = default;

  virtual Json Camera() const = 0;            // as in a scene file
  virtual Json Street() const { return {}; }  // as in a scene file; null: the family says it
  virtual PlacementLimits Limits() const = 0;
  // A random path of the kind `motion`, as in a scene file; nothing where the draw fits nowhere.
  // Throws Error for an unknown kind and for keys that it does not have.
  virtual std::optional<Json> MakePath(const std::string& motion, BodyRequest& body) const = 0;
};

// `scene`: a scene file without camera and objects. `keys`: of the layout, without the bodies.
std::unique_ptr<Layout> MakeRoomLayout(const Json& scene, double duration_s, ObjectReader& keys,
                                       Rng rng);
std::unique_ptr<Layout> MakeStreetLayout(double duration_s, ObjectReader& keys, Rng rng);

// A point [x, y] of a scene file.
Json PointJson(const Eigen::Vector2d& point);

// Knots of a speed: `speed_mps` with `stops` halts on the way, and at rest before `length_m` is
// travelled.
struct SpeedRequest {
  double speed_mps = 0.0;
  int stops = 0;
  double duration_s = 0.0;
  double length_m = 0.0;
};
Json SpeedKnots(const SpeedRequest& request, Rng& rng);

}  // namespace cvo::synth
