// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/python/arrays.h"

#include <algorithm>

#include "core/base/error.h"

namespace cvo {
namespace {

namespace py = pybind11;

struct LandmarkRow {
  std::int64_t id, cluster;
  double u_px, v_px, u_right_px, x, y, z;
};

struct PoseRow {
  std::int64_t frame, timestamp_ns;
  bool tracked;
  double x, y, z, qx, qy, qz, qw, vx, vy, vz;
};

void CopyMatrix(const RigidTransform& pose, double* to) {
  const Eigen::Matrix4d transposed = pose.Matrix().transpose();
  std::copy(transposed.data(), transposed.data() + transposed.size(), to);
}

}  // namespace

void RegisterRows() {
  PYBIND11_NUMPY_DTYPE(LandmarkRow, id, cluster, u_px, v_px, u_right_px, x, y, z);
  PYBIND11_NUMPY_DTYPE(PoseRow, frame, timestamp_ns, tracked, x, y, z, qx, qy, qz, qw, vx, vy, vz);
}

cv::Mat GreyImage(const char* name, const GreyArray& array) {
  if (array.ndim() != 2) {
    ThrowError(StrCat(name, " image"), StrCat(array.ndim(), " dimensions"),
               "2, the rows and columns of a grey image");
  }
  return cv::Mat(static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)), CV_8UC1,
                 const_cast<std::uint8_t*>(array.data()));
}

py::array_t<double> ToArray(const Eigen::Vector3d& vector) {
  return py::array_t<double>(3, vector.data());
}

py::array_t<double> ToArray(const RigidTransform& pose) {
  py::array_t<double> array({4, 4});
  CopyMatrix(pose, array.mutable_data());
  return array;
}

py::array_t<double> ToArray(const std::vector<RigidTransform>& poses) {
  py::array_t<double> array(
      {static_cast<py::ssize_t>(poses.size()), py::ssize_t{4}, py::ssize_t{4}});
  for (std::size_t i = 0; i < poses.size(); ++i)
    CopyMatrix(poses[i], array.mutable_data() + 16 * i);
  return array;
}

py::array LandmarkRowsOf(const std::vector<LandmarkReport>& landmarks,
                         const std::vector<StereoFeature>& features) {
  py::array_t<LandmarkRow> rows(static_cast<py::ssize_t>(landmarks.size()));
  std::transform(
      landmarks.begin(), landmarks.end(), rows.mutable_data(), [&](const LandmarkReport& landmark) {
        const Eigen::Vector3d& z = features.at(landmark.feature).z_px;
        const Eigen::Vector3d& p = landmark.p_in_world;
        return LandmarkRow{
            landmark.id.value, landmark.cluster.value, z[0], z[1], z[2], p.x(), p.y(), p.z()};
      });
  return rows;
}

py::array PoseRowsOf(const std::vector<ClusterPose>& poses) {
  py::array_t<PoseRow> rows(static_cast<py::ssize_t>(poses.size()));
  std::transform(poses.begin(), poses.end(), rows.mutable_data(), [](const ClusterPose& pose) {
    const auto t = pose.world_from_object.translation();
    const auto q = pose.world_from_object.rotation();
    const Eigen::Vector3d& v = pose.velocity_m_s;
    return PoseRow{pose.frame,
                   pose.timestamp_ns,
                   pose.status == ClusterStatus::kTracked,
                   t.x(),
                   t.y(),
                   t.z(),
                   q.x(),
                   q.y(),
                   q.z(),
                   q.w(),
                   v.x(),
                   v.y(),
                   v.z()};
  });
  return rows;
}

}  // namespace cvo
