// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/files/json/json.h"
#include "core/geometry/stereo_camera.h"
#include "synth/models/model.h"
#include "synth/motion/motion.h"
#include "synth/scene/description.h"
#include "synth/scene/object_reader.h"

namespace cvo::synth {

// A parameter of a family that the user may fix.
struct Knob {
  std::string name;
  std::string about;
  std::string unit;
  Json draw;              // distribution of its values, see CheckDraws
  std::vector<Json> may;  // values the user may fix: a range if two numbers, otherwise a list
  bool per_body = false;  // drawn for each body; otherwise once per scene
};

// Any value in a family file can be replaced by a draw: {"uniform": [a, b]}, {"integer": [a, b]}
// (both ends included), {"choose": [value, ...]} or {"knob": name}. Checks all draws within
// `value`. Throws Error naming the key for an empty range or list and for an unknown knob.
void CheckDraws(const Json& value, const std::string& where, const std::vector<Knob>& knobs);

// Replaces draws by values. Every draw has its own random stream, so that fixing one knob leaves
// all other draws unchanged. Uniform draws are rounded to 0.0001.
class Draws {
 public:
  // `set` holds assignments "NAME=VALUE". Throws Error for an unknown knob and for a value that it
  // does not allow.
  Draws(std::string family, std::uint32_t seed, const std::vector<Knob>& knobs,
        const std::vector<std::string>& set);

  Json Take(const Json& value, const std::string& stream) const;
  Rng Stream(const std::string& stream) const {
    return Rng(seed_, "family/" + family_ + "/" + stream);
  }

 private:
  void Fix(const std::string& assignment);
  Json TakeKnob(const std::string& name, const std::string& stream) const;
  Json TakeDraw(const std::string& kind, const Json& from, const std::string& stream) const;

  std::string family_;
  std::uint32_t seed_;
  const std::vector<Knob>& knobs_;
  std::map<std::string, Json> fixed_;
};

// Rounds to 0.001, as all computed values of a generated scene are: beyond that, the sine and
// cosine of different libraries may differ.
double Millis(double value);

// A distribution over scene files, described by a file of synth/families (synth/README.md).
struct Family {
  std::string where;  // names the family in errors
  std::string name;
  std::string about;
  std::vector<Knob> knobs;
  Json scene;   // a scene file with draws, without name, seeds, camera and objects
  Json layout;  // how camera and bodies are placed, with draws
};

// Loads a shipped family by name or a JSON file by path. Throws Error naming file and key.
Family LoadFamily(const std::string& family);
Family ParseFamily(const Json& json, const std::string& where);

struct ShippedFamily {
  std::string name;  // the `name` in `text`
  std::string text;  // JSON
};
// Returns the files of synth/families, which are compiled in.
std::vector<ShippedFamily> ShippedFamilies();

// What a seed may be used for: options are chosen on development seeds (0 to 999), results are
// reported on test seeds (1000 to 1999).
enum class Split { kDevelopment, kTest, kNone };
Split SplitOf(std::uint32_t seed);
const char* SplitName(Split split);

// Generates the scene file of a seed. `set` holds assignments "KNOB=VALUE". The same seed and
// assignments give the same bytes on every machine. Throws Error naming the key for a mistake in
// the family file, and if no place is found for a body.
Json GenerateScene(const Family& family, std::uint32_t seed, const std::vector<std::string>& set);

// Parses a seed, "17". Throws Error unless it is an integer from 0 to 2^32 - 1.
std::uint32_t ParseFamilySeed(const std::string& text);

// A scene of a family by name: "room@17" or "room@17,movers=3,speed_mps=0.5".
struct FamilyScene {
  std::string family;
  std::uint32_t seed = 0;
  std::vector<std::string> set;

  std::string Name() const;
};
bool IsFamilyScene(const std::string& scene);
FamilyScene ParseFamilyScene(const std::string& scene);

// Loads a shipped scene, a scene file or a scene of a family. An assignment "knob.NAME=VALUE" fixes
// a knob of the family; all others change values of the scene file.
SceneDescription LoadScene(const std::string& scene, const std::vector<std::string>& assignments);

// Poses of a body or of the camera over a whole scene, in equal steps of at most 1/30 s.
struct Track {
  CollisionShape shape;  // around the body's origin
  std::vector<RigidTransform> world_from_body;
  double in_view = 0.0;       // minimum fraction of the time in view
  std::vector<bool> visible;  // in view, and no body between its centre and the camera

  // Distance between the positions at the first and the last step.
  double Moved_m() const;
};

struct PlacementLimits {
  double clearance_m = 0.1;            // between bodies, checked at the steps
  double camera_clearance_m = 0.6;     // between bodies and the camera
  double view_m = 1e6;                 // bodies further away do not count as in view
  std::vector<Eigen::Vector4d> walls;  // planes with inward normals that bodies must not cross
};

// Places bodies one after the other so that none comes near another body, a wall or the camera.
class Placement {
 public:
  Placement(const StereoCamera& rig, const Motion& camera, double duration_s,
            PlacementLimits limits);

  // Adds a body if its centre is in the left image, within view_m, for at least the fraction
  // `in_view` of the time, if it keeps all clearances, and if neither it nor any other body is then
  // hidden most of the time. Otherwise changes nothing and returns false.
  bool TryAdd(const CollisionShape& shape, const Motion& motion, double in_view);

  const std::vector<Track>& bodies() const { return bodies_; }
  const Track& camera() const { return camera_; }
  double duration_s() const { return duration_s_; }

 private:
  Track MakeTrack(const CollisionShape& shape, const Motion& motion) const;
  bool StaysInside(const Track& track) const;
  bool HasClearance(const Track& a, const Track& b, double clearance_m) const;
  std::vector<bool> InView(const Track& track) const;
  // Returns `track.visible` without the steps in which `other` hides the centre of the body.
  std::vector<bool> VisibleBehind(const Track& track, const Track& other) const;
  bool TryVisibility(Track& track);

  StereoCamera rig_;
  double duration_s_;
  PlacementLimits limits_;
  Track camera_;
  std::vector<Track> bodies_;
};

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
