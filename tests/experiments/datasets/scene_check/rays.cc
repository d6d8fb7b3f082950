// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/experiments/datasets/scene_check/rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/metrics/trajectory.h"
#include "tests/support/image_file.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;

constexpr double kWallDistance_m = 4.0;
constexpr double kFloor_m = 0.9;  // below the camera
constexpr double kSpeed_mps = 0.5;

// Distance to the nearest hit in front, as a multiple of `along`, whose depth is 1; none if the ray
// misses.
std::optional<double> HitBall(const Eigen::Vector3d& from, const Eigen::Vector3d& along,
                              double radius_m) {
  const double a = along.squaredNorm(), b = from.dot(along);
  const double c = from.squaredNorm() - radius_m * radius_m;
  const double root = b * b - a * c;
  if (root < 0.0 || -b - std::sqrt(root) <= 0.0) return std::nullopt;
  return (-b - std::sqrt(root)) / a;
}

std::optional<double> HitBox(const Eigen::Vector3d& from, const Eigen::Vector3d& along,
                             const Eigen::Vector3d& half_m) {
  double enter = 0.0, leave = 1e9;
  for (int i = 0; i < 3; ++i) {
    const double inverse = 1.0 / (std::abs(along[i]) < 1e-12 ? 1e-12 : along[i]);
    const double a = (-half_m[i] - from[i]) * inverse, b = (half_m[i] - from[i]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter > leave || enter <= 0.0) return std::nullopt;
  return enter;
}

}  // namespace

RayScene::RayScene()
    : camera_{.fx = 280.0,
              .fy = 280.0,
              .cx = 199.5,
              .cy = 149.5,
              .baseline_m = 0.12,
              .width_px = 400,
              .height_px = 300} {
  // Wavelengths of 9 to 20 cm, which is 8 to 20 px.
  Rng rng(7, "texture");
  for (int i = 0; i < waves_.cols(); ++i) {
    const Eigen::Vector3d direction(rng.Normal(), rng.Normal(), rng.Normal());
    waves_.col(i) = direction.normalized() * 2.0 * M_PI / rng.Uniform(0.09, 0.2);
    phases_[i] = rng.Uniform(0.0, 2.0 * M_PI);
  }
}

double RayScene::Texture(const Eigen::Vector3d& p, int body) const {
  const double scale = body == 0 ? 1.0 : 1.7;  // finer on bodies, for many corners
  double sum = 0.0;
  for (int i = 0; i < waves_.cols(); ++i) {
    sum += std::sin(scale * waves_.col(i).dot(p) + phases_[i] + 2.0 * body);
  }
  return std::clamp(128.0 + 18.0 * sum, 0.0, 255.0);
}

RayScene::Hit RayScene::Cast(const RigidTransform& world_from_camera, double u, double v,
                             int frame) const {
  const Eigen::Vector3d along((u - camera_.cx) / camera_.fx, (v - camera_.cy) / camera_.fy, 1.0);
  const Eigen::Vector3d from = world_from_camera.translation();
  const Eigen::Vector3d ray = world_from_camera.rotation() * along;
  Hit hit{(kWallDistance_m - from.z()) / ray.z(), 0, 0.0};
  if (ray.y() > 0.0) hit.depth_m = std::min(hit.depth_m, (kFloor_m - from.y()) / ray.y());
  Eigen::Vector3d p = from + hit.depth_m * ray;
  for (int body = 1; body <= kBodies; ++body) {
    const RigidTransform object_from_world = WorldFromObject(body, frame).Inverse();
    const Eigen::Vector3d o = object_from_world * from, d = object_from_world.rotation() * ray;
    const auto distance =
        body == 1 ? HitBall(o, d, kBallRadius_m) : HitBox(o, d, 0.5 * Size_m(body));
    if (!distance || *distance >= hit.depth_m) continue;
    hit = {*distance, body, 0.0};
    p = o + *distance * d;
  }
  hit.grey = Texture(p, hit.body);
  return hit;
}

RigidTransform RayScene::WorldFromLeft(int frame) const {
  // Curved: alignment by positions leaves the roll of a straight path open, and with it the parts
  // of the error.
  return {ExpSo3({0.0, 0.01 * frame, 0.002 * frame}),
          Eigen::Vector3d(0.03, 0.004 + 0.002 * frame, 0.02) * frame};
}

RigidTransform RayScene::WorldFromRight(int frame) const {
  return WorldFromLeft(frame) *
         RigidTransform(Eigen::Quaterniond::Identity(), {camera_.baseline_m, 0.0, 0.0});
}

RigidTransform RayScene::WorldFromObject(int body, int frame) const {
  Eigen::Matrix3d R;  // forward is world z, left -x, up -y
  R << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  const Eigen::Quaterniond upright(R);
  if (body == 2) return {upright, Eigen::Vector3d(0.7, 0.45, 2.6)};
  const double time_s = frame / kRate_hz;
  return {ExpSo3(AngularVelocity(1) * time_s) * upright,
          Eigen::Vector3d(-0.6, 0.3, 2.2) + Velocity(1) * time_s};
}

Eigen::Vector3d RayScene::Velocity(int body) const {
  return body == 1 ? Eigen::Vector3d(kSpeed_mps, 0.0, 0.0) : Eigen::Vector3d::Zero();
}

Eigen::Vector3d RayScene::AngularVelocity(int body) const {
  return body == 1 ? Eigen::Vector3d(0.0, 0.0, kSpeed_mps / kBallRadius_m)
                   : Eigen::Vector3d::Zero();
}

Eigen::Vector3d RayScene::Size_m(int body) const {
  return Eigen::Vector3d::Constant(body == 1 ? 2.0 * kBallRadius_m : 0.5);
}

namespace {

constexpr const char* kHeader =
    "frame,id,name,category,x,y,z,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,length_m,width_m,height_m,"
    "visible_px,alone_px,visible_fraction,truncation,visible_left,visible_top,visible_right,"
    "visible_bottom,amodal_left,amodal_top,amodal_right,amodal_bottom\n";

struct Mask {
  int pixels = 0;
  std::array<int, 4> box = {1 << 20, 1 << 20, -1, -1};
};

struct Writer {
  fs::path folder;
  std::map<std::string, std::string> texts;
  RayScene scene;
  Rng noise{1, "noise"};

  void Image(const std::string& name, const cv::Mat& image) const {
    fs::create_directories((folder / name).parent_path());
    WriteImageFile(folder / name, image);
  }
  void Text(const std::string& name, const std::string& text) const {
    fs::create_directories((folder / name).parent_path());
    WriteFileBytes(folder / name, text);
  }
};

std::string Number(int frame, const char* extension) {
  std::string digits = std::to_string(frame);
  return std::string(6 - digits.size(), '0') + digits + extension;
}

template <typename Vector>
std::string Cells(const Vector& values) {
  std::string text;
  for (const double value : values) text += FormatDouble(value) + ",";
  return text;
}

cv::Mat DrawImage(Writer& writer, const RigidTransform& world_from_camera, int frame) {
  const StereoCamera& camera = writer.scene.camera();
  cv::Mat image(camera.height_px, camera.width_px, CV_8UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const double grey = writer.scene.Cast(world_from_camera, u, v, frame).grey;
      image.at<unsigned char>(v, u) =
          cv::saturate_cast<unsigned char>(grey + writer.noise.Normal());
    }
  }
  return image;
}

std::vector<Mask> DrawTruth(const Writer& writer, int frame) {
  const StereoCamera& camera = writer.scene.camera();
  cv::Mat depth(camera.height_px, camera.width_px, CV_32FC1);
  cv::Mat instances(depth.size(), CV_16UC1);
  std::vector<Mask> masks(RayScene::kBodies);
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      const auto hit = writer.scene.Cast(writer.scene.WorldFromLeft(frame), u, v, frame);
      depth.at<float>(v, u) = static_cast<float>(hit.depth_m);
      instances.at<std::uint16_t>(v, u) = static_cast<std::uint16_t>(hit.body);
      if (hit.body == 0) continue;
      Mask& mask = masks[static_cast<std::size_t>(hit.body) - 1];
      ++mask.pixels;
      mask.box = {std::min(mask.box[0], u), std::min(mask.box[1], v), std::max(mask.box[2], u),
                  std::max(mask.box[3], v)};
    }
  }
  writer.Image("depth_0/" + Number(frame, ".tiff"), depth);
  writer.Image("instance_0/" + Number(frame, ".png"), instances);
  return masks;
}

// Nothing is occluded or truncated in this scene: visible and amodal boxes are the same.
void AddBody(Writer& writer, int frame, int body, const Mask& mask) {
  const RayScene& scene = writer.scene;
  const RigidTransform pose = scene.WorldFromObject(body, frame);
  const Eigen::Vector3d size_m = scene.Size_m(body);
  const std::string category = body == 1 ? "Ball" : "Block";
  const std::string box = StrCat(mask.box[0], ",", mask.box[1], ",", mask.box[2], ",", mask.box[3]);
  writer.texts["objects.csv"] +=
      StrCat(frame, ",", body, ",", body == 1 ? "ball_1" : "block_1", ",", category, ",") +
      Cells(pose.translation()) + Cells(pose.rotation().coeffs()) + Cells(scene.Velocity(body)) +
      Cells(scene.AngularVelocity(body)) + Cells(size_m) +
      StrCat(mask.pixels, ",", mask.pixels, ",1,0,", box, ",", box, "\n");
  const RigidTransform left_from_object = scene.WorldFromLeft(frame).Inverse() * pose;
  const Eigen::Vector3d bottom = left_from_object * Eigen::Vector3d(0, 0, -size_m.z() / 2);
  const Eigen::Vector3d forward = left_from_object.rotation() * Eigen::Vector3d::UnitX();
  std::string blanks = box;
  std::replace(blanks.begin(), blanks.end(), ',', ' ');
  writer.texts["labels.txt"] += StrCat(
      frame, " ", body, " ", category, " 0 0 0 ", blanks, " ", size_m.z(), " ", size_m.y(), " ",
      size_m.x(), " ", bottom.transpose(), " ", std::atan2(-forward.z(), forward.x()), "\n");
  for (const char* level : {"oracle", "good", "poor"}) {
    writer.texts[StrCat("detections/", level, ".txt")] += StrCat(
        frame, " -1 ", category, " -1 -1 -10 ", blanks, " -1 -1 -1 -1000 -1000 -1000 -10 1\n");
  }
}

void WriteManifest(const Writer& writer) {
  Json files = Json::array();
  for (const auto& entry : fs::recursive_directory_iterator(writer.folder)) {
    if (entry.is_directory()) continue;
    files.push_back({{"name", fs::relative(entry.path(), writer.folder).generic_string()},
                     {"size_bytes", fs::file_size(entry.path())},
                     {"sha256", Sha256Hex(ReadFileBytes(entry.path()))}});
  }
  writer.Text("manifest.json", DumpJson({{"files", files}}));
}

}  // namespace

void WriteRayScene(const fs::path& folder) {
  Writer writer{folder, {}, {}};
  std::vector<RigidTransform> left, right;
  writer.texts["objects.csv"] = kHeader;
  for (int frame = 0; frame < RayScene::kFrames; ++frame) {
    left.push_back(writer.scene.WorldFromLeft(frame));
    right.push_back(writer.scene.WorldFromRight(frame));
    writer.Image("image_0/" + Number(frame, ".png"), DrawImage(writer, left.back(), frame));
    writer.Image("image_1/" + Number(frame, ".png"), DrawImage(writer, right.back(), frame));
    const std::vector<Mask> masks = DrawTruth(writer, frame);
    for (int body = 1; body <= RayScene::kBodies; ++body) {
      AddBody(writer, frame, body, masks[static_cast<std::size_t>(body) - 1]);
    }
    writer.texts["times.txt"] += FormatDouble(frame / RayScene::kRate_hz) + "\n";
  }
  const StereoCamera& camera = writer.scene.camera();
  for (int side = 0; side < 2; ++side) {
    writer.texts["calib.txt"] += StrCat("P", side, ": ", camera.fx, " 0 ", camera.cx, " ",
                                        -side * camera.fx * camera.baseline_m, " 0 ", camera.fy,
                                        " ", camera.cy, " 0 0 0 1 0\n");
  }
  writer.texts["poses.txt"] = FormatKittiPoses(left);
  writer.texts["poses_right.txt"] = FormatKittiPoses(right);
  for (const auto& [name, text] : writer.texts) writer.Text(name, text);
  WriteManifest(writer);
}

}  // namespace cvo::test
