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

constexpr std::size_t kRowNumbers = 12;      // numbers of a KITTI pose
constexpr std::size_t kPoseColumns = 8;      // of other files
constexpr std::size_t kPositionColumns = 4;  // of files without quaternions
constexpr const char* kBlanks = " \t";
constexpr const char* kDelimiters = " \t,;";

// How the columns of a file are to be read.
struct Columns {
  const char* separators = kBlanks;
  bool w_first = false;
  bool positions = false;     // without quaternions
  std::size_t first_row = 0;  // index of the first line of data
};

bool IsComment(const TextRow& row) { return row.size() == 0 || row.Text(0).starts_with('#'); }

// Whether a line names the columns, with words alone.
bool IsHeader(const TextRow& row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (ParseDouble(row.Text(i))) return false;
  }
  return row.size() >= kPositionColumns;
}

// Whether a header names w before the other parts of the quaternion.
bool NamesWFirst(std::string_view header, const char* separators) {
  for (int i = 0; i < 4; ++i) header.remove_prefix(header.find_first_of(separators) + 1);
  return header.substr(0, header.find_first_of(separators)).find_first_of("wW") !=
         std::string_view::npos;
}

// The header of a file divided by blanks may be a comment about anything: it does not tell an
// order.
Columns ColumnsOf(const TextFile& file) {
  Columns columns;
  std::optional<bool> named_w_first;
  for (std::size_t i = 0; i < file.size(); ++i) {
    const TextRow row(file, i, kDelimiters);
    const std::string& line = file.line(i);
    columns.first_row = i;
    const auto commas = std::ranges::count(line, ',');
    const auto semicolons = std::ranges::count(line, ';');
    const bool delimited =
        std::max(commas, semicolons) + 1 >= static_cast<std::ptrdiff_t>(kPositionColumns);
    if (delimited && IsHeader(row)) named_w_first = NamesWFirst(line, commas > 0 ? "," : ";");
    if (!delimited && IsHeader(row) && !IsComment(row) && row.size() >= kPoseColumns) {
      named_w_first = row.Text(4).find_first_of("wW") != std::string_view::npos;
    }
    if (IsComment(row) || IsHeader(row)) continue;
    if (delimited) columns.separators = kDelimiters;
    columns.w_first = named_w_first.value_or(delimited);
    columns.positions = row.size() == kPositionColumns;
    return columns;
  }
  ThrowError(file.path().string(), "no pose", "a trajectory");
}

// Programs write NaN or infinity where they have no pose.
bool HasNoNumber(const TextRow& row) {
  for (std::size_t k = 1; k < std::min(row.size(), kPoseColumns); ++k) {
    const std::string_view text = row.Text(k);
    for (const char* word : {"nan", "NaN", "NAN", "inf", "Inf", "INF"}) {
      if (text.starts_with(word) || text.starts_with(StrCat("-", word))) return true;
    }
  }
  return false;
}

void CheckColumns(const TextRow& row, const Columns& columns) {
  const std::size_t expected = columns.positions ? kPositionColumns : kPoseColumns;
  const bool delimited = columns.separators == kDelimiters;
  if (row.size() == expected || (delimited && row.size() > expected && !columns.positions)) return;
  if (columns.positions) row.ExpectColumns(expected, "as in the lines before");
  row.ExpectColumns(expected,
                    "time tx ty tz qx qy qz qw (TUM; EuRoC with commas: qw first); 4 for positions "
                    "alone, 12 for KITTI's poses");
}

// A quaternion of zeros, which tells no rotation, gives the identity.
struct RowPose {
  RigidTransform pose;
  bool is_zero = false;
};

RowPose ReadPose(const TextRow& row, const Columns& columns) {
  const std::size_t w = columns.w_first ? 4 : 7;
  const std::size_t x = columns.w_first ? 5 : 4;
  const Eigen::Vector3d translation(row.Number(1), row.Number(2), row.Number(3));
  if (columns.positions) return {{Eigen::Quaterniond::Identity(), translation}, true};
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
    CheckColumns(row, columns);
    if (HasNoNumber(row)) {
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
    const auto [pose, is_zero] = ReadPose(row, columns);
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
