// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/runner/file_hashes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/sha256.h"
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

namespace fs = std::filesystem;
namespace {

constexpr std::int64_t kRacy_ns = 2'000'000'000;     // the coarsest resolution of timestamps in use
constexpr std::uint64_t kLimit_bytes = 256'000'000;  // of the hashes of all lists

// What the file system states about files: with the same key they have the same bytes.
struct Stamps {
  std::string key;
  std::int64_t newest_ns = 0;  // last change of any of them
};

std::int64_t Nanoseconds(const timespec& time) {
  return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

Stamps StampsOf(const std::vector<fs::path>& files) {
  Stamps stamps;
  std::string text;
  for (const fs::path& file : files) {
    text += fs::absolute(file).lexically_normal().string();
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0) {
      // The time of the last change of content, name or permissions cannot be set back.
      const std::int64_t modified_ns = Nanoseconds(status.st_mtim);
      const std::int64_t changed_ns = Nanoseconds(status.st_ctim);
      stamps.newest_ns = std::max({stamps.newest_ns, modified_ns, changed_ns});
      text += StrCat('\0', status.st_size, ' ', modified_ns, ' ', changed_ns, ' ', status.st_ino);
    }
    text += '\0';
  }
  stamps.key = Sha256Hex(text);
  return stamps;
}

// The file with hashes has one line per hash, and one with the hash of all of these lines.
std::string Kept(const std::vector<std::string>& hashes) {
  std::string lines;
  for (const std::string& hash : hashes) lines += hash + "\n";
  return lines + Sha256Hex(lines) + "\n";
}

// Empty if there are none, or if they are damaged.
std::optional<std::vector<std::string>> ReadKept(const fs::path& file, std::size_t count) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  try {
    const std::string bytes = ReadFileBytes(file);
    std::vector<std::string> hashes;
    for (std::size_t begin = 0; begin < bytes.size() && hashes.size() < count;) {
      const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
      hashes.push_back(bytes.substr(begin, end - begin));
      begin = end + 1;
    }
    if (hashes.size() != count || Kept(hashes) != bytes) return std::nullopt;
    MarkUsed(file);
    return hashes;
  } catch (const Error&) {
    return std::nullopt;  // another process has removed the file
  }
}

}  // namespace

std::vector<std::string> FindFileHashes(const std::vector<fs::path>& files, const fs::path& folder,
                                        TaskPool& pool, const FileHashHooks& hooks) {
  const Stamps stamps = StampsOf(files);
  const std::string name = stamps.key + ".txt";
  if (!folder.empty()) {
    if (auto kept = ReadKept(folder / name, files.size())) return *std::move(kept);
  }
  const std::int64_t start_ns = hooks.now_ns();
  std::vector<std::string> hashes(files.size());
  std::mutex mutex;
  std::size_t done = 0;
  pool.ParallelFor(static_cast<int>(files.size()), [&](int i) {
    const auto index = static_cast<std::size_t>(i);
    hashes[index] = HashFile(files[index]);
    const std::lock_guard lock(mutex);
    hooks.hashed(++done, files.size());
  });
  const bool settled = stamps.newest_ns + kRacy_ns <= start_ns && StampsOf(files).key == stamps.key;
  if (folder.empty() || !settled) return hashes;
  try {
    std::error_code error;
    fs::create_directories(folder, error);
    WriteFilesAtomically(folder, {{name, Kept(hashes)}});
    TrimFolder(folder, kLimit_bytes);
  } catch (const std::exception& error) {
    hooks.notice(StrCat("file hashes are not kept for other runs: ", error.what()));
  }
  return hashes;
}

std::vector<ImageHashes> FindImageHashes(const Sequence& sequence, const fs::path& folder,
                                         TaskPool& pool, const FileHashHooks& hooks) {
  std::vector<fs::path> files;
  for (const StereoPaths& pair : sequence.images) {
    files.push_back(pair.left);
    files.push_back(pair.right);
  }
  std::vector<std::string> hashes = FindFileHashes(files, folder, pool, hooks);
  std::vector<ImageHashes> images;
  for (std::size_t i = 0; i < hashes.size(); i += 2) {
    images.push_back({std::move(hashes[i]), std::move(hashes[i + 1])});
  }
  return images;
}

}  // namespace cvo
