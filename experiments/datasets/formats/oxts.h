// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "core/geometry/rigid_transform.h"

namespace cvo {

// The part of a GPS/IMU packet that the devkit uses. Angles are as in the file: latitude and
// longitude in degrees; roll, pitch and yaw in radians.
struct OxtsPacket {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double altitude_m = 0.0;
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;
};

// Read one packet per file (KITTI raw) or one per line (KITTI tracking). Each must have 30 finite
// numbers; throw Error otherwise.
OxtsPacket ReadOxtsPacket(const std::filesystem::path& path);
std::vector<OxtsPacket> ReadOxtsPackets(const std::filesystem::path& path);

// Returns imu_0_from_imu_i, computed as by the devkit's convertOxtsToPose, with a Mercator
// projection whose scale is that of the first packet's latitude.
std::vector<RigidTransform> ImuPoses(const std::vector<OxtsPacket>& packets);

}  // namespace cvo
