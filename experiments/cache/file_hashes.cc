// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cache/file_hashes.h"

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "experiments/cache/hash_index.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

constexpr std::int64_t kRacy_ns = 2'000'000'000;  // the coarsest resolution of timestamps in use

struct UnknownFile {
  const fs::path* file;
  std::string* sha256;
  FileStamp stamp;  // before it was read
};

class FileHasher {
 public:
  FileHasher(fs::path index_folder, const FileHashHooks& hooks)
      : index_folder_(std::move(index_folder)), hooks_(hooks) {}

  std::string Lookup(const fs::path& file, const FileStamp& stamp) {
    return IndexOf(file).Find(file.filename().string(), stamp);
  }

  void HashAll(const std::vector<UnknownFile>& files, TaskPool& pool) {
    const std::int64_t start_ns = hooks_.now_ns();
    std::mutex mutex;
    std::size_t done = 0;
    pool.ParallelFor(static_cast<int>(files.size()), [&](int i) {
      const UnknownFile& unknown = files[static_cast<std::size_t>(i)];
      *unknown.sha256 = HashFile(*unknown.file);
      const std::lock_guard lock(mutex);
      hooks_.hashed(++done, files.size());
    });
    for (const UnknownFile& unknown : files) Keep(unknown, start_ns);
    for (const auto& [folder, index] : indices_) Save(index);
  }

 private:
  HashIndex& IndexOf(const fs::path& file) {
    const fs::path folder = file.parent_path();
    return indices_.try_emplace(folder, index_folder_, folder, hooks_.notice).first->second;
  }

  void Keep(const UnknownFile& unknown, std::int64_t start_ns) {
    const auto& [file, sha256, stamp] = unknown;
    const bool settled = std::max(stamp.modified_ns, stamp.changed_ns) + kRacy_ns <= start_ns;
    if (sha256->empty() || !settled || StampOf(*file) != stamp) return;
    IndexOf(*file).Add(file->filename().string(), stamp, *sha256);
  }

  void Save(const HashIndex& index) const {
    try {
      index.Save();
    } catch (const std::exception& error) {
      hooks_.notice(StrCat("file hashes are not kept for other runs: ", error.what()));
    }
  }

  fs::path index_folder_;
  const FileHashHooks& hooks_;
  std::map<fs::path, HashIndex> indices_;
};

}  // namespace

std::vector<std::string> FindFileHashes(const std::vector<fs::path>& files,
                                        const fs::path& index_folder, TaskPool& pool,
                                        const FileHashHooks& hooks) {
  std::vector<std::string> hashes(files.size());
  FileHasher hasher(index_folder, hooks);
  std::vector<UnknownFile> unknown;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::optional<FileStamp> stamp = StampOf(files[i]);
    if (!stamp) continue;  // no file, no hash
    hashes[i] = hasher.Lookup(files[i], *stamp);
    if (hashes[i].empty()) unknown.push_back({&files[i], &hashes[i], *stamp});
  }
  if (!unknown.empty()) hasher.HashAll(unknown, pool);
  return hashes;
}

std::vector<ImageHashes> FindImageHashes(const Sequence& sequence, const fs::path& index_folder,
                                         TaskPool& pool, const FileHashHooks& hooks) {
  std::vector<fs::path> files;
  for (const StereoPaths& pair : sequence.images) {
    files.push_back(pair.left);
    files.push_back(pair.right);
  }
  std::vector<std::string> hashes = FindFileHashes(files, index_folder, pool, hooks);
  std::vector<ImageHashes> images;
  for (std::size_t i = 0; i < hashes.size(); i += 2) {
    images.push_back({std::move(hashes[i]), std::move(hashes[i + 1])});
  }
  return images;
}

}  // namespace cvo
