// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/calibration/rig_file.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "core/files/json/json_record.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/calibration/kitti_calibration.h"

namespace cvo {

namespace fs = std::filesystem;
namespace {

void SetLens(const YamlMap& map, const std::string& key, LensModel lens, LensCamera& camera) {
  camera.lens = lens;
  camera.coefficients = map.Numbers(key);
  const std::size_t count = camera.coefficients.size();
  const bool fits = lens == LensModel::kPinhole ? count == 0
                    : lens == LensModel::kPlumbBob
                        ? count == 4 || count == 5 || count == 8 || count == 12 || count == 14
                        : count == 4;
  if (!fits) {
    map.Fail(key, StrCat(count, " coefficients"),
             lens == LensModel::kEquidistant ? "4: k1 k2 k3 k4"
                                             : "4, 5, 8, 12 or 14: k1 k2 p1 p2 [k3 ...]");
  }
  const bool none = std::ranges::all_of(camera.coefficients, [](double k) { return k == 0.0; });
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
    rig.right_from_left = map.Transform("right_from_left");
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

// Formats that name the model of the lens.

// Sets the lens by a model's name in Kalibr, EuRoC or ROS, and its coefficients.
void SetNamedLens(const YamlMap& map, const std::string& coefficients, LensCamera& camera) {
  constexpr std::array kRadial = {"radtan", "radial-tangential", "plumb_bob",
                                  "rational_polynomial"};
  const std::string lens = map.Text("distortion_model");
  if (lens == "none" || lens.empty()) return;
  const bool radial = std::find(kRadial.begin(), kRadial.end(), lens) != kRadial.end();
  if (!radial && lens != "equidistant") {
    map.Fail("distortion_model", Quoted(lens), "radtan, plumb_bob, equidistant or none");
  }
  SetLens(map, coefficients, radial ? LensModel::kPlumbBob : LensModel::kEquidistant, camera);
}

// Of Kalibr and EuRoC, which name the coefficients differently.
LensCamera PinholeCamera(const YamlMap& map) {
  LensCamera camera;
  const std::vector<double> k = map.Numbers("intrinsics");
  const std::string model = map.Text("camera_model");
  if (model != "pinhole") map.Fail("camera_model", Quoted(model), "pinhole");
  if (k.size() != 4) map.Fail("intrinsics", StrCat(k.size(), " numbers"), "4: fu fv cu cv");
  SetIntrinsics(k[0], k[1], k[2], k[3], camera);
  SetNamedLens(map, map.Has("distortion_coeffs") ? "distortion_coeffs" : "distortion_coefficients",
               camera);
  return camera;
}

StereoRig ReadPinholes(const YamlMap& left, const YamlMap& right,
                       const RigidTransform& right_from_left) {
  StereoRig rig = {PinholeCamera(left), PinholeCamera(right), right_from_left};
  const std::vector<double> size = left.Numbers("resolution", 2);
  rig.width_px = static_cast<int>(size[0]);
  rig.height_px = static_cast<int>(size[1]);
  return rig;
}

StereoRig ReadKalibr(const YamlMap& map, const std::string& left_key,
                     const std::string& right_key) {
  const YamlMap left = map.Map(left_key);
  const YamlMap right = map.Map(right_key);
  const auto both_have = [&](const char* key) { return left.Has(key) && right.Has(key); };
  const auto right_from_left = [&]() -> RigidTransform {
    if (right.Has("T_cn_cnm1")) return right.Transform("T_cn_cnm1");
    if (both_have("T_cam_imu")) {
      return right.Transform("T_cam_imu") * left.Transform("T_cam_imu").Inverse();
    }
    if (both_have("T_imu_cam")) {
      return right.Transform("T_imu_cam").Inverse() * left.Transform("T_imu_cam");
    }
    right.Fail("T_cn_cnm1", "nothing", "it, or T_cam_imu or T_imu_cam of both cameras");
  };
  return ReadPinholes(left, right, right_from_left());
}

// A camera with its own rectification, as ROS and the settings of ORB-SLAM2 state it:
// p_in_rectified = turn p_in_camera + offset_m, with the offset along x.
struct RectifiedCamera {
  LensCamera camera;
  Eigen::Matrix3d turn;
  Eigen::Vector3d offset_m;
};

RectifiedCamera ReadRectified(const YamlMap& map, const std::string& matrix,
                              const std::string& turn, const std::string& projection) {
  const std::vector<double> k = map.Numbers(matrix, 9);
  const std::vector<double> r = map.Numbers(turn, 9);
  const std::vector<double> p = map.Numbers(projection, 12);
  RectifiedCamera read;
  SetIntrinsics(k[0], k[4], k[2], k[5], read.camera);
  read.turn =
      NearestRotation(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(r.data()));
  if (!(p[0] > 0.0) || !(p[5] > 0.0)) map.Fail(projection, "no focal length", "a positive one");
  read.offset_m = {p[3] / p[0], p[7] / p[5], 0.0};
  return read;
}

RigidTransform RightFromLeft(const RectifiedCamera& left, const RectifiedCamera& right) {
  const Eigen::Matrix3d back = right.turn.transpose();
  return {Eigen::Matrix3d(back * left.turn),
          Eigen::Vector3d(back * (right.offset_m - left.offset_m))};
}

// camera_info of ROS: as a calibration file, and as a message of ROS 1 and ROS 2 is printed.
struct CameraInfoKeys {
  const char* matrix;
  const char* coefficients;
  const char* turn;
  const char* projection;
  const char* width;
  const char* height;
};
constexpr std::array<CameraInfoKeys, 3> kCameraInfoKeys = {
    {{"camera_matrix", "distortion_coefficients", "rectification_matrix", "projection_matrix",
      "image_width", "image_height"},
     {"K", "D", "R", "P", "width", "height"},
     {"k", "d", "r", "p", "width", "height"}}};

const CameraInfoKeys* FindCameraInfo(const YamlMap& map) {
  const auto found = std::ranges::find_if(kCameraInfoKeys, [&](const CameraInfoKeys& keys) {
    return map.Has(keys.matrix) && map.Has(keys.projection);
  });
  return found == kCameraInfoKeys.end() ? nullptr : &*found;
}

StereoRig ReadCameraInfos(const YamlMap& left_map, const YamlMap& right_map,
                          const CameraInfoKeys& keys) {
  const auto read = [&](const YamlMap& map) {
    RectifiedCamera camera = ReadRectified(map, keys.matrix, keys.turn, keys.projection);
    SetNamedLens(map, keys.coefficients, camera.camera);
    return camera;
  };
  const RectifiedCamera left = read(left_map);
  const RectifiedCamera right = read(right_map);
  StereoRig rig = {left.camera, right.camera, RightFromLeft(left, right)};
  SetSize(left_map, keys.width, keys.height, rig);
  return rig;
}

// Settings of ORB-SLAM2 and ORB-SLAM3.

LensCamera OrbSlamCamera(const YamlMap& map, const std::string& name) {
  LensCamera camera;
  SetIntrinsics(map.Number(name + ".fx"), map.Number(name + ".fy"), map.Number(name + ".cx"),
                map.Number(name + ".cy"), camera);
  const bool fisheye = map.Has("Camera.type") && map.Text("Camera.type") == "KannalaBrandt8";
  const std::vector<const char*> keys = fisheye ? std::vector{".k1", ".k2", ".k3", ".k4"}
                                                : std::vector{".k1", ".k2", ".p1", ".p2", ".k3"};
  for (const char* key : keys) {
    if (map.Has(name + key)) camera.coefficients.push_back(map.Number(name + key));
  }
  const bool none = std::ranges::all_of(camera.coefficients, [](double k) { return k == 0.0; });
  if (fisheye || !none) camera.lens = fisheye ? LensModel::kEquidistant : LensModel::kPlumbBob;
  if (camera.lens != LensModel::kPinhole && camera.coefficients.size() < 4) {
    map.Fail(name + ".k1", StrCat(camera.coefficients.size(), " coefficients"), "4 or more");
  }
  return camera;
}

StereoRig ReadOrbSlam(const YamlMap& map) {
  StereoRig rig;
  if (map.Has("LEFT.K")) {
    const auto read = [&](const std::string& side) {
      RectifiedCamera camera = ReadRectified(map, side + ".K", side + ".R", side + ".P");
      SetLens(map, side + ".D", LensModel::kPlumbBob, camera.camera);
      return camera;
    };
    const RectifiedCamera left = read("LEFT");
    const RectifiedCamera right = read("RIGHT");
    rig = {left.camera, right.camera, RightFromLeft(left, right)};
    SetSize(map, "LEFT.width", "LEFT.height", rig);
    return rig;
  }
  rig.left = OrbSlamCamera(map, map.Has("Camera1.fx") ? "Camera1" : "Camera");
  SetSize(map, "Camera.width", "Camera.height", rig);
  if (map.Has("Camera2.fx")) {
    rig.right = OrbSlamCamera(map, "Camera2");
    rig.right_from_left = map.Transform(map.Has("Tlr") ? "Tlr" : "Stereo.T_c1_c2").Inverse();
    return rig;
  }
  rig.right = rig.left;
  const double baseline_m =
      map.Has("Stereo.b") ? map.Number("Stereo.b") : map.Number("Camera.bf") / rig.left.fx;
  rig.right_from_left = RigidTransform(Eigen::Matrix3d::Identity(), {-baseline_m, 0.0, 0.0});
  return rig;
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
  if (!map.Has("R") || !map.Has("T")) {
    map.Fail("R, T", "nothing", "both; of two files give both: --calib INTRINSICS EXTRINSICS");
  }
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

StereoRig ReadAny(const fs::path& path, const fs::path& second) {
  if (second.empty() && IsKittiText(path)) return ReadKitti(path);
  YamlMap map = YamlMap::Read(path);
  if (const CameraInfoKeys* keys = FindCameraInfo(map)) {
    if (!second.empty()) return ReadCameraInfos(map, YamlMap::Read(second), *keys);
    map.Fail(keys->matrix, "one camera alone", "both cameras: --calib LEFT RIGHT");
  }
  if (!second.empty()) map.Add(YamlMap::Read(second));
  if (map.Has("cam0")) return ReadKalibr(map, "cam0", "cam1");
  for (const OpenCvKeys& keys : kOpenCvKeys) {
    if (map.Has(std::string(keys.matrix) + "1")) return ReadOpenCv(map, keys);
  }
  if (map.Has("Camera.fx") || map.Has("Camera1.fx")) return ReadOrbSlam(map);
  if (map.Has("fx") || map.Has("left")) return ReadOurs(map);
  ThrowError(
      path.string(), "keys " + map.Keys(),
      "a calibration of ours (fx ... baseline_m), KITTI, Kalibr, OpenVINS, OpenCV (one or two "
      "files), ROS (camera_info of both cameras), ORB-SLAM2 or ORB-SLAM3");
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

StereoRig ReadStereoRig(const fs::path& path, const fs::path& second) {
  return Checked(ReadAny(path, second), path);
}

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
  const StereoRig rig = ReadPinholes(
      left_map, right_map, right_map.Transform("T_BS").Inverse() * left_map.Transform("T_BS"));
  return Checked(rig, right);
}

}  // namespace cvo
