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
  constexpr double kMaxLatitude_deg = 85.0;  // the Mercator projection ends before the poles
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
    // Relative to the first position before any product, where the digits are.
    poses.emplace_back(rotation, MercatorPosition(packet, scale) - origin);
  }
  const RigidTransform first_from_world = poses[0].Inverse();
  for (RigidTransform& pose : poses) pose = first_from_world * pose;
  return poses;
}

std::optional<RigidTransform> InterpolatePose(const std::vector<std::int64_t>& times_ns,
                                              const std::vector<RigidTransform>& poses,
                                              std::int64_t time_ns) {
  Require(times_ns.size() == poses.size(), "InterpolatePose: needs one time per pose");
  if (times_ns.empty() || time_ns < times_ns.front() || time_ns > times_ns.back()) {
    return std::nullopt;
  }
  const auto after = std::lower_bound(times_ns.begin(), times_ns.end(), time_ns);
  const auto b = static_cast<std::size_t>(after - times_ns.begin());
  if (times_ns[b] == time_ns) return poses[b];
  const std::size_t a = b - 1;
  const double s =
      static_cast<double>(time_ns - times_ns[a]) / static_cast<double>(times_ns[b] - times_ns[a]);
  return RigidTransform(poses[a].rotation().slerp(s, poses[b].rotation()),
                        (1.0 - s) * poses[a].translation() + s * poses[b].translation());
}

}  // namespace cvo
