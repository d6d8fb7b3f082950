// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/trajectory_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/calibration/kitti_calibration.h"

namespace cvo {

namespace {

constexpr std::size_t kRowNumbers = 12;  // numbers of a KITTI pose
constexpr std::size_t kPoseColumns = 8;  // of other files
constexpr const char* kBlanks = " \t";
constexpr const char* kBlanksAndCommas = " \t,";

// How the columns of a file are to be read.
struct Columns {
  const char* separators = kBlanks;
  bool w_first = false;
  std::size_t first_row = 0;  // index of the first line of data

  bool has_commas() const { return separators == kBlanksAndCommas; }
};

bool IsComment(const TextRow& row) { return row.size() == 0 || row.Text(0).starts_with('#'); }

// Whether a header names w before the other parts of the quaternion.
bool NamesWFirst(const std::string& header) {
  std::size_t at = 0;
  for (int i = 0; i < 4; ++i) at = header.find(',', at) + 1;
  const std::string name = header.substr(at, header.find(',', at) - at);
  return name.find_first_of("wW") != std::string::npos;
}

Columns ColumnsOf(const TextFile& file) {
  Columns columns;
  std::optional<bool> named_w_first;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i, kBlanksAndCommas);
    columns.first_row = i;
    const bool has_commas =
        std::ranges::count(file.line(i), ',') + 1 >= static_cast<std::ptrdiff_t>(kPoseColumns);
    const bool is_header = row.size() > 0 && !ParseDouble(row.Text(0));
    if (has_commas && is_header) named_w_first = NamesWFirst(file.line(i));
    if (IsComment(row) || (has_commas && is_header)) continue;
    if (has_commas) columns.separators = kBlanksAndCommas;
    columns.w_first = has_commas && named_w_first.value_or(true);
    return columns;
  }
  ThrowError(file.path().string(), "no pose", "a trajectory");
}

bool HasNan(const TextRow& row) {
  for (std::size_t k = 1; k < kPoseColumns; ++k) {
    if (row.Text(k).ends_with("nan") || row.Text(k).ends_with("NaN")) return true;
  }
  return false;
}

// A quaternion of zeros, which tells no rotation, gives the identity.
struct RowPose {
  RigidTransform pose;
  bool is_zero = false;
};

RowPose ReadPose(const TextRow& row, bool w_first) {
  const std::size_t w = w_first ? 4 : 7;
  const std::size_t x = w_first ? 5 : 4;
  const Eigen::Vector3d translation(row.Number(1), row.Number(2), row.Number(3));
  const Eigen::Quaterniond q(row.Number(w), row.Number(x), row.Number(x + 1), row.Number(x + 2));
  if (q.coeffs().isZero(0.0)) return {{Eigen::Quaterniond::Identity(), translation}, true};
  constexpr double kTolerance = 0.05;
  if (!(std::abs(q.norm() - 1.0) <= kTolerance)) {
    row.Fail(StrCat("a quaternion of length ", q.norm()),
             StrCat("length 1 to within ", kTolerance));
  }
  RigidTransform pose(q, translation);
  // Normalising a quaternion again that was written normalised would change its last bit.
  if (std::abs(q.squaredNorm() - 1.0) <= 4.0 * std::numeric_limits<double>::epsilon()) {
    std::copy(q.coeffs().data(), q.coeffs().data() + 4, pose.data());
  }
  return {pose};
}

// Whether the rotations differ; those of one pose alone do, unless it has none.
bool TellsRotations(const Trajectory& poses) {
  return poses.size() < 2 || std::ranges::any_of(poses, [&](const TimedPose& pose) {
           return pose.world_from_camera.rotation().coeffs() !=
                  poses.front().world_from_camera.rotation().coeffs();
         });
}

}  // namespace

TrajectoryFile ReadTrajectory(const std::filesystem::path& path) {
  const TextFile file(path);
  const Columns columns = ColumnsOf(file);
  TrajectoryFile read;
  std::vector<TextRow> rows;
  std::size_t zeros = 0;
  for (std::size_t i = columns.first_row; i < file.size(); ++i) {
    const TextRow row(file, i, columns.separators);
    if (IsComment(row)) continue;
    if (!columns.has_commas() || row.size() < kPoseColumns) {
      row.ExpectColumns(kPoseColumns, "time tx ty tz qx qy qz qw");
    }
    if (HasNan(row)) {
      read.left_out.push_back(i + 1);
      continue;
    }
    rows.push_back(row);
    read.lines.push_back(i + 1);
  }
  std::vector<std::string_view> times;
  for (const TextRow& row : rows) times.push_back(row.Text(0));
  constexpr double kLongestStep_s = 10.0;  // between keyframes
  const TimeUnit unit = TimeUnitOf(times, kLongestStep_s);
  for (const TextRow& row : rows) {
    const std::int64_t time_ns = row.TimeNs(0, unit.ns);
    if (!read.poses.empty() && time_ns <= read.poses.back().timestamp_ns) {
      row.Fail("time " + Quoted(row.Text(0)),
               StrCat("one after ", FormatSecondsNs(read.poses.back().timestamp_ns)));
    }
    const auto [pose, is_zero] = ReadPose(row, columns.w_first);
    read.poses.push_back({time_ns, pose});
    if (is_zero) ++zeros;
    if (zeros > 0 && zeros < read.poses.size()) {
      row.Fail("a quaternion of length 0 in some rows", "quaternions in all rows or in none");
    }
  }
  read.has_rotations = zeros == 0 && TellsRotations(read.poses);
  return read;
}

std::string FormatTumTrajectory(const Trajectory& trajectory) {
  std::string text;
  for (const TimedPose& pose : trajectory) {
    text += FormatSecondsNs(pose.timestamp_ns);
    const double* block = pose.world_from_camera.data();
    for (const int i : {4, 5, 6, 0, 1, 2, 3}) {
      text += ' ';
      text += FormatDouble(block[i]);
    }
    text += '\n';
  }
  return text;
}

std::vector<RigidTransform> ReadKittiPoses(const std::filesystem::path& path) {
  const TextFile file(path);
  std::vector<RigidTransform> poses;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i);
    row.ExpectColumns(kRowNumbers, "a pose [R t] row by row");
    std::vector<double> numbers;
    for (std::size_t k = 0; k < kRowNumbers; ++k) numbers.push_back(row.Number(k));
    poses.push_back(TransformFromRow(numbers, file.Where(i)));
  }
  return poses;
}

std::string FormatKittiPoses(const std::vector<RigidTransform>& world_from_camera) {
  std::string text;
  for (const RigidTransform& pose : world_from_camera) {
    const Eigen::Matrix4d matrix = pose.Matrix();
    for (int i = 0; i < static_cast<int>(kRowNumbers); ++i) {
      text += FormatDouble(matrix(i / 4, i % 4));
      text += i + 1 < static_cast<int>(kRowNumbers) ? ' ' : '\n';
    }
  }
  return text;
}

bool IsKittiPoseFile(const std::filesystem::path& path) {
  const TextFile file(path);
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i);
    if (!IsComment(row)) return row.size() == kRowNumbers;
  }
  return false;
}

}  // namespace cvo
