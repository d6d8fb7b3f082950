// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/calibration/rig_file.h"

#include <Eigen/LU>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/files/json/json_record.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/calibration/kitti_calibration.h"

namespace cvo {

namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostBytes = 1 << 20;
constexpr std::size_t kMostValues = 1000;  // in one list, which aliases could make endless

YAML::Node Parse(const std::filesystem::path& path) {
  std::string text = ReadFileBytes(path);
  if (text.size() > kMostBytes) {
    ThrowError(path.string(), StrCat(text.size(), " bytes"), "a calibration below 1 MB");
  }
  if (text.starts_with("%YAML:")) text.erase(0, text.find('\n'));
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    ThrowError(StrCat(path.string(), ":", error.mark.line + 1), error.msg, "YAML or JSON");
  }
}

// Appends the scalars of a node. Returns false if there are too many values.
bool Collect(const YAML::Node& node, std::size_t& values, std::vector<std::string>& scalars) {
  if (++values > kMostValues) return false;
  if (node.IsScalar()) scalars.push_back(node.Scalar());
  if (!node.IsSequence()) return true;
  return std::all_of(node.begin(), node.end(),
                     [&](const YAML::Node& part) { return Collect(part, values, scalars); });
}

void SetLens(const YamlMap& map, const std::string& key, LensModel lens, LensCamera& camera) {
  camera.lens = lens;
  camera.coefficients = map.Numbers(key);
  const std::size_t count = camera.coefficients.size();
  const bool fits = lens == LensModel::kPinhole    ? count == 0
                    : lens == LensModel::kPlumbBob ? count == 4 || count == 5 || count == 8
                                                   : count == 4;
  if (!fits) {
    map.Fail(
        key, StrCat(count, " coefficients"),
        lens == LensModel::kEquidistant ? "4: k1 k2 k3 k4" : "4, 5 or 8: k1 k2 p1 p2 [k3 ...]");
  }
  const bool none = std::all_of(camera.coefficients.begin(), camera.coefficients.end(),
                                [](double k) { return k == 0.0; });
  if (none && lens == LensModel::kPlumbBob) camera.lens = LensModel::kPinhole;
}

void SetIntrinsics(double fx, double fy, double cx, double cy, LensCamera& camera) {
  camera.fx = fx;
  camera.fy = fy;
  camera.cx = cx;
  camera.cy = cy;
}

// The size of the images, if the calibration states it.
void SetSize(const YamlMap& map, const char* width, const char* height, StereoRig& rig) {
  if (map.Has(width)) rig.width_px = static_cast<int>(map.Number(width));
  if (map.Has(height)) rig.height_px = static_cast<int>(map.Number(height));
}

// Our own format.

LensCamera OurCamera(const YamlMap& map) {
  map.AllowOnly({"fx", "fy", "cx", "cy", "lens", "coefficients"});
  LensCamera camera;
  SetIntrinsics(map.Number("fx"), map.Number("fy"), map.Number("cx"), map.Number("cy"), camera);
  if (!map.Has("lens")) return camera;
  const std::optional<LensModel> lens = EnumOf<LensModel>(map.Text("lens"));
  if (!lens) map.Fail("lens", Quoted(map.Text("lens")), "none, plumb_bob or equidistant");
  if (*lens != LensModel::kPinhole) SetLens(map, "coefficients", *lens, camera);
  return camera;
}

StereoRig ReadOurs(const YamlMap& map) {
  StereoRig rig;
  if (map.Has("left")) {
    map.AllowOnly({"left", "right", "right_from_left", "width_px", "height_px"});
    rig.left = OurCamera(map.Map("left"));
    rig.right = OurCamera(map.Map("right"));
    rig.right_from_left = ReadTransform(map, "right_from_left");
  } else {
    map.AllowOnly({"fx", "fy", "cx", "cy", "baseline_m", "width_px", "height_px"});
    SetIntrinsics(map.Number("fx"), map.Number("fy"), map.Number("cx"), map.Number("cy"), rig.left);
    rig.right = rig.left;
    const double baseline_m = map.Number("baseline_m");
    if (!(baseline_m > 0.0)) map.Fail("baseline_m", StrCat(baseline_m), "a positive number");
    rig.right_from_left = RigidTransform(Eigen::Matrix3d::Identity(), {-baseline_m, 0.0, 0.0});
  }
  SetSize(map, "width_px", "height_px", rig);
  return rig;
}

// Kalibr's and EuRoC's formats, which name the radial model and the coefficients differently.

LensCamera PinholeCamera(const YamlMap& map, const char* radial, const char* coefficients) {
  LensCamera camera;
  const std::vector<double> k = map.Numbers("intrinsics");
  const std::string model = map.Text("camera_model");
  if (model != "pinhole") map.Fail("camera_model", Quoted(model), "pinhole");
  if (k.size() != 4) map.Fail("intrinsics", StrCat(k.size(), " numbers"), "4: fu fv cu cv");
  SetIntrinsics(k[0], k[1], k[2], k[3], camera);
  const std::string lens = map.Text("distortion_model");
  if (lens == "none") return camera;
  if (lens != radial && lens != "equidistant") {
    map.Fail("distortion_model", Quoted(lens), StrCat(radial, ", equidistant or none"));
  }
  SetLens(map, coefficients, lens == radial ? LensModel::kPlumbBob : LensModel::kEquidistant,
          camera);
  return camera;
}

StereoRig ReadPinholes(const YamlMap& left, const YamlMap& right, const char* radial,
                       const char* coefficients, const RigidTransform& right_from_left) {
  StereoRig rig = {PinholeCamera(left, radial, coefficients),
                   PinholeCamera(right, radial, coefficients), right_from_left};
  const std::vector<double> size = left.Numbers("resolution", 2);
  rig.width_px = static_cast<int>(size[0]);
  rig.height_px = static_cast<int>(size[1]);
  return rig;
}

bool Says(const std::string& text, const char* side) {
  std::string low = text;
  std::transform(low.begin(), low.end(), low.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return low.find(side) != std::string::npos;
}

void CheckTopic(const YamlMap& camera, const char* side, const char* other) {
  if (!camera.Has("rostopic")) return;
  const std::string topic = camera.Text("rostopic");
  if (Says(topic, side) || !Says(topic, other)) return;
  camera.Fail("rostopic", Quoted(topic),
              StrCat("the ", side, " camera: state the order of cameras"));
}

StereoRig ReadKalibr(const YamlMap& map, const std::string& left_key,
                     const std::string& right_key) {
  const YamlMap left = map.Map(left_key);
  const YamlMap right = map.Map(right_key);
  CheckTopic(left, "left", "right");
  CheckTopic(right, "right", "left");
  return ReadPinholes(left, right, "radtan", "distortion_coeffs",
                      ReadTransform(right, "T_cn_cnm1"));
}

// OpenCV's format.

struct OpenCvKeys {
  const char* matrix;
  const char* distortion;
};
constexpr std::array<OpenCvKeys, 3> kOpenCvKeys = {
    {{"K", "D"}, {"M", "D"}, {"cameraMatrix", "distCoeffs"}}};

LensCamera OpenCvCamera(const YamlMap& map, const OpenCvKeys& keys, const char* number) {
  const std::vector<double> k = map.Numbers(std::string(keys.matrix) + number, 9);
  LensCamera camera;
  SetIntrinsics(k[0], k[4], k[2], k[5], camera);
  SetLens(map, std::string(keys.distortion) + number, LensModel::kPlumbBob, camera);
  return camera;
}

StereoRig ReadOpenCv(const YamlMap& map, const OpenCvKeys& keys) {
  const std::vector<double> r = map.Numbers("R", 9);
  const std::vector<double> t = map.Numbers("T", 3);
  const Eigen::Matrix3d rotation =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(r.data());
  StereoRig rig = {OpenCvCamera(map, keys, "1"), OpenCvCamera(map, keys, "2"),
                   RigidTransform(NearestRotation(rotation), {t[0], t[1], t[2]})};
  SetSize(map, "image_width", "image_height", rig);
  return rig;
}

// KITTI's format.

bool IsKittiText(const fs::path& path) {
  const TextFile file(path);
  for (std::size_t i = 0; i < file.size(); ++i) {
    const std::string& line = file.line(i);
    if (line.starts_with("P_rect_00") || line.starts_with("P0:") || line.starts_with("P0 ")) {
      return true;
    }
  }
  return false;
}

StereoRig ReadKitti(const fs::path& path) {
  const CalibrationFile file(path);
  const bool raw = file.Has("P_rect_00");
  const bool grey = file.Has(raw ? "P_rect_01" : "P1");
  const CameraRig cameras(file, raw ? "P_rect_0" : "P");
  constexpr int kAnySize_px = 1;
  const StereoCamera pair = cameras.Stereo(grey ? 0 : 2, grey ? 1 : 3, kAnySize_px, kAnySize_px);
  StereoRig rig;
  SetIntrinsics(pair.fx, pair.fy, pair.cx, pair.cy, rig.left);
  rig.right = rig.left;
  rig.right_from_left = RigidTransform(Eigen::Matrix3d::Identity(), {-pair.baseline_m, 0.0, 0.0});
  return rig;
}

StereoRig ReadAny(const fs::path& path) {
  if (IsKittiText(path)) return ReadKitti(path);
  const YamlMap map = YamlMap::Read(path);
  if (map.Has("cam0")) return ReadKalibr(map, "cam0", "cam1");
  for (const OpenCvKeys& keys : kOpenCvKeys) {
    if (map.Has(std::string(keys.matrix) + "1")) return ReadOpenCv(map, keys);
  }
  return ReadOurs(map);
}

void Check(const fs::path& path, const char* name, const LensCamera& camera) {
  if (!(camera.fx > 0.0) || !(camera.fy > 0.0)) {
    ThrowError(StrCat(path.string(), ", ", name),
               StrCat("focal lengths ", camera.fx, ", ", camera.fy), "positive numbers of pixels");
  }
}

StereoRig Checked(const StereoRig& rig, const fs::path& path) {
  Check(path, "left camera", rig.left);
  Check(path, "right camera", rig.right);
  if ((rig.left.lens == LensModel::kEquidistant) != (rig.right.lens == LensModel::kEquidistant)) {
    ThrowError(path.string(), "one equidistant lens", "two, or none");
  }
  const Eigen::Vector3d& t = rig.right_from_left.translation();
  if (!(t.x() < 0.0) || std::abs(t.x()) < t.tail<2>().norm()) {
    ThrowError(path.string(), StrCat("the right camera at ", -t.x(), " m to the right of the left"),
               "a positive baseline along x (left and right may be swapped)");
  }
  return rig;
}

}  // namespace

YamlMap YamlMap::Read(const std::filesystem::path& path) {
  YAML::Node root = Parse(path);
  if (!root.IsMap()) ThrowError(path.string(), "no keys", "a calibration with keys and values");
  return {path.string(), std::move(root)};
}

void YamlMap::Fail(const std::string& key, const std::string& found,
                   const std::string& expected) const {
  ThrowError(where_ + ", " + key, found, expected);
}

YAML::Node YamlMap::Get(const std::string& key) const {
  const YAML::Node node = node_[key];
  if (!node) Fail(key, "nothing", "a value");
  return node;
}

YamlMap YamlMap::Map(const std::string& key) const {
  YAML::Node node = Get(key);
  if (!node.IsMap()) Fail(key, "no keys", "keys and values");
  return {where_ + ", " + key, std::move(node)};
}

double YamlMap::Number(const std::string& key) const { return Numbers(key, 1).front(); }

std::string YamlMap::Text(const std::string& key) const {
  const YAML::Node node = Get(key);
  if (!node.IsScalar()) Fail(key, "a list or map", "a text");
  return node.Scalar();
}

std::vector<double> YamlMap::Numbers(const std::string& key) const {
  YAML::Node node = Get(key);
  if (node.IsMap()) {
    const YAML::Node data = node["data"];
    if (!data) Fail(key, "keys without data", "a list of numbers, or a matrix with data");
    node.reset(data);
  }
  std::vector<std::string> scalars;
  std::size_t values = 0;
  if (!Collect(node, values, scalars)) {
    Fail(key, StrCat("more than ", kMostValues, " values"), "a list of numbers");
  }
  std::vector<double> numbers;
  for (const std::string& scalar : scalars) {
    const std::optional<double> number = ParseDouble(scalar);
    if (!number) Fail(key, Quoted(scalar), "a number");
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<double> YamlMap::Numbers(const std::string& key, std::size_t count) const {
  std::vector<double> numbers = Numbers(key);
  if (numbers.size() != count) {
    Fail(key, StrCat(numbers.size(), " numbers"), std::to_string(count));
  }
  return numbers;
}

void YamlMap::AllowOnly(const std::vector<std::string>& keys) const {
  for (const auto& entry : node_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      ThrowError(where_, "key " + Quoted(key) + DidYouMean(key, keys), "a key of a calibration");
    }
  }
}

// Reads a rigid transform from 12 or 16 numbers, row by row. Takes the nearest rotation, because
// calibrations are written with few digits.
RigidTransform ReadTransform(const YamlMap& map, const std::string& key) {
  const std::vector<double> numbers = map.Numbers(key);
  if (numbers.size() != 12 && numbers.size() != 16) {
    map.Fail(key, StrCat(numbers.size(), " numbers"), "12 of [R t], or 16");
  }
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rotation(i, j) = numbers[static_cast<std::size_t>(4 * i + j)];
    translation[i] = numbers[static_cast<std::size_t>(4 * i + 3)];
  }
  constexpr double kRounding = 1e-3;
  if ((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() > kRounding ||
      rotation.determinant() < 0.0) {
    map.Fail(key, "no rotation", "[R t] with R^T R = I and determinant 1");
  }
  return RigidTransform(NearestRotation(rotation), translation);
}

StereoRig ReadStereoRig(const fs::path& path) { return Checked(ReadAny(path), path); }

StereoRig ReadKalibrRig(const fs::path& path, const std::string& left, const std::string& right) {
  const YamlMap map = YamlMap::Read(path);
  std::string after = left;
  if (!after.empty()) ++after.back();
  if (right != after) {
    ThrowError(path.string(), StrCat("cameras ", left, " and ", right),
               StrCat(left, " and ", after, ": a chain states each camera by the one before"));
  }
  return Checked(ReadKalibr(map, left, right), path);
}

StereoRig ReadSensorRig(const fs::path& left, const fs::path& right) {
  const YamlMap left_map = YamlMap::Read(left);
  const YamlMap right_map = YamlMap::Read(right);
  const StereoRig rig =
      ReadPinholes(left_map, right_map, "radial-tangential", "distortion_coefficients",
                   ReadTransform(right_map, "T_BS").Inverse() * ReadTransform(left_map, "T_BS"));
  return Checked(rig, right);
}

}  // namespace cvo
