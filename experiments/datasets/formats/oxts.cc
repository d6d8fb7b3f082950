// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/formats/oxts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

constexpr std::size_t kColumns = 30;

OxtsPacket ReadPacket(const TextRow& row) {
  row.ExpectColumns(kColumns, "an OxTS packet");
  for (std::size_t i = 0; i < kColumns; ++i) row.Number(i);
  const OxtsPacket packet = {row.Number(0), row.Number(1), row.Number(2),
                             row.Number(3), row.Number(4), row.Number(5)};
  constexpr double kMaxLatitude_deg = 85.0;  // the Mercator projection diverges at the poles
  if (std::abs(packet.latitude_deg) > kMaxLatitude_deg || std::abs(packet.longitude_deg) > 180.0) {
    row.Fail(StrCat("latitude ", packet.latitude_deg, " and longitude ", packet.longitude_deg),
             "degrees within 85 and 180");
  }
  return packet;
}

Eigen::Vector3d MercatorPosition(const OxtsPacket& packet, double scale) {
  constexpr double kEarthRadius_m = 6378137.0;
  constexpr double kPi = std::numbers::pi;
  return {scale * packet.longitude_deg * kPi * kEarthRadius_m / 180.0,
          scale * kEarthRadius_m * std::log(std::tan((90.0 + packet.latitude_deg) * kPi / 360.0)),
          packet.altitude_m};
}

}  // namespace

OxtsPacket ReadOxtsPacket(const std::filesystem::path& path) {
  const TextFile file(path);
  if (file.size() != 1) ThrowError(path.string(), StrCat(file.size(), " lines"), "one OxTS packet");
  return ReadPacket(TextRow(file, 0));
}

std::vector<OxtsPacket> ReadOxtsPackets(const std::filesystem::path& path) {
  const TextFile file(path);
  std::vector<OxtsPacket> packets;
  for (std::size_t i = 0; i < file.size(); ++i) packets.push_back(ReadPacket(TextRow(file, i)));
  return packets;
}

std::vector<RigidTransform> ImuPoses(const std::vector<OxtsPacket>& packets) {
  std::vector<RigidTransform> poses;
  if (packets.empty()) return poses;
  const double scale = std::cos(packets[0].latitude_deg * std::numbers::pi / 180.0);
  const Eigen::Vector3d origin = MercatorPosition(packets[0], scale);
  for (const OxtsPacket& packet : packets) {
    const Eigen::Quaterniond rotation =
        Eigen::AngleAxisd(packet.yaw_rad, Eigen::Vector3d::UnitZ()) *
        Eigen::AngleAxisd(packet.pitch_rad, Eigen::Vector3d::UnitY()) *
        Eigen::AngleAxisd(packet.roll_rad, Eigen::Vector3d::UnitX());
    // The first position is subtracted before any product, so that its large coordinates cost no
    // digits.
    poses.emplace_back(rotation, MercatorPosition(packet, scale) - origin);
  }
  const RigidTransform first_from_world = poses[0].Inverse();
  for (RigidTransform& pose : poses) pose = first_from_world * pose;
  return poses;
}

}  // namespace cvo
