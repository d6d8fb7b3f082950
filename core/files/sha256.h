// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // of OpenSSL

namespace cvo {

// Number of hexadecimal digits of a SHA-256.
inline constexpr std::size_t kHashBytes = 64;

// SHA-256 of all bytes added, as 64 lower-case hexadecimal digits.
class Sha256 {
 public:
  Sha256();

  void Add(std::string_view bytes);
  // Finishes the hash: must be called once, last.
  std::string Hex();

 private:
  std::unique_ptr<evp_md_ctx_st, void (*)(evp_md_ctx_st*)> context_;
};

std::string Sha256Hex(std::string_view bytes);

}  // namespace cvo
