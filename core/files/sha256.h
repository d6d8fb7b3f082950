// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace cvo {

// Hexadecimal digits of a SHA-256.
inline constexpr std::size_t kHashBytes = 64;
// Of the file beside another that has its SHA-256, as the program sha256sum prints it.
inline constexpr const char* kChecksumSuffix = ".sha256";

// SHA-256 of everything that was added, as 64 lower-case hexadecimal digits.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void Add(std::string_view bytes);
  // Ends the hash: call it once, last.
  std::string Hex();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string Sha256Hex(std::string_view bytes);

}  // namespace cvo
