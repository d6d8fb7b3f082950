// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <bit>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/files/images/image_codec.h"
#include "synth/models/builders.h"

namespace cvo::synth {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr int kLargestSide_px = 1024;

int PowerOfTwo(int side) {
  const auto rounded = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(side, 1))));
  return std::min(rounded, kLargestSide_px);
}

cv::Mat Decode(const aiTexture& texture) {
  if (texture.mHeight == 0) {
    return DecodeImage({reinterpret_cast<const char*>(texture.pcData), texture.mWidth},
                       cv::IMREAD_COLOR);
  }
  const cv::Mat texels(static_cast<int>(texture.mHeight), static_cast<int>(texture.mWidth), CV_8UC4,
                       texture.pcData);
  cv::Mat image;
  cv::cvtColor(texels, image, cv::COLOR_BGRA2BGR);
  return image;
}

// Returns the diffuse texture as RGB with sides that are powers of two; empty if the material has
// none. Throws Error if the texture cannot be read.
cv::Mat ReadDiffuse(const aiScene& scene, const aiMaterial& material, const fs::path& file) {
  aiString name;
  if (material.GetTexture(aiTextureType_DIFFUSE, 0, &name) != aiReturn_SUCCESS &&
      material.GetTexture(aiTextureType_BASE_COLOR, 0, &name) != aiReturn_SUCCESS) {
    return {};
  }
  const aiTexture* embedded = scene.GetEmbeddedTexture(name.C_Str());
  const fs::path path = file.parent_path() / name.C_Str();
  std::error_code ignored;
  cv::Mat image;
  if (embedded != nullptr) {
    image = Decode(*embedded);
  } else if (fs::is_regular_file(path, ignored)) {
    image = ReadImageFile(path, cv::IMREAD_COLOR);
  }
  if (image.empty()) {
    ThrowError(file.string(), StrCat("texture ", name.C_Str(), " that cannot be read"),
               "an image file beside it");
  }
  cv::Mat square;
  cv::resize(image, square, {PowerOfTwo(image.cols), PowerOfTwo(image.rows)}, 0, 0, cv::INTER_AREA);
  cv::Mat rgb;
  cv::cvtColor(square, rgb, cv::COLOR_BGR2RGB);
  return rgb;
}

struct Instance {
  unsigned mesh;
  aiMatrix4x4 model_from_mesh;
};

void CollectInstances(const aiNode& node, const aiMatrix4x4& model_from_parent,
                      std::vector<Instance>& instances) {
  const aiMatrix4x4 model_from_node = model_from_parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    instances.push_back({node.mMeshes[i], model_from_node});
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    CollectInstances(*node.mChildren[i], model_from_node, instances);
  }
}

Vector3d ToEigen(const aiVector3D& v) { return {v.x, v.y, v.z}; }

void AppendMesh(const aiMesh& from, const aiMatrix4x4& model_from_mesh, Mesh& to) {
  const auto first = static_cast<std::uint32_t>(to.vertices.size());
  const aiMatrix3x3 turn(model_from_mesh);
  const aiMatrix3x3 normals_turn = aiMatrix3x3(turn).Inverse().Transpose();
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    const Vector3d point = ToEigen(model_from_mesh * from.mVertices[i]);
    Vector3d normal = ToEigen(normals_turn * from.mNormals[i]);
    normal = normal.norm() > 1e-12 && normal.allFinite() ? normal.normalized() : Vector3d::UnitZ();
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();
    if (from.HasTextureCoords(0)) uv = {from.mTextureCoords[0][i].x, from.mTextureCoords[0][i].y};
    to.vertices.push_back({point.cast<float>(), normal.cast<float>(), uv});
  }
  for (unsigned f = 0; f < from.mNumFaces; ++f) {
    if (from.mFaces[f].mNumIndices != 3) continue;
    for (unsigned i = 0; i < 3; ++i) to.indices.push_back(first + from.mFaces[f].mIndices[i]);
  }
}

// Reads the parts of a file, one per material. A part without a texture has an empty image.
std::vector<Part> ReadParts(const fs::path& file) {
  std::error_code ignored;
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)) {
    ThrowError(file.string(), "no file, or a pipe or a device", "OBJ, PLY or glTF");
  }
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_GenSmoothNormals |
                                           aiProcess_JoinIdenticalVertices | aiProcess_FlipUVs |
                                           aiProcess_SortByPType);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    std::string reason = importer.GetErrorString();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    ThrowError(file.string(), "no mesh (" + reason + ")", "OBJ, PLY or glTF");
  }
  std::vector<Instance> instances;
  CollectInstances(*scene->mRootNode, {}, instances);
  std::map<unsigned, Part> by_material;
  for (const Instance& instance : instances) {
    const aiMesh& mesh = *scene->mMeshes[instance.mesh];
    if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) == 0) continue;
    const auto [part, is_new] = by_material.try_emplace(mesh.mMaterialIndex);
    if (is_new && mesh.HasTextureCoords(0)) {
      part->second.texture = ReadDiffuse(*scene, *scene->mMaterials[mesh.mMaterialIndex], file);
    }
    AppendMesh(mesh, instance.model_from_mesh, part->second.mesh);
  }
  std::vector<Part> parts;
  for (auto& [material, part] : by_material) {
    if (!part.mesh.indices.empty()) parts.push_back(std::move(part));
  }
  return parts;
}

void CheckVolume(const std::vector<Part>& parts, const fs::path& file) {
  Eigen::AlignedBox3f box;
  for (const Part& part : parts) {
    for (const Vertex& vertex : part.mesh.vertices) {
      if (!vertex.position.allFinite()) {
        ThrowError(file.string(), "a vertex that is not finite", "finite positions");
      }
      box.extend(vertex.position);
    }
  }
  if (parts.empty()) ThrowError(file.string(), "no triangles", "a mesh of triangles or polygons");
  if (!(box.sizes().minCoeff() > 0.0f)) {
    ThrowError(file.string(), "a flat mesh", "one with length, width and height");
  }
}

}  // namespace

Model BuildFromFile(const BuildRequest& request, Rng& look) {
  std::error_code ignored;
  if (request.file.empty() || !fs::is_regular_file(request.file, ignored)) {
    ThrowError("mesh '" + request.file.string() + "'", "no such file", "OBJ, PLY or glTF");
  }
  Model model;
  model.parts = ReadParts(request.file);
  CheckVolume(model.parts, request.file);
  Texture texture;
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());
  Vector3d high = -low;
  for (Part& part : model.parts) {
    const bool plain = part.texture.empty();
    if (plain && texture.image.empty()) texture = MaterialOr(request, "block", look);
    if (plain) part.texture = texture.image;
    for (Vertex& vertex : part.mesh.vertices) {
      const Vector3d p = vertex.position.cast<double>();
      if (plain) {
        vertex.uv =
            BoxMapping(p, vertex.normal.cast<double>()).cwiseQuotient(texture.size_m).cast<float>();
      }
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  model.shapes.push_back(MakeBoxShape(low, high));
  return model;
}

}  // namespace cvo::synth
