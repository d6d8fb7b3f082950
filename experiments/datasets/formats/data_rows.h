// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// Rows of numbers and names as found in public data sets, addressed by column. Columns are
// separated by commas or blanks, and every row has as many as the first. A first line whose first
// column is not a number, lines that begin with #, and blank lines are skipped. Throws Error with
// file and line.
class DataRows {
 public:
  DataRows(const std::filesystem::path& path, std::size_t least_columns, const std::string& what);
  DataRows(const DataRows&) = delete;  // cells are views into file_
  DataRows& operator=(const DataRows&) = delete;

  std::size_t size() const { return rows_.size(); }
  std::size_t columns() const { return columns_; }
  std::string_view Text(std::size_t row, std::size_t column) const;
  double Number(std::size_t row, std::size_t column) const;  // finite
  std::int64_t Integer(std::size_t row, std::size_t column) const;
  // Time in ns from a column of integer seconds and the following one of integer nanoseconds.
  std::int64_t SecondsAndNs(std::size_t row, std::size_t column) const;
  Eigen::Vector3d Vector(std::size_t row, std::size_t column) const;
  // In the order x y z w, or w x y z if `w_first`. The norm must be within 0.01 of 1.
  Eigen::Quaterniond Quaternion(std::size_t row, std::size_t column, bool w_first) const;
  RigidTransform Matrix(std::size_t row, std::size_t column) const;  // 12 numbers of [R t]
  [[noreturn]] void Fail(std::size_t row, const std::string& found,
                         const std::string& expected) const;

 private:
  struct Row {
    std::size_t line;
    std::vector<std::string_view> cells;
  };
  [[noreturn]] void FailCell(std::size_t row, std::size_t column, const char* expected) const;

  TextFile file_;
  std::vector<Row> rows_;
  std::size_t columns_ = 0;
};

// Checks that the times of rows increase. Throws Error naming the row if its time is not after
// `before_ns`, the time of the row before (empty for the first row).
void CheckLater(const DataRows& rows, std::size_t row, std::int64_t time_ns,
                std::optional<std::int64_t> before_ns, const std::string& of);

// Parses a time such as "2011-09-26 13:02:25.967790592", with exactly nine decimals, to ns since
// 1970 (the file does not state its time zone). Empty for text of any other form.
[[nodiscard]] std::optional<std::int64_t> ParseDateTimeNs(std::string_view text);

// Read one timestamp per line, strictly increasing. Throw Error with file and line.
std::vector<std::int64_t> ReadDateTimes(const std::filesystem::path& path);  // KITTI raw
struct ImageTimes {
  std::vector<std::int64_t> ns;
  std::string note;  // UnitNote
};
ImageTimes ReadTimes(const std::filesystem::path& path);  // in the first column, in ImageTimeUnit

// The unit (s, ms, us or ns) that makes 1 to 1000 frames per second of these times. Throws Error
// naming `where` if none does. The note says which; it is empty for s and ns.
TimeUnit ImageTimeUnit(const std::vector<std::string_view>& texts, const std::string& where);
std::string UnitNote(const TimeUnit& unit, const std::string& where);

// Returns the times of frames 0, 1, ... at a constant rate, for data without timestamps. KITTI's
// rate is 10 Hz.
std::vector<std::int64_t> NominalTimes(std::size_t frames, double rate_hz = 10.0);

// The part of a GPS/IMU packet that the devkit uses. Angles are as in the file: latitude and
// longitude in degrees; roll, pitch and yaw in radians.
struct OxtsPacket {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double altitude_m = 0.0;
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;
  Eigen::Vector3d velocity_m_s = Eigen::Vector3d::Zero();  // east, north, up
};

// Read one packet per file (KITTI raw) or one per line (KITTI tracking). Each must have 30 finite
// numbers; throw Error otherwise.
OxtsPacket ReadOxtsPacket(const std::filesystem::path& path);
std::vector<OxtsPacket> ReadOxtsPackets(const std::filesystem::path& path);

// Returns imu_0_from_imu_i, computed as by the devkit's convertOxtsToPose, with a Mercator
// projection whose scale is that of the first packet's latitude.
std::vector<RigidTransform> ImuPoses(const std::vector<OxtsPacket>& packets);

// The same with the positions integrated from the velocities, by the trapezoidal rule between the
// packets' times: what the unit measured beside its positions.
std::vector<RigidTransform> ImuPosesByVelocity(const std::vector<OxtsPacket>& packets,
                                               const std::vector<std::int64_t>& times_ns);

}  // namespace cvo
