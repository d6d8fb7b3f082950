// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/models/builders.h"

namespace cvo::synth {

using Eigen::Vector3d;

Model BuildBall(const BuildRequest& request, Rng& look) {
  Model model;
  const double radius = 0.5 * request.size_m.x();
  Part part = MakePart(MaterialOr(request, "ball", look));
  AddBall(part.mesh, {}, radius, 14);
  part.gloss = 0.15f;
  model.parts.push_back(std::move(part));
  CollisionShape shape;
  shape.radius_m = radius;
  shape.half_size_m = Vector3d::Constant(radius);
  model.shapes.push_back(shape);
  return model;
}

// Shows six pictures unless a material is requested.
Model BuildBlock(const BuildRequest& request, Rng& look) {
  Model model;
  const Vector3d low = Vector3d::Zero();
  const Vector3d& high = request.size_m;
  if (request.material.empty()) {
    for (int face = 0; face < 6; ++face) {
      Part part = MakePart(MakeTexture("block", look));
      AddPicture(part.mesh, {}, BoxFace(low, high, face));
      model.parts.push_back(std::move(part));
    }
  } else {
    const Texture texture = MakeTexture(request.material, look);
    Part part = MakePart(texture);
    AddBox(part.mesh, PenFor(texture, look), low, high);
    model.parts.push_back(std::move(part));
  }
  model.shapes.push_back(MakeBoxShape(low, high));
  return model;
}

// A stack of boxes, the upper ones a little smaller.
Model BuildTower(const BuildRequest& request, Rng& look) {
  Model model;
  const Vector3d& size = request.size_m;
  const int storeys = std::max(2, static_cast<int>(size.z() / 0.4 + 0.5));
  const double height = size.z() / storeys;
  std::vector<Texture> textures;
  for (int i = 0; i < 3; ++i) textures.push_back(MaterialOr(request, "block", look));
  model.parts.resize(textures.size());
  for (std::size_t i = 0; i < textures.size(); ++i) model.parts[i].texture = textures[i].image;
  for (int i = 0; i < storeys; ++i) {
    const std::size_t which = static_cast<std::size_t>(i) % textures.size();
    const double part = i == 0 ? 1.0 : look.Uniform(0.82, 0.97);
    const Vector3d half(0.5 * part * size.x(), 0.5 * part * size.y(), 0.0);
    const Pen pen{textures[which].size_m, {look.Uniform(), look.Uniform()}, {}};
    const Vector3d low = Vector3d(0, 0, i * height) - half;
    AddBox(model.parts[which].mesh, pen, low, half + Vector3d(0, 0, (i + 1) * height));
  }
  model.shapes.push_back(MakeBoxShape(Vector3d(-0.5 * size.x(), -0.5 * size.y(), 0.0),
                                      Vector3d(0.5 * size.x(), 0.5 * size.y(), size.z())));
  return model;
}

}  // namespace cvo::synth
