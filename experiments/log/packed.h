// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/error.h"
#include "core/files/bytes.h"
#include "core/geometry/rigid_transform.h"

namespace cvo {

// Packs a record as the fields that its Visit(record, archive) passes to the archive, in this
// order: archive(record.a, record.b, ...). Fields are numbers, strings, poses, matrices of fixed
// size, vectors and records. The bytes are meant only for the process that packed them.
class Packer {
 public:
  explicit Packer(std::string& bytes) : bytes_(bytes) {}

  template <typename... Fields>
  void operator()(const Fields&... fields) {
    (Pack(fields), ...);
  }

 private:
  void Raw(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }
  void Pack(const std::string& text) {
    AppendNumber(static_cast<std::uint32_t>(text.size()), bytes_);
    bytes_ += text;
  }
  void Pack(const RigidTransform& pose) { Raw(pose.data(), 7 * sizeof(double)); }
  template <int kRows, int kColumns>
  void Pack(const Eigen::Matrix<double, kRows, kColumns>& matrix) {
    Raw(matrix.data(), sizeof(double) * kRows * kColumns);
  }
  template <typename T>
  void Pack(const std::vector<T>& list) {
    AppendNumber(static_cast<std::uint32_t>(list.size()), bytes_);
    for (const T& element : list) Pack(element);
  }
  template <typename T>
  void Pack(const T& field) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      Raw(&field, sizeof(T));
    } else {
      Visit(field, *this);
    }
  }

  std::string& bytes_;
};

// Reads the same fields back.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <typename... Fields>
  void operator()(Fields&... fields) {
    (Unpack(fields), ...);
  }

 private:
  void Raw(void* data, std::size_t size) { std::memcpy(data, bytes_.Take(size).data(), size); }
  void Unpack(std::string& text) { text = bytes_.Take(bytes_.Number<std::uint32_t>()); }
  void Unpack(RigidTransform& pose) { Raw(pose.data(), 7 * sizeof(double)); }
  template <int kRows, int kColumns>
  void Unpack(Eigen::Matrix<double, kRows, kColumns>& matrix) {
    Raw(matrix.data(), sizeof(double) * kRows * kColumns);
  }
  template <typename T>
  void Unpack(std::vector<T>& list) {
    list.resize(bytes_.Number<std::uint32_t>());
    for (T& element : list) Unpack(element);
  }
  template <typename T>
  void Unpack(T& field) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      Raw(&field, sizeof(T));
    } else {
      Visit(field, *this);
    }
  }

  ByteReader bytes_;
};

}  // namespace cvo
