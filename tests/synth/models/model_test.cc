// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "core/files/images/image_codec.h"
#include "synth/models/make_model.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::synth {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

std::vector<std::string> OwnKinds() {
  std::vector<std::string> kinds;
  for (const std::string& kind : ModelKinds()) {
    if (kind != "mesh") kinds.push_back(kind);
  }
  return kinds;
}

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
  for (const std::string& kind : OwnKinds()) {
    for (const Part& part : Make(kind, 1).parts) {
      EXPECT_FALSE(part.mesh.two_sided) << kind;
      EXPECT_GT(Volume(part.mesh), 0.0) << kind;
    }
  }
}

TEST(MakeModel, EveryKindIsValidInTwoSizes) {
  for (const std::string& kind : OwnKinds()) {
    ExpectSound(Make(kind, 1), kind);
    const Vector3d size = kind == "ball" ? Vector3d::Constant(0.9) : Vector3d(1.3, 0.8, 1.1);
    const Model model = Make(kind, 1, size);
    EXPECT_EQ(model.size_m, size) << kind;
    ExpectSound(model, kind);
  }
}

TEST(MakeModel, ModelsAreFixedPerStream) {
  for (const std::string& kind : OwnKinds()) {
    EXPECT_TRUE(SameModel(Make(kind, 1), Make(kind, 1))) << kind;
    EXPECT_FALSE(SameModel(Make(kind, 1), Make(kind, 2))) << kind;
  }
}

TEST(MakeModel, CollisionShapesLieWithinTheBox) {
  for (const std::string& kind : OwnKinds()) {
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

TEST(MakeModel, NormalsOfABoxPointOutward) {
  const Model block = Make("block", 1);
  for (const Part& part : block.parts) {
    for (const Vertex& vertex : part.mesh.vertices) {
      EXPECT_GT(vertex.normal.dot(vertex.position), 0.1f);
    }
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
  EXPECT_THAT(ErrorMessage([] {
                Make("chair", 1, {0.5, 0.0, 1.0});
              }),
              HasSubstr("size_m of chair"));
  EXPECT_THAT(ErrorMessage([] {
                Make("chair", 1, {0.5, -0.5, 1.0});
              }),
              HasSubstr("three positive lengths"));
  EXPECT_THAT(ErrorMessage([] { Make("ball", 1, {0.5, 0.6, 0.5}); }), HasSubstr("same diameter"));
  EXPECT_THAT(ErrorMessage([] { Make("chair", 1, Vector3d::Zero(), "cheese"); }),
              HasSubstr("'cheese'"));
}

constexpr char kObj[] =
    "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 0.5\n"
    "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
constexpr char kPly[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n2 0 0\n0 1 0\n0 0 0.5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
// Four vertices and three triangles, in a node scaled by two.
constexpr char kGltf[] =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0,"scale":[2,2,2]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{"byteLength":66,"uri":"data:application/octet-stream;base64,)"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAD8AAAAAAAAAAAAAAAAAAIA+AAACAAEAAAABAAMAAQACAAMA"
    R"("}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":18}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,0.5,0.25]},
{"bufferView":1,"componentType":5123,"count":9,"type":"SCALAR"}]})";

Model Load(const std::filesystem::path& file, const Vector3d& size = Vector3d::Zero()) {
  Rng rng(1, "look");
  return MakeModel({"mesh", size, "", file}, rng);
}

TEST(MeshFile, ReadsObjPlyAndGltf) {
  const test::TempFolder folder;
  for (const auto& [name, content] :
       {std::pair{"a.obj", kObj}, std::pair{"a.ply", kPly}, std::pair{"a.gltf", kGltf}}) {
    const Model model = Load(folder.Write(name, content));
    ExpectSound(model, name);
    EXPECT_LT((model.size_m - Vector3d(2.0, 1.0, 0.5)).norm(), 1e-5) << name;
    const Model scaled = Load(folder.Write(name, content), {0.4, 0.3, 0.2});
    ExpectSound(scaled, name);
    EXPECT_EQ(scaled.size_m, Vector3d(0.4, 0.3, 0.2)) << name;
  }
}

TEST(MeshFile, LoadsItsTexture) {
  const test::TempFolder folder;
  const cv::Mat picture(20, 48, CV_8UC3, cv::Scalar(10, 20, 200));  // blue, green, red
  folder.Write("skin.png", EncodeImage(".png", picture));
  folder.Write("a.mtl", "newmtl skin\nmap_Kd skin.png\n");
  const std::string obj =
      "mtllib a.mtl\nusemtl skin\nv 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
      "f 1/1 3/2 2/3\nf 1/1 2/2 4/3\nf 2/1 3/2 4/3\n";
  const Model model = Load(folder.Write("a.obj", obj));
  ASSERT_EQ(model.parts.size(), 1u);
  const cv::Mat& texture = model.parts[0].texture;
  EXPECT_EQ(texture.size(), cv::Size(64, 32));
  EXPECT_EQ(texture.at<cv::Vec3b>(5, 5), cv::Vec3b(200, 20, 10));
  std::filesystem::remove(folder.path() / "skin.png");
  EXPECT_THAT(ErrorMessage([&] { Load(folder.path() / "a.obj"); }),
              AllOf(HasSubstr("a.obj"), HasSubstr("skin.png")));
}

TEST(MeshFile, BadFilesAreNamed) {
  const test::TempFolder folder;
  const auto message = [&](const std::filesystem::path& file) {
    return ErrorMessage([&] { Load(file); });
  };
  EXPECT_THAT(message(folder.path() / "none.obj"),
              AllOf(HasSubstr("none.obj"), HasSubstr("no such file")));
  EXPECT_THAT(message(""), HasSubstr("no such file"));
  EXPECT_THAT(message(folder.Write("empty.obj", "")), HasSubstr("empty.obj"));
  EXPECT_THAT(message(folder.Write("noise.ply", "not a mesh\n")), HasSubstr("noise.ply"));
  EXPECT_THAT(message(folder.Write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 1\nl 1 2 3\n")),
              AllOf(HasSubstr("points.obj"), HasSubstr("no triangles")));
  EXPECT_THAT(message(folder.Write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")),
              AllOf(HasSubstr("flat.obj"), HasSubstr("flat mesh")));
}

}  // namespace
}  // namespace cvo::synth
