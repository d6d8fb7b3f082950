// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/calibration/stereo_rig.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/base/error.h"
#include "core/files/sha256.h"
#include "core/files/text/number.h"

namespace cvo {

bool IsRectified(const StereoRig& rig) {
  const LensCamera& a = rig.left;
  const LensCamera& b = rig.right;
  // Far below what is visible in pixels. Products of poses read from text are never exact.
  constexpr double kRounding = 1e-9;
  const Eigen::Vector3d t = rig.right_from_left.translation();
  return a.lens == LensModel::kPinhole && b.lens == LensModel::kPinhole && a.fx == b.fx &&
         a.fy == b.fy && a.cx == b.cx && a.cy == b.cy && t.x() < 0.0 &&
         t.tail<2>().norm() < kRounding &&
         RotationAngle(rig.right_from_left.rotation()) < kRounding;
}

StereoCamera CameraOf(const StereoRig& rig, int width_px, int height_px) {
  const LensCamera& left = rig.left;
  return {left.fx,  left.fy,  left.cx, left.cy, -rig.right_from_left.translation().x(),
          width_px, height_px};
}

void CheckSize(const StereoRig& rig, int width_px, int height_px, const std::string& where) {
  if (rig.width_px == 0 || (rig.width_px == width_px && rig.height_px == height_px)) return;
  ThrowError(where, StrCat("a calibration of ", rig.width_px, "x", rig.height_px, " px"),
             StrCat(width_px, "x", height_px, " px, as the images"));
}

void CheckCamera(const StereoCamera& camera, const std::string& where) {
  constexpr double kUnlike = 2.0;  // pixels are nearly square
  if (std::max(camera.fx, camera.fy) > kUnlike * std::min(camera.fx, camera.fy)) {
    ThrowError(where, StrCat("fx ", camera.fx, ", fy ", camera.fy),
               "focal lengths within a factor of 2");
  }
  if (camera.cx < 0.0 || camera.cx >= camera.width_px || camera.cy < 0.0 ||
      camera.cy >= camera.height_px) {
    ThrowError(
        where, StrCat("cx ", camera.cx, ", cy ", camera.cy),
        StrCat("a centre within the images of ", camera.width_px, "x", camera.height_px, " px"));
  }
}

void CheckCameras(const StereoRig& rig, int width_px, int height_px, const std::string& where) {
  CheckSize(rig, width_px, height_px, where);
  CheckCamera(CameraOf(rig, width_px, height_px), where + ", left camera");
  StereoRig right = rig;
  right.left = rig.right;
  CheckCamera(CameraOf(right, width_px, height_px), where + ", right camera");
}

namespace {

cv::Mat MatrixOf(double fx, double fy, double cx, double cy) {
  return (cv::Mat_<double>(3, 3) << fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0);
}

// The camera matrix of a LensCamera or a StereoCamera.
template <typename Camera>
cv::Mat MatrixOf(const Camera& camera) {
  return MatrixOf(camera.fx, camera.fy, camera.cx, camera.cy);
}

cv::Mat CoefficientsOf(const LensCamera& camera) {
  // OpenCV takes four zeros for a lens without distortion.
  const std::vector<double> zeros(4, 0.0);
  return cv::Mat(camera.coefficients.empty() ? zeros : camera.coefficients, true);
}

Eigen::Matrix3d ToEigen(const cv::Mat& matrix) {
  Eigen::Matrix3d result;
  cv::cv2eigen(matrix, result);
  return result;
}

// One camera of a pair, with the rotation that rectifies it.
struct TurnedCamera {
  cv::Mat matrix;
  cv::Mat lens;
  cv::Mat turn;  // rectified_from_camera

  // Maps pixels to the rectified image with this focal length and principal point.
  std::vector<cv::Point2d> Move(const std::vector<cv::Point2d>& pixels, double f_px,
                                const cv::Point2d& center) const {
    // The number of iterations that was usual when the known rectifications were made. Iterating to
    // convergence makes the focal length of EuRoC's cameras 0.01 px larger.
    constexpr int kSteps = 5;
    const cv::Mat projection = MatrixOf(f_px, f_px, center.x, center.y);
    std::vector<cv::Point2d> moved;
    cv::undistortPoints(pixels, moved, matrix, lens, turn, projection,
                        cv::TermCriteria(cv::TermCriteria::COUNT, kSteps, 0.0));
    return moved;
  }

  // A focal length at which radial distortion keeps the corners inside the image.
  double FocalLength(const cv::Size& size) const {
    const double f_px = matrix.at<double>(1, 1);
    const double k1 = lens.at<double>(0);
    const double diagonal2 = static_cast<double>(size.width) * size.width +
                             static_cast<double>(size.height) * size.height;
    return k1 < 0.0 ? f_px * (1.0 + k1 * diagonal2 / (4.0 * f_px * f_px)) : f_px;
  }

  // The principal point that places the mean of the four corners at the middle of the image.
  cv::Point2d Center(const cv::Size& size, double f_px) const {
    const double right = size.width - 1.0;
    const double bottom = size.height - 1.0;
    cv::Point2d sum(0.0, 0.0);
    for (const cv::Point2d& corner :
         Move({{0.0, 0.0}, {right, 0.0}, {0.0, bottom}, {right, bottom}}, f_px, {0.0, 0.0})) {
      sum += corner;
    }
    return {0.5 * right - 0.25 * sum.x, 0.5 * bottom - 0.25 * sum.y};
  }

  // The factor by which the focal length must grow so that no pixel is taken from outside the
  // image.
  double Enlargement(const cv::Size& size, double f_px, const cv::Point2d& center) const {
    constexpr int kSteps = 8;  // along each side
    double growth = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
      const double u = static_cast<double>(size.width) * i / kSteps;
      const double v = static_cast<double>(size.height) * i / kSteps;
      const std::vector<cv::Point2d> border = Move({{0.0, v},
                                                    {static_cast<double>(size.width), v},
                                                    {u, 0.0},
                                                    {u, static_cast<double>(size.height)}},
                                                   f_px, center);
      growth = std::max({growth, center.x / (center.x - border[0].x),
                         (size.width - center.x) / (border[1].x - center.x),
                         center.y / (center.y - border[2].y),
                         (size.height - center.y) / (border[3].y - center.y)});
    }
    return growth;
  }
};

// Chooses one focal length and principal point for both cameras such that every pixel of the
// rectified images was seen by its camera.
void ChooseProjection(const TurnedCamera& left, const TurnedCamera& right, const cv::Size& size,
                      StereoCamera& camera) {
  const double f_px = std::min(left.FocalLength(size), right.FocalLength(size));
  const cv::Point2d center = 0.5 * (left.Center(size, f_px) + right.Center(size, f_px));
  camera.fx =
      f_px * std::max(left.Enlargement(size, f_px, center), right.Enlargement(size, f_px, center));
  camera.fy = camera.fx;
  camera.cx = center.x;
  camera.cy = center.y;
}

std::string IdentityOf(const StereoRig& rig) {
  std::string text;
  const auto add = [&text](double value) { text += FormatDouble(value) + " "; };
  for (const LensCamera& camera : {rig.left, rig.right}) {
    for (const double value : {camera.fx, camera.fy, camera.cx, camera.cy}) add(value);
    text += StrCat(static_cast<int>(camera.lens), " ");
    for (const double value : camera.coefficients) add(value);
  }
  for (int i = 0; i < 7; ++i) add(rig.right_from_left.data()[i]);
  return Sha256Hex(text);
}

}  // namespace

Rectification::Rectification(const StereoRig& rig, const cv::Size& size)
    : identity_(IdentityOf(rig)) {
  const bool fisheye = rig.left.lens == LensModel::kEquidistant;
  TurnedCamera left = {MatrixOf(rig.left), CoefficientsOf(rig.left), {}};
  TurnedCamera right = {MatrixOf(rig.right), CoefficientsOf(rig.right), {}};
  cv::Mat rotation;
  cv::Mat translation;
  cv::eigen2cv(rig.right_from_left.RotationMatrix(), rotation);
  cv::eigen2cv(Eigen::Vector3d(rig.right_from_left.translation()), translation);
  camera_.width_px = size.width;
  camera_.height_px = size.height;
  camera_.baseline_m = rig.right_from_left.translation().norm();
  try {
    cv::Mat left_projection, right_projection, depth;
    if (fisheye) {
      cv::fisheye::stereoRectify(left.matrix, left.lens, right.matrix, right.lens, size, rotation,
                                 translation, left.turn, right.turn, left_projection,
                                 right_projection, depth, cv::CALIB_ZERO_DISPARITY, size);
      const cv::Mat_<double> p = left_projection;
      camera_.fx = p(0, 0);
      camera_.fy = p(1, 1);
      camera_.cx = p(0, 2);
      camera_.cy = p(1, 2);
    } else {
      cv::stereoRectify(left.matrix, left.lens, right.matrix, right.lens, size, rotation,
                        translation, left.turn, right.turn, left_projection, right_projection,
                        depth);
      ChooseProjection(left, right, size, camera_);
    }
    const auto make_maps = [&](const TurnedCamera& camera, Maps& maps) {
      const cv::Mat projection = MatrixOf(camera_);
      if (fisheye) {
        cv::fisheye::initUndistortRectifyMap(camera.matrix, camera.lens, camera.turn, projection,
                                             size, CV_32FC1, maps.u, maps.v);
      } else {
        cv::initUndistortRectifyMap(camera.matrix, camera.lens, camera.turn, projection, size,
                                    CV_32FC1, maps.u, maps.v);
      }
    };
    make_maps(left, left_);
    make_maps(right, right_);
  } catch (const cv::Exception& error) {
    ThrowError("calibration", error.err, "one that can be rectified");
  }
  rectified_from_left_ = ToEigen(left.turn);
  rectified_from_right_ = ToEigen(right.turn);
  camera_.Check();
}

cv::Mat Rectification::Remap(const cv::Mat& image, const Maps& maps) {
  cv::Mat result;
  cv::remap(image, result, maps.u, maps.v, cv::INTER_LINEAR);
  return result;
}

}  // namespace cvo
