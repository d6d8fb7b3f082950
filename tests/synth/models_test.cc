// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/files/images/image_file.h"
#include "synth/models/build.h"
#include "synth/models/model.h"
#include "tests/support/error_message.h"

namespace cvo::synth {
namespace {

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

void ExpectSound(const Model& model, const std::string& what) {
  ASSERT_FALSE(model.parts.empty()) << what;
  for (const Part& part : model.parts) {
    ASSERT_FALSE(part.texture.empty()) << what;
    ASSERT_FALSE(part.mesh.indices.empty()) << what;
    ASSERT_EQ(part.mesh.indices.size() % 3, 0u) << what;
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

TEST(MakeModel, NormalsPointOutward) {
  for (const std::string& kind : ModelKinds()) {
    for (const Part& part : Make(kind, 1).parts) {
      EXPECT_FALSE(part.mesh.two_sided) << kind;
      EXPECT_GT(Volume(part.mesh), 0.0) << kind;
    }
  }
}

TEST(MakeModel, EveryKindIsValidInTwoSizes) {
  for (const std::string& kind : ModelKinds()) {
    ExpectSound(Make(kind, 1), kind);
    const Vector3d size = kind == "ball" ? Vector3d::Constant(0.9) : Vector3d(1.3, 0.8, 1.1);
    const Model model = Make(kind, 1, size);
    EXPECT_EQ(model.size_m, size) << kind;
    ExpectSound(model, kind);
  }
}

TEST(MakeModel, ModelsAreFixedPerStream) {
  for (const std::string& kind : ModelKinds()) {
    EXPECT_TRUE(SameModel(Make(kind, 1), Make(kind, 1))) << kind;
    EXPECT_FALSE(SameModel(Make(kind, 1), Make(kind, 2))) << kind;
  }
}

TEST(MakeModel, CollisionShapesLieWithinTheBox) {
  for (const std::string& kind : ModelKinds()) {
    const Model model = Make(kind, 1);
    ASSERT_FALSE(model.shapes.empty()) << kind;
    for (const CollisionShape& shape : model.shapes) {
      const Vector3d reach = shape.model_from_shape.translation().cwiseAbs() + shape.half_size_m;
      EXPECT_LT((reach - 0.5 * model.size_m).maxCoeff(), 1e-5) << kind;
    }
  }
  EXPECT_NEAR(Make("ball", 1).shapes.at(0).radius_m, 0.3, 1e-6);
}

TEST(MakeModel, ChairsAreOpenBetweenTheirLegs) {
  const Model chair = Make("chair", 1);
  const Vector3d below(0.0, 0.0, -0.5 * chair.size_m.z() + 0.15);
  for (const CollisionShape& shape : chair.shapes) {
    const Vector3d local = shape.model_from_shape.Inverse() * below;
    EXPECT_GT((local.cwiseAbs() - shape.half_size_m).maxCoeff(), 0.1);
  }
}

TEST(MakeModel, NormalsOfABallPointOutward) {
  const Model ball = Make("ball", 1);
  for (const Vertex& vertex : ball.parts.at(0).mesh.vertices) {
    EXPECT_GT(vertex.normal.dot(vertex.position.normalized()), 0.999f);
  }
}

TEST(MakeModel, SidesOfABlockDiffer) {
  const Model block = Make("block", 1);
  ASSERT_EQ(block.parts.size(), 6u);
  for (int i = 1; i < 6; ++i) {
    EXPECT_GT(cv::norm(block.parts[0].texture, block.parts[i].texture, cv::NORM_INF), 0.0);
  }
}

TEST(MakeModel, TakesAMaterial) {
  EXPECT_FALSE(SameModel(Make("tower", 1, Vector3d::Zero(), "brick"), Make("tower", 1)));
}

TEST(MakeModel, RefusesBadDescriptions) {
  EXPECT_THAT(ErrorMessage([] { Make("dragon", 1); }),
              AllOf(HasSubstr("'dragon'"), HasSubstr("ball, block")));
  EXPECT_THAT(ErrorMessage([] { Make("ball", 1, {0.5, 0.6, 0.5}); }), HasSubstr("same diameter"));
  EXPECT_THAT(ErrorMessage([] { Make("chair", 1, Vector3d::Zero(), "cheese"); }),
              HasSubstr("'cheese'"));
}

bool SameImage(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

TEST(Textures, AreInColourWithPowerOfTwoSizes) {
  Rng rng(0, "test");
  for (const std::string& material : MaterialNames()) {
    const Texture texture = MakeTexture(material, rng);
    EXPECT_EQ(texture.image.type(), CV_8UC3) << material;
    EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(texture.image.cols))) << material;
    EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(texture.image.rows))) << material;
    EXPECT_LE(std::max(texture.image.cols, texture.image.rows), 1024) << material;
    EXPECT_GT(texture.size_m.minCoeff(), 0.0) << material;
  }
}

TEST(Textures, AreFixedPerStream) {
  for (const std::string& material : MaterialNames()) {
    Rng first(3, "look");
    Rng again(3, "look");
    Rng other(4, "look");
    const cv::Mat image = MakeTexture(material, first).image;
    EXPECT_TRUE(SameImage(image, MakeTexture(material, again).image)) << material;
    EXPECT_FALSE(SameImage(image, MakeTexture(material, other).image)) << material;
    EXPECT_FALSE(SameImage(image, MakeTexture(material, first).image)) << material;
  }
}

// The grey-level step across the border, where the texture repeats, is no larger than those inside.
TEST(Textures, AreSeamless) {
  Rng rng(1, "test");
  for (const char* material : {"asphalt", "brick", "concrete", "grass", "leaves", "pavement",
                               "plaster", "tiles", "wallpaper", "parquet"}) {
    cv::Mat grey;
    cv::cvtColor(MakeTexture(material, rng).image, grey, cv::COLOR_RGB2GRAY);
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

// Moving bodies have more corners than their background, or they would not get their share of the
// features that a front end keeps. The upper walls have almost none.
TEST(Textures, HaveCornersAtTwoMetresIndoorsWhereTheyAreNeeded) {
  const auto density = [](const char* material) { return MeanDensity(material, 450.0 / 2.0); };
  for (const char* material : {"ball", "block", "fabric"}) {
    EXPECT_GE(density(material), 10.0) << material;
  }
  for (const char* material : {"brick", "plaster", "poster", "tiles", "wallpaper", "wood"}) {
    EXPECT_GE(density(material), 5.0) << material;
  }
  EXPECT_GE(density("carpet"), 1.0);
  EXPECT_LE(density("embossed"), 0.5);
}

// Cars have more corners than the objects along the road, and these more than the road itself, or
// they would not get their share of the features that a front end keeps.
TEST(Textures, HaveCornersAtFifteenMetresOutdoorsWhereTheyAreNeeded) {
  const auto density = [](const char* material) { return MeanDensity(material, 721.0 / 15.0); };
  EXPECT_GE(density("paint"), 20.0);
  for (const char* material : {"bark", "brick", "concrete", "grass", "leaves", "roof"}) {
    EXPECT_GE(density(material), 4.0) << material;
  }
  EXPECT_GE(density("facade"), 2.0);
  EXPECT_LE(density("facade"), 8.0);
  for (const char* material : {"asphalt", "pavement"}) {
    EXPECT_GE(density(material), 0.2) << material;
    EXPECT_LE(density(material), 2.0) << material;
  }
}

TEST(Textures, RefuseUnknownMaterials) {
  Rng rng(0, "test");
  EXPECT_THAT(ErrorMessage([&] { MakeTexture("cheese", rng); }),
              AllOf(HasSubstr("'cheese'"), HasSubstr("asphalt, ball")));
}

}  // namespace
}  // namespace cvo::synth
