// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/datasets/formats/data_rows.h"

#include <cmath>

#include "core/base/error.h"
#include "core/files/text/number.h"

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
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  for (int i = 0; i < 3; ++i) {
    const std::size_t at = column + 4 * static_cast<std::size_t>(i);
    rotation.row(i) = Vector(row, at);
    translation[i] = Number(row, at + 3);
  }
  if ((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() > kTolerance ||
      rotation.determinant() < 0.0) {
    Fail(row, "a matrix without a rotation", "[R t] with R^T R = I and determinant 1");
  }
  return {NearestRotation(rotation), translation};
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

}  // namespace cvo
