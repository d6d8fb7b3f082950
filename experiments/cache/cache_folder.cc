// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cache/cache_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <system_error>
#include <tuple>
#include <vector>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"

namespace cvo {
namespace fs = std::filesystem;
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

void MarkUsed(const fs::path& file) { (void)::utimensat(AT_FDCWD, file.c_str(), nullptr, 0); }

void TrimFolder(const fs::path& folder, std::uint64_t limit_bytes) {
  struct Entry {
    fs::file_time_type used;
    fs::path path;
    std::uint64_t size_bytes;
  };
  std::vector<Entry> entries;
  std::uint64_t total_bytes = 0;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    std::error_code gone;
    if (IsTemporary(file.path()) || !file.is_regular_file(gone)) continue;
    const Entry entry = {file.last_write_time(gone), file.path(), file.file_size(gone)};
    if (gone) continue;
    total_bytes += entry.size_bytes;
    entries.push_back(entry);
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.used, a.path) < std::tie(b.used, b.path);
  });
  for (const Entry& entry : entries) {
    if (total_bytes <= limit_bytes) return;
    if (::unlink(entry.path.c_str()) == 0 || errno == ENOENT) total_bytes -= entry.size_bytes;
  }
}

}  // namespace cvo
