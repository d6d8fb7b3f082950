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

void CheckBody(const SceneBody& body, const std::string& where) {
  if (body.name.empty() || body.category.empty()) {
    ThrowError(where, "an empty name or category", "text");
  }
  if (!(body.size_m.minCoeff() > 0.0)) {
    ThrowError(where, StrCat("a size of ", body.size_m.transpose(), " m"), "positive sizes");
  }
}

void CheckSame(const SceneBody& body, const SceneBody& first, const std::string& where) {
  if (body.name == first.name && body.category == first.category && body.size_m == first.size_m) {
    return;
  }
  ThrowError(where, StrCat(body.name, ", ", body.category, ", ", body.size_m.transpose()),
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

std::vector<std::vector<SceneBody>> ReadSceneBodies(const std::filesystem::path& path,
                                                    int frame_count) {
  std::vector<SceneBody> rows;
  ReadCsv<SceneBody>(path, [&](SceneBody row, std::size_t) { rows.push_back(std::move(row)); });
  const std::size_t frames = static_cast<std::size_t>(frame_count);
  if (frames == 0 || rows.size() % frames != 0) {
    ThrowError(path.string(), StrCat(rows.size(), " rows"),
               StrCat("as many for each of ", frame_count, " frames"));
  }
  const std::size_t bodies = rows.size() / frames;
  std::vector<std::vector<SceneBody>> truth(frames);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string where = StrCat(path.string(), ":", i + 2);
    const auto frame = static_cast<int>(i / bodies);
    const auto id = static_cast<int>(i % bodies) + 1;
    SceneBody& body = rows[i];
    CheckBody(body, where);
    if (body.frame != frame || body.id != id) {
      ThrowError(where, StrCat("frame ", body.frame, ", body ", body.id),
                 StrCat("frame ", frame, ", body ", id, ": all bodies of a frame, then the next"));
    }
    if (frame > 0) CheckSame(body, truth[0][static_cast<std::size_t>(id) - 1], where);
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
