// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/stereo_camera.h"

// A row of a CSV file lists its columns once, for writing and reading:
//   template <typename Self, typename Archive>
//   static void VisitColumns(Self& self, Archive& archive) {
//     archive.Cells("frame", self.frame);
//     archive.Cells("x,y,z", self.p_in_world);
//   }
// Cells are integers, numbers, texts, vectors, transforms (x y z qx qy qz qw) and image boxes (left
// top right bottom); those of an optional without a value are empty.
namespace cvo {

namespace internal {

template <typename T>
inline constexpr bool kIsOptionalCell = false;
template <typename T>
inline constexpr bool kIsOptionalCell<std::optional<T>> = true;

inline std::array<double, 3> NumbersOf(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline std::array<double, 4> NumbersOf(const ImageBox& box) {
  return {box.left_px, box.top_px, box.right_px, box.bottom_px};
}
inline std::array<double, 7> NumbersOf(const RigidTransform& pose) {
  const double* block = pose.data();
  return {block[4], block[5], block[6], block[0], block[1], block[2], block[3]};
}
// Each returns what is wrong with the numbers; nullptr: nothing.
inline const char* SetNumbers(const std::array<double, 3>& n, Eigen::Vector3d& v) {
  v = Eigen::Vector3d(n.data());
  return nullptr;
}
inline const char* SetNumbers(const std::array<double, 4>& n, ImageBox& box) {
  box = {n[0], n[1], n[2], n[3]};
  return n[2] < n[0] || n[3] < n[1] ? "a box whose left > right or top > bottom" : nullptr;
}
inline const char* SetNumbers(const std::array<double, 7>& n, RigidTransform& pose) {
  const Eigen::Quaterniond rotation(n[6], n[3], n[4], n[5]);
  pose = {rotation, Eigen::Vector3d(n.data())};
  return std::abs(rotation.norm() - 1.0) > 1e-6 ? "a quaternion whose length is not 1" : nullptr;
}

struct CsvNames {
  std::string names;

  template <typename T>
  void Cells(const char* of_cells, const T& /*value*/) {
    names += StrCat(names.empty() ? "" : ",", of_cells);
  }
};

// GCC 12 takes the values of optional cells for uninitialised after inlining.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
class CsvWriter {
 public:
  std::string line;

  template <typename T>
  void Cells(const char* names, const T& value) {
    if constexpr (kIsOptionalCell<T>) {
      if (value) return Cells(names, *value);
      Put("");
      for (const char c : std::string_view(names)) line.append(c == ',' ? 1 : 0, ',');
    } else if constexpr (std::same_as<T, std::string>) {
      Put(value);
    } else if constexpr (std::integral<T>) {
      Put(std::to_string(value));
    } else if constexpr (std::same_as<T, double>) {
      if (!std::isfinite(value)) {
        ThrowError("a table's row \"" + line + "\"", "a number that is not finite", "a finite one");
      }
      Put(FormatDouble(value));
    } else {
      for (const double number : NumbersOf(value)) Cells("", number);
    }
  }

 private:
  void Put(std::string_view text) {
    if (std::exchange(begun_, true)) line += ',';
    line += text;
  }

  bool begun_ = false;
};
#pragma GCC diagnostic pop

class CsvReader {
 public:
  CsvReader(const CsvFile& file, std::size_t row) : file_(file), row_(row), rest_(file.Line(row)) {}

  template <typename T>
  void Cells(std::string_view names, T& value) {
    if constexpr (kIsOptionalCell<T>) {
      const auto commas = static_cast<std::size_t>(std::count(names.begin(), names.end(), ','));
      const bool empty = rest_.substr(0, commas + 1).find_first_not_of(',') == std::string::npos;
      if (!empty) return Cells(names, value.emplace());
      for (std::size_t i = 0; i <= commas; ++i) Next();
    } else if constexpr (std::same_as<T, std::string>) {
      value = Next();
    } else if constexpr (std::same_as<T, int>) {
      value = Parsed(names, "a whole number", ParseInt);
    } else if constexpr (std::same_as<T, std::int64_t>) {
      value = Parsed(names, "a whole number", ParseInteger);
    } else if constexpr (std::same_as<T, double>) {
      value = Parsed(names, "a finite number", ParseDouble);
    } else {
      decltype(NumbersOf(value)) numbers{};
      for (double& number : numbers) {
        const std::string_view name = names.substr(0, names.find(','));
        Cells(name, number);
        names.remove_prefix(std::min(name.size() + 1, names.size()));
      }
      if (const char* problem = SetNumbers(numbers, value)) {
        file_.Fail(row_, problem, "a possible value");
      }
    }
  }

 private:
  template <typename T>
  T Parsed(std::string_view name, const char* expected,
           std::optional<T> (*parse)(std::string_view)) {
    const std::string_view text = Next();
    const std::optional<T> value = parse(text);
    if (!value) file_.Fail(row_, StrCat(Quoted(text), " in column ", name), expected);
    return *value;
  }
  std::string_view Next() {
    const std::size_t end = std::min(rest_.find(','), rest_.size());
    const std::string_view cell = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return cell;
  }

  const CsvFile& file_;
  std::size_t row_;
  std::string_view rest_;
};

}  // namespace internal

// The first line of the file, without its end.
template <typename Row>
std::string CsvHeader() {
  internal::CsvNames names;
  const Row row;
  Row::VisitColumns(row, names);
  return names.names;
}

// A line with its end. Throws Error for a number that is not finite.
template <typename Row>
std::string CsvLine(const Row& row) {
  internal::CsvWriter writer;
  Row::VisitColumns(row, writer);
  return writer.line + "\n";
}

// Calls `take` with each row and its number from 0. Throws Error with file and line for another
// header and a wrong cell.
template <typename Row, typename Take>
void ReadCsv(const std::filesystem::path& path, const Take& take) {
  const CsvFile file(path, CsvHeader<Row>());
  for (std::size_t i = 0; i < file.rows(); ++i) {
    internal::CsvReader reader(file, i);
    Row row;
    Row::VisitColumns(row, reader);
    take(std::move(row), i);
  }
}

}  // namespace cvo
