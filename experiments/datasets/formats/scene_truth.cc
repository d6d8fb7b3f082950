// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/formats/scene_truth.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/json/json_record.h"
#include "core/files/text_file.h"
#include "experiments/datasets/formats/image_format.h"

namespace cvo {
namespace fs = std::filesystem;

namespace {

Eigen::Vector3d ReadVector(const CsvFile& file, std::size_t row, std::size_t column) {
  return {file.Number(row, column), file.Number(row, column + 1), file.Number(row, column + 2)};
}

Eigen::Quaterniond ReadRotation(const CsvFile& file, std::size_t row, std::size_t column) {
  constexpr double kTolerance = 1e-6;
  const Eigen::Quaterniond rotation(file.Number(row, column + 3), file.Number(row, column),
                                    file.Number(row, column + 1), file.Number(row, column + 2));
  if (std::abs(rotation.norm() - 1.0) > kTolerance) {
    file.Fail(row, StrCat("a quaternion of length ", rotation.norm()), "one of length 1");
  }
  return rotation;
}

// Reads a box of four numbers; empty for four empty cells.
std::optional<ImageBox> ReadBox(const CsvFile& file, std::size_t row, std::size_t column) {
  int empty = 0;
  for (std::size_t i = 0; i < 4; ++i) empty += file.Empty(row, column + i) ? 1 : 0;
  if (empty == 4) return std::nullopt;
  const ImageBox box = {file.Number(row, column), file.Number(row, column + 1),
                        file.Number(row, column + 2), file.Number(row, column + 3)};
  if (box.right_px < box.left_px || box.bottom_px < box.top_px) {
    file.Fail(row,
              StrCat("a box of ", box.right_px - box.left_px, " x ", box.bottom_px - box.top_px),
              "left <= right and top <= bottom");
  }
  return box;
}

SceneBody ReadBody(const CsvFile& file, std::size_t row) {
  SceneBody body;
  body.id = file.Integer(row, 1);
  body.name = file.Name(row, 2);
  body.category = file.Name(row, 3);
  body.world_from_object = {ReadRotation(file, row, 7), ReadVector(file, row, 4)};
  body.velocity_in_world = ReadVector(file, row, 11);
  body.angular_velocity_in_world = ReadVector(file, row, 14);
  body.size_m = ReadVector(file, row, 17);
  body.visible_px = file.Integer(row, 20);
  body.visible_fraction = file.Number(row, 22);
  body.visible_box = ReadBox(file, row, 24);
  if (!(body.size_m.minCoeff() > 0.0)) {
    file.Fail(row, StrCat("a size of ", body.size_m.transpose(), " m"), "positive sizes");
  }
  return body;
}

void CheckSame(const CsvFile& file, std::size_t row, const SceneBody& body,
               const SceneBody& first) {
  if (body.name == first.name && body.category == first.category && body.size_m == first.size_m) {
    return;
  }
  file.Fail(row, StrCat(body.name, ", ", body.category, ", ", body.size_m.transpose()),
            StrCat("body ", body.id, " as in frame 0: ", first.name, ", ", first.category, ", ",
                   first.size_m.transpose()));
}

std::string Describe(int type, cv::Size size) {
  return StrCat(size.width, "x", size.height, " pixels of ", CV_MAT_CN(type), " x ",
                8 * CV_ELEM_SIZE1(type), " bits");
}

cv::Mat Decode(const fs::path& path, int type, cv::Size size) {
  const std::string bytes = ReadFileBytes(path);
  const std::string expected = Describe(type, size);
  if (path.extension() == ".png") {
    if (const auto damage = FindPngDamage(bytes)) ThrowError(path.string(), *damage, expected);
  }
  cv::Mat image;
  try {
    image = DecodeImage(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    ThrowError(path.string(), StrCat("one that OpenCV refuses (", error.err, ")"), expected);
  }
  if (image.empty()) ThrowError(path.string(), "an image that cannot be decoded", expected);
  if (image.type() != type || image.size() != size) {
    ThrowError(path.string(), Describe(image.type(), image.size()), expected);
  }
  return image;
}

}  // namespace

const std::string_view kObjectsHeader =
    "frame,id,name,category,x,y,z,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz,length_m,width_m,height_m,"
    "visible_px,alone_px,visible_fraction,truncation,visible_left,visible_top,visible_right,"
    "visible_bottom,amodal_left,amodal_top,amodal_right,amodal_bottom";
std::vector<std::vector<SceneBody>> ReadSceneBodies(const std::filesystem::path& path,
                                                    int frame_count) {
  const CsvFile file(path, kObjectsHeader);
  const std::size_t frames = static_cast<std::size_t>(frame_count);
  if (frames == 0 || file.rows() % frames != 0) {
    ThrowError(path.string(), StrCat(file.rows(), " rows"),
               StrCat("as many for each of ", frame_count, " frames"));
  }
  const std::size_t bodies = file.rows() / frames;
  std::vector<std::vector<SceneBody>> truth(frames);
  for (std::size_t row = 0; row < file.rows(); ++row) {
    const int frame = static_cast<int>(row / bodies);
    const int id = static_cast<int>(row % bodies) + 1;
    SceneBody body = ReadBody(file, row);
    if (file.Integer(row, 0) != frame || body.id != id) {
      file.Fail(row, StrCat("frame ", file.Integer(row, 0), ", body ", body.id),
                StrCat("frame ", frame, ", body ", id, ": all bodies of a frame, then the next"));
    }
    if (frame > 0) CheckSame(file, row, body, truth[0][static_cast<std::size_t>(id) - 1]);
    truth[static_cast<std::size_t>(frame)].push_back(std::move(body));
  }
  return truth;
}

cv::Mat ReadDepth(const fs::path& path, cv::Size size) {
  cv::Mat depth = Decode(path, CV_32FC1, size);
  for (int v = 0; v < depth.rows; ++v) {
    const float* row = depth.ptr<float>(v);
    for (int u = 0; u < depth.cols; ++u) {
      if (std::isfinite(row[u]) && row[u] >= 0.0F) continue;
      ThrowError(StrCat(path.string(), ": pixel ", u, ", ", v), StrCat(row[u]),
                 "a finite depth that is not negative");
    }
  }
  return depth;
}

cv::Mat ReadInstances(const fs::path& path, cv::Size size) { return Decode(path, CV_16UC1, size); }

RightCameraError ReadRightCameraError(const std::filesystem::path& manifest) {
  const Json json = ReadJson(manifest);
  if (!json.is_object() || !json.contains("rig_error")) return {};
  return FromJson<RightCameraError>(json.at("rig_error"), manifest.string() + ", rig_error");
}

}  // namespace cvo
