// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/diversity/diversity.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/files/images/image_codec.h"
#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "synth/truth/labels.h"
#include "synth/truth/object_table.h"

namespace cvo::synth {
namespace {

namespace fs = std::filesystem;

constexpr double kSeenFraction = 0.1;
constexpr double kMoving_mps = 0.01;

struct Folder {
  fs::path path;
  std::vector<double> times_s;
  std::vector<RigidTransform> left_from_world;
  ObjectTable objects;
  double focal_baseline_px_m = 0.0;
  double image_px = 0.0;
};

RigidTransform ReadPose(const TextFile& file, std::size_t row) {
  const TextRow numbers(file, row);
  numbers.ExpectColumns(12, "a pose");
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      rotation(i, k) = numbers.Number(static_cast<std::size_t>(4 * i + k));
    translation[i] = numbers.Number(static_cast<std::size_t>(4 * i + 3));
  }
  return {Eigen::Quaterniond(rotation), translation};
}

Folder ReadFolder(const fs::path& path) {
  Folder folder;
  folder.path = path;
  const TextFile times(path / "times.txt");
  const TextFile poses(path / "poses.txt");
  if (times.size() != poses.size() || times.size() < 2) {
    ThrowError(path.string(), StrCat(times.size(), " times, ", poses.size(), " poses"),
               "as many, of at least two frames");
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    folder.times_s.push_back(TextRow(times, i).Number(0));
    folder.left_from_world.push_back(ReadPose(poses, i).Inverse());
  }
  folder.objects = ReadObjectTable(path / "objects.csv", folder.times_s);
  const Json scene = ReadJson(path / "scene.json");
  const Json rig = scene.value("rig", Json::object());
  folder.focal_baseline_px_m = rig.value("focal_px", 0.0) * rig.value("baseline_m", 0.0);
  folder.image_px = rig.value("width_px", 0.0) * rig.value("height_px", 0.0);
  if (!(folder.image_px > 0.0)) {
    ThrowError((path / "scene.json").string(), "no image size", "rig.width_px and rig.height_px");
  }
  return folder;
}

// Standard deviation of the grey levels on a body in one frame. Throws Error if the image or the
// mask is missing.
double ContrastOf(const Folder& folder, int frame, int body) {
  const std::string name = SixDigits(frame) + ".png";
  const cv::Mat image = ReadImageFile(folder.path / "image_0" / name, cv::IMREAD_GRAYSCALE);
  const cv::Mat ids = ReadImageFile(folder.path / "instance_0" / name, cv::IMREAD_UNCHANGED);
  if (image.empty() || ids.size() != image.size()) {
    ThrowError((folder.path / "image_0" / name).string(), "no image or no mask", "both");
  }
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(image, mean, deviation, ids == body);
  return deviation[0];
}

void AddBody(const Folder& folder, std::size_t body, Diversity& diversity) {
  const double step_s = (folder.times_s.back() - folder.times_s.front()) /
                        static_cast<double>(folder.times_s.size() - 1);
  std::vector<double> heights;
  std::vector<double> disparities;
  double speed_sum = 0.0;
  double hidden_s = 0.0;
  int most_px = 0;
  int best_frame = 0;
  for (std::size_t i = 0; i < folder.objects.frames.size(); ++i) {
    const BodyTruth& truth = folder.objects.frames[i].bodies[body];
    speed_sum += truth.state.velocity_in_world.norm();
    const bool seen = truth.visible_box && truth.visible_fraction >= kSeenFraction;
    if (truth.amodal_box && !seen) hidden_s += step_s;
    if (!truth.amodal_box || seen) {
      if (hidden_s > 0.0) diversity.hidden_s.push_back(hidden_s);
      hidden_s = 0.0;
    }
    if (!seen) continue;
    heights.push_back(truth.visible_box->bottom - truth.visible_box->top + 1.0);
    const Eigen::Vector3d middle =
        folder.left_from_world[i] * truth.state.world_from_body.translation();
    if (middle.z() > 0.0) disparities.push_back(folder.focal_baseline_px_m / middle.z());
    if (truth.visible_px > most_px) {
      most_px = truth.visible_px;
      best_frame = static_cast<int>(i);
    }
  }
  if (hidden_s > 0.0) diversity.hidden_s.push_back(hidden_s);
  if (heights.empty() || disparities.empty()) return;
  const double speed = speed_sum / static_cast<double>(folder.objects.frames.size());
  if (speed > kMoving_mps) diversity.speed_mps.push_back(speed);
  diversity.visible_s.push_back(static_cast<double>(heights.size()) * step_s);
  diversity.size_px.push_back(Quantile(heights, 0.5));
  diversity.disparity_px.push_back(Quantile(disparities, 0.5));
  diversity.contrast.push_back(ContrastOf(folder, best_frame, static_cast<int>(body) + 1));
}

double MovingPart(const FrameTruth& frame, double image_px) {
  double moving_px = 0.0;
  for (const BodyTruth& body : frame.bodies) {
    if (body.state.velocity_in_world.norm() > kMoving_mps) moving_px += body.visible_px;
  }
  return moving_px / image_px;
}

}  // namespace

double Quantile(std::vector<double> values, double part) {
  Require(!values.empty(), "a quantile is of at least one value");
  std::sort(values.begin(), values.end());
  const double at = part * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

void AddSequence(const fs::path& folder, Diversity& diversity) {
  const Folder read = ReadFolder(folder);
  ++diversity.scenes;
  for (std::size_t body = 0; body < read.objects.names.size(); ++body) {
    AddBody(read, body, diversity);
  }
  for (const FrameTruth& frame : read.objects.frames) {
    diversity.moving_part.push_back(MovingPart(frame, read.image_px));
  }
}

}  // namespace cvo::synth
