// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace cvo {

// Seeded random number generator (xoshiro256**, Blackman and Vigna 2018) with its own
// distributions, because those of the standard library differ between implementations. Each module
// has its own stream: the same seed with another stream name gives independent numbers.
class Rng {
 public:
  Rng(std::uint64_t seed, std::string_view stream);

  std::uint64_t NextU64();
  // Uniform in [0, n), n > 0, without modulo bias.
  std::uint64_t UniformInt(std::uint64_t n);
  // Uniform in [0, 1), 53 bits.
  double Uniform();
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  // Standard normal (Marsaglia's polar method).
  double Normal();

 private:
  std::uint64_t state_[4];
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace cvo
