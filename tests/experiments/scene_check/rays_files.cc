// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/files/json/json.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/metrics/trajectory.h"
#include "tests/experiments/scene_check/rays.h"
#include "tests/support/image_file.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;

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

void WriteFlow(const Writer& writer, int frame) {
  const RayScene& scene = writer.scene;
  const StereoCamera& camera = scene.camera();
  cv::Mat flow(camera.height_px, camera.width_px, CV_16UC3, cv::Scalar::all(0));
  for (int v = 0; v < flow.rows; ++v) {
    for (int u = 0; u < flow.cols; ++u) {
      const auto hit = scene.Cast(scene.WorldFromLeft(frame), u, v, frame);
      const Eigen::Vector3d p_in_left((u - camera.cx) / camera.fx * hit.depth_m,
                                      (v - camera.cy) / camera.fy * hit.depth_m, hit.depth_m);
      Eigen::Vector3d p_in_world = scene.WorldFromLeft(frame) * p_in_left;
      if (hit.body > 0) {
        p_in_world = scene.WorldFromObject(hit.body, frame + 1) *
                     (scene.WorldFromObject(hit.body, frame).Inverse() * p_in_world);
      }
      const auto z_px = camera.Project(scene.WorldFromLeft(frame + 1).Inverse() * p_in_world);
      const auto code = [](double flow_px) {
        return static_cast<std::uint16_t>(std::lround(64.0 * flow_px) + 32768);
      };
      if (z_px) flow.at<cv::Vec3w>(v, u) = {1, code((*z_px)[1] - v), code((*z_px)[0] - u)};
    }
  }
  writer.Image("flow_0/" + Number(frame, ".png"), flow);
}

// The target is a tilted chequerboard; each pixel is the mean of 8 x 8 rays.
constexpr double kSquare_m = 0.12;

double BoardAt(const RigidTransform& camera_from_board, const Eigen::Vector3d& camera_in_left,
               const Eigen::Vector3d& along) {
  const RigidTransform board_from_camera = camera_from_board.Inverse();
  const Eigen::Vector3d from = board_from_camera * camera_in_left;
  const Eigen::Vector3d ray = board_from_camera.rotation() * along;
  const Eigen::Vector3d p = from - from.z() / ray.z() * ray;
  const auto square =
      static_cast<int>(std::floor(p.x() / kSquare_m) + std::floor(p.y() / kSquare_m));
  return square % 2 == 0 ? 220.0 : 40.0;
}

void WriteTarget(const Writer& writer) {
  constexpr int kRays = 8;
  const StereoCamera& camera = writer.scene.camera();
  const RigidTransform camera_from_board(ExpSo3({0.15, -0.2, 0.1}), Eigen::Vector3d(0, 0, 1.3));
  for (int side = 0; side < 2; ++side) {
    cv::Mat image(camera.height_px, camera.width_px, CV_8UC1);
    for (int v = 0; v < image.rows; ++v) {
      for (int u = 0; u < image.cols; ++u) {
        double sum = 0.0;
        for (int i = 0; i < kRays * kRays; ++i) {
          const double du = (i % kRays + 0.5) / kRays - 0.5, dv = (i / kRays + 0.5) / kRays - 0.5;
          sum += BoardAt(camera_from_board, {side * camera.baseline_m, 0.0, 0.0},
                         {(u + du - camera.cx) / camera.fx, (v + dv - camera.cy) / camera.fy, 1.0});
        }
        image.at<unsigned char>(v, u) =
            static_cast<unsigned char>(std::lround(sum / (kRays * kRays)));
      }
    }
    writer.Image(StrCat("calibration/image_", side, "/000000.png"), image);
  }
  std::string corners = "frame,corner,x,y,z\n";
  for (int i = 0; i < 63; ++i) {
    const Eigen::Vector3d corner =
        camera_from_board * Eigen::Vector3d((i % 9 - 4) * kSquare_m, (i / 9 - 3) * kSquare_m, 0.0);
    corners += StrCat("0,", i, ",") + FormatDouble(corner.x()) + "," + FormatDouble(corner.y()) +
               "," + FormatDouble(corner.z()) + "\n";
  }
  writer.Text("calibration/targets.csv", corners);
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
    if (frame + 1 < RayScene::kFrames) WriteFlow(writer, frame);
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
  WriteTarget(writer);
  WriteManifest(writer);
}

}  // namespace cvo::test
