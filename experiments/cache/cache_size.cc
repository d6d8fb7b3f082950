// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cache/cache_size.h"

#include <cstdlib>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"

namespace cvo {
namespace {

constexpr std::uint64_t kDefault_bytes = 20'000'000'000;

std::uint64_t ParseSize(const std::string& text, const char* where) {
  constexpr std::string_view kUnits = "KMGT";
  constexpr double kLargest_bytes = 1e18;
  double unit = 1.0;
  std::string_view number = text;
  const std::size_t letter = text.empty() ? std::string_view::npos : kUnits.find(text.back());
  if (letter != std::string_view::npos) {
    for (std::size_t i = 0; i <= letter; ++i) unit *= 1000.0;
    number.remove_suffix(1);
  }
  const std::optional<double> value = ParseDouble(number);
  if (!value || *value < 0.0 || *value * unit > kLargest_bytes) {
    ThrowError(where, Quoted(text), "a size in bytes, such as 500M or 20G");
  }
  return static_cast<std::uint64_t>(*value * unit);
}

}  // namespace

std::uint64_t CacheLimit(const std::string& option) {
  if (!option.empty()) return ParseSize(option, "option --cache-size");
  const char* variable = std::getenv("CLUSTERVO_CACHE_SIZE");
  if (variable != nullptr && *variable != '\0') return ParseSize(variable, "CLUSTERVO_CACHE_SIZE");
  return kDefault_bytes;
}

}  // namespace cvo
