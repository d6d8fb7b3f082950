// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/temporary.h"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <functional>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/files/host_name.h"
#include "core/files/text/number.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kMark = ".tmp-";
constexpr std::chrono::hours kMaxAge(24);  // no write takes that long

struct Owner {
  std::string host;
  std::int64_t process = 0;
};

// Parses ".name.tmp-<host>.<process>-<end>". Empty if the name has another form.
std::optional<Owner> OwnerOf(const std::string& name) {
  const std::size_t mark = name.rfind(kMark);
  if (mark == std::string::npos || !name.starts_with('.')) return std::nullopt;
  const std::string tail = name.substr(mark + kMark.size());
  const std::size_t dash = tail.rfind('-');
  const std::size_t dot = tail.substr(0, dash).rfind('.');
  if (dash == std::string::npos || dot == std::string::npos) return std::nullopt;
  const auto process = ParseInteger(tail.substr(dot + 1, dash - dot - 1));
  if (!process || *process <= 0) return std::nullopt;
  return Owner{tail.substr(0, dot), *process};
}

bool IsOld(const fs::path& path) {
  std::error_code gone;
  const fs::file_time_type written = fs::last_write_time(path, gone);
  return !gone && fs::file_time_type::clock::now() - written > kMaxAge;
}

// For a process on another computer, only the time since its last write is known.
bool IsStale(const Owner& owner, const fs::path& temporary) {
  if (owner.host == HostName()) {
    return ::kill(static_cast<pid_t>(owner.process), 0) != 0 && errno == ESRCH;
  }
  return IsOld(temporary);
}

void RemoveWhere(const fs::path& folder,
                 const std::function<bool(const Owner&, const fs::path&)>& goes) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::optional<Owner> owner = OwnerOf(it->path().filename().string());
    if (owner && goes(*owner, it->path())) found.push_back(it->path());
  }
  for (const fs::path& path : found) fs::remove_all(path, error);
}

}  // namespace

fs::path TemporaryName(const fs::path& target, const std::string& end) {
  return target.parent_path() /
         StrCat(".", target.filename().string(), kMark, HostName(), ".", ::getpid(), "-", end);
}

bool IsTemporary(const fs::path& file) { return OwnerOf(file.filename().string()).has_value(); }

void RemoveLeftovers(const fs::path& folder) { RemoveWhere(folder, IsStale); }

void RemoveTemporaries(const fs::path& folder) {
  RemoveWhere(folder, [](const Owner&, const fs::path&) { return true; });
}

void RemoveEmptyFolders(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code gone;
    if (it->symlink_status(gone).type() == fs::file_type::directory && IsOld(it->path())) {
      old.push_back(it->path());
    }
  }
  for (const fs::path& path : old) ::rmdir(path.c_str());  // fails if it is not empty
}

}  // namespace cvo
