// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/interface/frame.h"

namespace cvo {

// uint8, row-major: other types are rejected, other layouts are copied.
using GreyArray = pybind11::array_t<std::uint8_t, pybind11::array::c_style>;

// Registers the row types of the arrays below with NumPy. Call it once per process.
void RegisterRows();

// Wraps the pixels of the array without copying them. Throws Error unless it has two dimensions.
cv::Mat GreyImage(const char* name, const GreyArray& array);

// Shape (3,).
pybind11::array_t<double> ToArray(const Eigen::Vector3d& vector);
// Shape (4, 4).
pybind11::array_t<double> ToArray(const RigidTransform& pose);
// Shape (N, 4, 4).
pybind11::array_t<double> ToArray(const std::vector<RigidTransform>& poses);

// One row per landmark with the columns of landmarks.csv that are known in a frame: id, u_px, v_px,
// u_right_px, cluster (0: static scene, -1: none), x, y, z.
pybind11::array LandmarkRowsOf(const std::vector<LandmarkReport>& landmarks,
                               const std::vector<StereoFeature>& features);

// One row per frame: frame, timestamp_ns, tracked, x, y, z, qx, qy, qz, qw, vx, vy, vz.
pybind11::array PoseRowsOf(const std::vector<ClusterPose>& poses);

}  // namespace cvo
