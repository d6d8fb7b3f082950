// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/files/images/image_file.h"
#include "synth/models/build.h"
#include "synth/models/model.h"
#include "tests/support/error_message.h"

namespace cvo::synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::HasSubstr;

Model Make(const std::string& kind, std::uint64_t seed, const Vector3d& size = Vector3d::Zero(),
           const std::string& material = "") {
  Rng rng(seed, "look");
  ModelDescription description;
  description.kind = kind;
  description.size_m = size;
  description.material = material;
  return MakeModel(description, rng);
}

Eigen::AlignedBox3d BoundsOf(const Model& model) {
  Eigen::AlignedBox3d box;
  for (const Part& part : model.parts) {
    for (const Vertex& vertex : part.mesh.vertices) box.extend(vertex.position.cast<double>());
  }
  return box;
}

// Signed volume by the divergence theorem, with the outer side of each face as its normals say.
double Volume(const Mesh& mesh) {
  double volume = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vertex& a = mesh.vertices[mesh.indices[i]];
    const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
    const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
    const Eigen::Vector3f face = (b.position - a.position).cross(c.position - a.position);
    const float side = face.dot(a.normal + b.normal + c.normal) > 0.0f ? 1.0f : -1.0f;
    volume += side * face.dot(a.position) / 6.0f;
  }
  return volume;
}

void ExpectSound(const Model& model, const std::string& what) {
  ASSERT_FALSE(model.parts.empty()) << what;
  for (const Part& part : model.parts) {
    ASSERT_FALSE(part.texture.empty()) << what;
    ASSERT_FALSE(part.mesh.indices.empty()) << what;
    ASSERT_EQ(part.mesh.indices.size() % 3, 0u) << what;
    EXPECT_GT(Volume(part.mesh), 0.0) << what << ": normals must point outward";
    for (const std::uint32_t index : part.mesh.indices) {
      ASSERT_LT(index, part.mesh.vertices.size()) << what;
    }
    for (const Vertex& vertex : part.mesh.vertices) {
      ASSERT_TRUE(vertex.position.allFinite() && vertex.uv.allFinite()) << what;
      ASSERT_NEAR(vertex.normal.norm(), 1.0f, 1e-5f) << what;
    }
  }
  const Eigen::AlignedBox3d box = BoundsOf(model);
  EXPECT_LT((box.sizes() - model.size_m).cwiseAbs().maxCoeff(), 1e-5) << what;
  EXPECT_LT(box.center().cwiseAbs().maxCoeff(), 1e-5) << what;
}

void ExpectShapesInside(const Model& model, const std::string& what) {
  ASSERT_FALSE(model.shapes.empty()) << what;
  for (const CollisionShape& shape : model.shapes) {
    const Vector3d reach = shape.model_from_shape.translation().cwiseAbs() + shape.half_size_m;
    EXPECT_LT((reach - 0.5 * model.size_m).maxCoeff(), 1e-5) << what;
  }
}

bool SameModel(const Model& a, const Model& b) {
  if (a.parts.size() != b.parts.size()) return false;
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    if (a.parts[i].texture.size() != b.parts[i].texture.size()) return false;
    if (cv::norm(a.parts[i].texture, b.parts[i].texture, cv::NORM_INF) != 0.0) return false;
    const std::vector<Vertex>& x = a.parts[i].mesh.vertices;
    const std::vector<Vertex>& y = b.parts[i].mesh.vertices;
    if (x.size() != y.size() || a.parts[i].mesh.indices != b.parts[i].mesh.indices) return false;
    for (std::size_t v = 0; v < x.size(); ++v) {
      if (x[v].position != y[v].position || x[v].uv != y[v].uv) return false;
    }
  }
  return true;
}

TEST(MakeModel, EveryKindIsSoundInTwoSizesAndFixedPerStream) {
  for (const std::string& kind : ModelKinds()) {
    const Model usual = Make(kind, 1);
    ExpectSound(usual, kind);
    ExpectShapesInside(usual, kind);  // a tree of another shape has a crown beyond its box
    const Vector3d size = kind == "ball" ? Vector3d::Constant(0.9) : Vector3d(1.3, 0.8, 1.1);
    const Model model = Make(kind, 1, size);
    EXPECT_EQ(model.size_m, size) << kind;
    ExpectSound(model, kind);
    EXPECT_TRUE(SameModel(usual, Make(kind, 1))) << kind;
    EXPECT_FALSE(SameModel(usual, Make(kind, 2))) << kind;
  }
  EXPECT_FALSE(SameModel(Make("tower", 1, Vector3d::Zero(), "brick"), Make("tower", 1)));
}

TEST(MakeModel, RefusesBadDescriptions) {
  EXPECT_THAT(ErrorMessage([] { Make("dragon", 1); }),
              AllOf(HasSubstr("'dragon'"), HasSubstr("ball, block")));
  EXPECT_THAT(ErrorMessage([] { Make("ball", 1, {0.5, 0.6, 0.5}); }), HasSubstr("same diameter"));
  EXPECT_THAT(ErrorMessage([] { Make("chair", 1, Vector3d::Zero(), "cheese"); }),
              AllOf(HasSubstr("'cheese'"), HasSubstr("asphalt, ball")));
}

// The grey-level step across the border, where the texture repeats, is no larger than those inside.
TEST(Textures, AreSeamless) {
  Rng rng(1, "test");
  for (const char* material : {"asphalt", "brick", "concrete", "grass", "leaves", "pavement",
                               "plaster", "tiles", "wallpaper", "parquet"}) {
    const Texture texture = MakeTexture(material, rng);
    EXPECT_LE(std::max(texture.image.cols, texture.image.rows), 1024) << material;
    cv::Mat grey;
    cv::cvtColor(texture.image, grey, cv::COLOR_RGB2GRAY);
    const auto step = [&](int a, int b) {
      return cv::norm(grey.col(a), grey.col(b), cv::NORM_L1) / grey.rows;
    };
    double largest = 0.0;
    for (int x = 0; x + 1 < grey.cols; ++x) largest = std::max(largest, step(x, x + 1));
    EXPECT_LE(step(grey.cols - 1, 0), 1.1 * largest) << material;
  }
}

// Returns the number of corners per 1,000 pixels of the texture at this resolution.
double CornerDensity(const Texture& texture, double pixels_per_m) {
  cv::Mat grey;
  cv::cvtColor(texture.image, grey, cv::COLOR_RGB2GRAY);
  const cv::Size size(static_cast<int>(texture.size_m.x() * pixels_per_m),
                      static_cast<int>(texture.size_m.y() * pixels_per_m));
  cv::Mat seen;
  cv::resize(grey, seen, size, 0, 0, cv::INTER_AREA);
  cv::Mat repeated;
  cv::repeat(seen, 2, 2, repeated);
  std::vector<cv::KeyPoint> corners;
  cv::FAST(repeated, corners, 20);
  return 1000.0 * static_cast<double>(corners.size()) / static_cast<double>(repeated.total());
}

double MeanDensity(const std::string& material, double pixels_per_m) {
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    Rng rng(seed, "corners");
    sum += CornerDensity(MakeTexture(material, rng), pixels_per_m) / 3.0;
  }
  return sum;
}

// Moving bodies have more corners than what surrounds them, and objects along a road more than the
// road itself, or they would not get their share of the features that a front end keeps.
TEST(Textures, HaveCornersWhereTheyAreNeeded) {
  struct Case {
    std::vector<const char*> materials;
    double pixels_per_m;  // at 2 m indoors, at 15 m outdoors
    double least;
    double most;
  };
  constexpr double kIndoors = 450.0 / 2.0;
  constexpr double kOutdoors = 721.0 / 15.0;
  const std::vector<Case> cases = {
      {{"ball", "block", "fabric"}, kIndoors, 10.0, 1e9},
      {{"brick", "plaster", "poster", "tiles", "wallpaper", "wood"}, kIndoors, 5.0, 1e9},
      {{"carpet"}, kIndoors, 1.0, 1e9},
      {{"embossed"}, kIndoors, 0.0, 0.5},
      {{"paint"}, kOutdoors, 20.0, 1e9},
      {{"bark", "brick", "concrete", "grass", "leaves", "roof"}, kOutdoors, 4.0, 1e9},
      {{"facade"}, kOutdoors, 2.0, 8.0},
      {{"asphalt", "pavement"}, kOutdoors, 0.2, 2.0}};
  for (const Case& wanted : cases) {
    for (const char* material : wanted.materials) {
      const double density = MeanDensity(material, wanted.pixels_per_m);
      EXPECT_GE(density, wanted.least) << material;
      EXPECT_LE(density, wanted.most) << material;
    }
  }
}

Surroundings Room(std::uint64_t seed, const RoomDescription& room = {}) {
  Rng rng(seed, "look");
  return MakeRoom(room, rng);
}

Eigen::AlignedBox3d BoundsOf(const PlacedModel& placed) {
  Eigen::AlignedBox3d box;
  for (const Part& part : placed.model.parts) {
    for (const Vertex& vertex : part.mesh.vertices) {
      box.extend(placed.world_from_model * Vector3d(vertex.position.cast<double>()));
    }
  }
  return box;
}

TEST(MakeRoom, FurnitureStandsAlongTheWallsWithoutOverlap) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const RoomDescription room;
    const Surroundings made = Room(seed);
    ASSERT_EQ(made.placed.size(), 10u);
    ASSERT_EQ(made.walls.size(), 6u);
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const PlacedModel& placed : made.placed) boxes.push_back(BoundsOf(placed));
    const Vector2d free = 0.5 * room.size_m.head<2>() - Vector2d::Constant(room.furniture_depth_m);
    const Eigen::AlignedBox3d middle(Vector3d(-free.x(), -free.y(), 0.0),
                                     Vector3d(free.x(), free.y(), room.size_m.z()));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_NEAR(boxes[i].min().z(), 0.0, 1e-5);
      EXPECT_TRUE(middle.intersection(boxes[i]).isEmpty());
      for (const Eigen::Vector4d& wall : made.walls) {
        for (const Vector3d& corner : {boxes[i].min(), boxes[i].max()}) {
          EXPECT_GT(wall.head<3>().dot(corner) + wall.w(), -1e-5);
        }
      }
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_TRUE(boxes[i].intersection(boxes[k]).isEmpty());
      }
    }
  }
}

TEST(MakeRoom, ShellNormalsPointIntoTheRoom) {
  const Surroundings room = Room(2);
  int walls = 0;
  for (const Part& part : room.shell) {
    const std::vector<Vertex>& vertices = part.mesh.vertices;
    const bool flat = std::all_of(vertices.begin(), vertices.end(), [&](const Vertex& vertex) {
      return vertex.normal == vertices[0].normal;
    });
    if (!flat) continue;
    ++walls;
    const Eigen::Vector3f inward = Eigen::Vector3f(0, 0, 1.3f) - vertices[0].position;
    EXPECT_GT(vertices[0].normal.dot(inward), 0.0f);
  }
  EXPECT_GE(walls, 6);
}

StreetDescription Crossing() {
  StreetDescription street;
  street.roads = {{{{-60, 0}, {40, 0}, {40, 60}}, 8.0, 15.0}, {{{-20, -50}, {-20, 50}}, 7.0, 15.0}};
  return street;
}

Surroundings Street(std::uint64_t seed, const StreetDescription& street = Crossing()) {
  Rng rng(seed, "look");
  return MakeStreet(street, rng);
}

TEST(MakeStreet, NothingStandsOnARoad) {
  const StreetDescription street = Crossing();
  const Surroundings made = Street(1);
  EXPECT_GT(made.placed.size(), 60u);
  for (const RoadDescription& road : street.roads) {
    const std::vector<Vector2d> line = RoundedPolyline(road.points, road.corner_radius_m);
    for (const PlacedModel& placed : made.placed) {
      for (const CollisionShape& shape : placed.model.shapes) {
        for (int corner = 0; corner < 4; ++corner) {
          const Vector3d sign(corner % 2 == 0 ? 1 : -1, corner < 2 ? 1 : -1, -1);
          const Vector3d at = placed.world_from_model *
                              (shape.model_from_shape * shape.half_size_m.cwiseProduct(sign));
          EXPECT_GT(DistanceToPolyline(line, at.head<2>()), 0.5 * road.width_m);
        }
      }
    }
  }
}

TEST(Surroundings, AreFixedPerStream) {
  const auto places = [](const Surroundings& made) {
    std::vector<Vector3d> all;
    for (const PlacedModel& placed : made.placed) {
      all.emplace_back(placed.world_from_model.translation());
    }
    return all;
  };
  EXPECT_EQ(places(Room(1)), places(Room(1)));
  EXPECT_NE(places(Room(1)), places(Room(2)));
  EXPECT_EQ(places(Street(1)), places(Street(1)));
  EXPECT_NE(places(Street(1)), places(Street(2)));
}

TEST(Surroundings, RefuseBadDescriptions) {
  RoomDescription room;
  room.shelves = 40;
  EXPECT_THAT(ErrorMessage([&] { Room(1, room); }),
              HasSubstr("no place along the walls for 40 shelves"));
  room = {};
  room.size_m = {5.0, 0.0, 2.5};
  EXPECT_THAT(ErrorMessage([&] { Room(1, room); }), HasSubstr("room.size_m"));
  EXPECT_THAT(ErrorMessage([] { Street(1, {}); }), HasSubstr("street.roads"));
  StreetDescription street = Crossing();
  street.roads[0].points.resize(1);
  EXPECT_THAT(ErrorMessage([&] { Street(1, street); }), HasSubstr("1 points"));
  street = Crossing();
  street.roads[0].corner_radius_m = 1.0;
  EXPECT_THAT(ErrorMessage([&] { Street(1, street); }), HasSubstr("corner_radius_m"));
}

}  // namespace
}  // namespace cvo::synth
