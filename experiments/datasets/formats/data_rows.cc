// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/formats/data_rows.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/calibration/kitti_calibration.h"

namespace cvo {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view Trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::vector<std::string_view> Cells(std::string_view line) {
  const bool commas = line.find(',') != std::string_view::npos;
  std::vector<std::string_view> cells;
  while (!line.empty()) {
    const std::size_t end = commas ? line.find(',') : line.find_first_of(kBlanks);
    cells.push_back(Trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) break;
    line.remove_prefix(end + 1);
    if (!commas) line = Trimmed(line);
  }
  return cells;
}

constexpr std::string_view kShape = "dddd-dd-dd dd:dd:dd.ddddddddd";

bool HasShape(std::string_view text) {
  return std::ranges::equal(text, kShape, [](char c, char shape) {
    return shape == 'd' ? c >= '0' && c <= '9' : c == shape;
  });
}

constexpr std::size_t kColumns = 30;

OxtsPacket ReadPacket(const TextRow& row) {
  row.ExpectColumns(kColumns, "an OxTS packet");
  for (std::size_t i = 0; i < kColumns; ++i) row.Number(i);
  const OxtsPacket packet = {row.Number(0),
                             row.Number(1),
                             row.Number(2),
                             row.Number(3),
                             row.Number(4),
                             row.Number(5),
                             {row.Number(7), row.Number(6), row.Number(10)}};
  constexpr double kMaxLatitude_deg = 85.0;  // the Mercator projection diverges at the poles
  if (std::abs(packet.latitude_deg) > kMaxLatitude_deg || std::abs(packet.longitude_deg) > 180.0) {
    row.Fail(StrCat("latitude ", packet.latitude_deg, " and longitude ", packet.longitude_deg),
             "degrees within 85 and 180");
  }
  for (const double angle_rad : {packet.roll_rad, packet.pitch_rad, packet.yaw_rad}) {
    if (std::abs(angle_rad) > 2.0 * std::numbers::pi) {
      row.Fail(StrCat("an angle of ", angle_rad), "roll, pitch and yaw in radians");
    }
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

// earth_from_imu, with axes east, north and up.
Eigen::Quaterniond Attitude(const OxtsPacket& packet) {
  return Eigen::AngleAxisd(packet.yaw_rad, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(packet.pitch_rad, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(packet.roll_rad, Eigen::Vector3d::UnitX());
}

}  // namespace

DataRows::DataRows(const std::filesystem::path& path, std::size_t least_columns,
                   const std::string& what)
    : file_(path) {
  bool first = true;
  for (std::size_t i = 0; i < file_.size(); ++i) {
    const std::string_view line = Trimmed(file_.line(i));
    if (line.empty() || line.starts_with('#')) continue;
    std::vector<std::string_view> cells = Cells(line);
    const bool header = first && !ParseDouble(cells.front());
    first = false;
    if (header) continue;
    if (rows_.empty()) columns_ = cells.size();
    if (cells.size() < least_columns || cells.size() != columns_) {
      ThrowError(file_.Where(i), StrCat(cells.size(), " columns"),
                 cells.size() < least_columns ? StrCat(least_columns, " or more: ", what)
                                              : StrCat(columns_, ", as in the first row"));
    }
    rows_.push_back({i, std::move(cells)});
  }
  if (rows_.empty()) ThrowError(path.string(), "no rows", what);
}

std::string_view DataRows::Text(std::size_t row, std::size_t column) const {
  return rows_.at(row).cells.at(column);
}

double DataRows::Number(std::size_t row, std::size_t column) const {
  const std::optional<double> number = ParseDouble(Text(row, column));
  if (!number) FailCell(row, column, "a number");
  return *number;
}

std::int64_t DataRows::Integer(std::size_t row, std::size_t column) const {
  const std::optional<std::int64_t> number = ParseInteger(Text(row, column));
  if (!number) FailCell(row, column, "a whole number");
  return *number;
}

std::int64_t DataRows::SecondsAndNs(std::size_t row, std::size_t column) const {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  const std::int64_t seconds = Integer(row, column);
  const std::int64_t ns = Integer(row, column + 1);
  if (seconds < 0 || seconds > 9'000'000'000) FailCell(row, column, "seconds");
  if (ns < 0 || ns >= kSecond_ns) FailCell(row, column + 1, "nanoseconds below one second");
  return seconds * kSecond_ns + ns;
}

Eigen::Vector3d DataRows::Vector(std::size_t row, std::size_t column) const {
  return {Number(row, column), Number(row, column + 1), Number(row, column + 2)};
}

Eigen::Quaterniond DataRows::Quaternion(std::size_t row, std::size_t column, bool w_first) const {
  constexpr double kTolerance = 1e-2;
  const std::size_t vector = w_first ? column + 1 : column;
  const Eigen::Vector3d xyz = Vector(row, vector);
  const Eigen::Quaterniond rotation(Number(row, w_first ? column : column + 3), xyz.x(), xyz.y(),
                                    xyz.z());
  if (std::abs(rotation.norm() - 1.0) > kTolerance) {
    Fail(row, StrCat("a quaternion of length ", rotation.norm()), "one of length 1");
  }
  return rotation.normalized();
}

RigidTransform DataRows::Matrix(std::size_t row, std::size_t column) const {
  constexpr double kTolerance = 1e-2;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < 12; ++i) numbers.push_back(Number(row, column + i));
  return TransformFromRow(numbers, file_.Where(rows_.at(row).line), kTolerance);
}

void DataRows::Fail(std::size_t row, const std::string& found, const std::string& expected) const {
  ThrowError(file_.Where(rows_.at(row).line), found, expected);
}

void DataRows::FailCell(std::size_t row, std::size_t column, const char* expected) const {
  ThrowError(StrCat(file_.Where(rows_.at(row).line), ", column ", column + 1),
             Quoted(Text(row, column)), expected);
}

void CheckLater(const DataRows& rows, std::size_t row, std::int64_t time_ns,
                std::optional<std::int64_t> before_ns, const std::string& of) {
  if (!before_ns || time_ns > *before_ns) return;
  rows.Fail(row, StrCat("time ", FormatSecondsNs(time_ns), " s of ", of),
            StrCat("one after ", FormatSecondsNs(*before_ns), " s, that of the row before"));
}

std::optional<std::int64_t> ParseDateTimeNs(std::string_view text) {
  if (!HasShape(text)) return std::nullopt;
  const auto number = [&](std::size_t begin, std::size_t count) {
    return *ParseInteger(text.substr(begin, count));
  };
  const std::chrono::year_month_day date(std::chrono::year(static_cast<int>(number(0, 4))),
                                         std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                         std::chrono::day(static_cast<unsigned>(number(8, 2))));
  const std::int64_t hour = number(11, 2), minute = number(14, 2), second = number(17, 2);
  // An int64 in ns covers the years 1678 to 2261.
  if (!date.ok() || hour > 23 || minute > 59 || second > 59 || number(0, 4) < 1678 ||
      number(0, 4) > 2261) {
    return std::nullopt;
  }
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  return (((days * 24 + hour) * 60 + minute) * 60 + second) * 1'000'000'000 + number(20, 9);
}

std::vector<std::int64_t> ReadDateTimes(const std::filesystem::path& path) {
  const TextFile file(path);
  std::vector<std::int64_t> times;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const std::optional<std::int64_t> time = ParseDateTimeNs(Trimmed(file.line(i)));
    if (!time) {
      ThrowError(file.Where(i), Quoted(file.line(i)), "a time YYYY-MM-DD HH:MM:SS.nnnnnnnnn");
    }
    if (!times.empty() && *time <= times.back()) {
      ThrowError(file.Where(i), Quoted(file.line(i)),
                 "a time after that of the line before, " + Quoted(file.line(i - 1)));
    }
    times.push_back(*time);
  }
  return times;
}

TimeUnit ImageTimeUnit(const std::vector<std::string_view>& texts, const std::string& where) {
  constexpr double kLongestStep_s = 1.0;
  constexpr double kShortestStep_s = 0.001;
  const TimeUnit unit = TimeUnitOf(texts, kLongestStep_s);
  if (texts.size() > 1 && !(unit.step_s >= kShortestStep_s && unit.step_s <= kLongestStep_s)) {
    ThrowError(where, StrCat("times like ", Quoted(texts[0]), " and ", Quoted(texts[1])),
               "times in s, ms, us or ns that make 1 to 1000 frames per second");
  }
  return unit;
}

std::string UnitNote(const TimeUnit& unit, const std::string& where) {
  if (unit.ns == 1 || unit.ns == 1'000'000'000) return "";
  return StrCat(where, ": times taken for ", unit.name, ", which makes ",
                FormatGeneral(1.0 / unit.step_s, 4), " Hz");
}

ImageTimes ReadTimes(const std::filesystem::path& path) {
  const DataRows rows(path, 1, "a time per row");
  std::vector<std::string_view> texts;
  for (std::size_t i = 0; i < rows.size(); ++i) texts.push_back(rows.Text(i, 0));
  const TimeUnit unit = ImageTimeUnit(texts, path.string());
  ImageTimes times{{}, UnitNote(unit, path.string())};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto time_ns = ParseTimeNs(texts[i], unit.ns);
    if (!time_ns) rows.Fail(i, Quoted(texts[i]), "a time");
    CheckLater(rows, i, *time_ns, i > 0 ? std::optional(times.ns.back()) : std::nullopt, "images");
    times.ns.push_back(*time_ns);
  }
  return times;
}

std::vector<std::int64_t> NominalTimes(std::size_t frames, double rate_hz) {
  std::vector<std::int64_t> times;
  for (std::size_t i = 0; i < frames; ++i) {
    times.push_back(std::llround(1e9 * static_cast<double>(i) / rate_hz));
  }
  return times;
}

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
    // The first position is subtracted before any product, so that its large coordinates cost no
    // digits.
    poses.emplace_back(Attitude(packet), MercatorPosition(packet, scale) - origin);
  }
  const RigidTransform first_from_world = poses[0].Inverse();
  for (RigidTransform& pose : poses) pose = first_from_world * pose;
  return poses;
}

std::vector<RigidTransform> ImuPosesByVelocity(const std::vector<OxtsPacket>& packets,
                                               const std::vector<std::int64_t>& times_ns) {
  std::vector<RigidTransform> poses = ImuPoses(packets);
  Eigen::Vector3d moved_m = Eigen::Vector3d::Zero();  // east, north, up
  for (std::size_t i = 1; i < poses.size(); ++i) {
    moved_m += 0.5e-9 * static_cast<double>(times_ns[i] - times_ns[i - 1]) *
               (packets[i - 1].velocity_m_s + packets[i].velocity_m_s);
    poses[i] = RigidTransform(poses[i].rotation(), Attitude(packets[0]).conjugate() * moved_m);
  }
  return poses;
}

}  // namespace cvo
