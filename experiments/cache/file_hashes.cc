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
#include "core/files/json.h"
#include "experiments/cache/hash_index.h"

namespace cvo {
namespace fs = std::filesystem;
namespace {

constexpr std::int64_t kRacy_ns = 2'000'000'000;  // the coarsest time stamps in use

// The hashes that a rendered scene came with.
class SceneManifest {
 public:
  explicit SceneManifest(const fs::path& folder) : folder_(folder) {
    const fs::path file = folder / "manifest.json";
    const std::optional<FileStamp> stamp = StampOf(file);
    if (!stamp) return;
    written_ns_ = stamp->changed_ns;
    try {
      const Json json = ReadJson(file);
      if (json.at("kind") != "clustervo synthetic sequence" || json.at("schema_version") != 1) {
        return;
      }
      for (const Json& row : json.at("files")) {
        files_[row.at("name")] = {row.at("size_bytes"), row.at("sha256")};
      }
    } catch (const std::exception&) {  // not a manifest: its folder is hashed
      files_.clear();
    }
  }

  std::string Find(const fs::path& file, const FileStamp& stamp) const {
    const auto entry = files_.find(file.lexically_relative(folder_).generic_string());
    if (entry == files_.end() || entry->second.first != stamp.size_bytes) return "";
    const bool as_written = std::max(stamp.modified_ns, stamp.changed_ns) <= written_ns_;
    return as_written ? entry->second.second : "";
  }

 private:
  fs::path folder_;
  std::int64_t written_ns_ = 0;
  std::map<std::string, std::pair<std::int64_t, std::string>> files_;  // name: size, SHA-256
};

struct Image {
  const fs::path* file;
  std::string* sha256;
  std::optional<FileStamp> stamp;  // before it was read
};

class ImageHasher {
 public:
  ImageHasher(const Sequence& sequence, fs::path index_folder, const FileHashHooks& hooks)
      : index_folder_(std::move(index_folder)), hooks_(hooks), manifest_(sequence.folder) {}

  // Whether the hash is known without reading the file.
  bool Lookup(Image& image) {
    image.stamp = StampOf(*image.file);
    if (!image.stamp) return true;  // no file, no hash
    *image.sha256 = IndexOf(*image.file).Find(image.file->filename().string(), *image.stamp);
    if (image.sha256->empty()) *image.sha256 = manifest_.Find(*image.file, *image.stamp);
    return !image.sha256->empty();
  }

  void HashAll(std::vector<Image>& images, TaskPool& pool) {
    const std::int64_t start_ns = hooks_.now_ns();
    std::mutex mutex;
    std::size_t done = 0;
    pool.ParallelFor(static_cast<int>(images.size()), [&](int i) {
      const Image& image = images[static_cast<std::size_t>(i)];
      *image.sha256 = HashImage(*image.file);
      const std::lock_guard lock(mutex);
      hooks_.hashed(++done, images.size());
    });
    for (const Image& image : images) Keep(image, start_ns);
    for (const auto& [folder, index] : indices_) Save(index);
  }

 private:
  HashIndex& IndexOf(const fs::path& file) {
    const fs::path folder = file.parent_path();
    return indices_.try_emplace(folder, index_folder_, folder, hooks_.notice).first->second;
  }

  void Keep(const Image& image, std::int64_t start_ns) {
    const FileStamp& stamp = *image.stamp;
    const bool settled = std::max(stamp.modified_ns, stamp.changed_ns) + kRacy_ns <= start_ns;
    if (image.sha256->empty() || !settled || StampOf(*image.file) != image.stamp) return;
    IndexOf(*image.file).Add(image.file->filename().string(), stamp, *image.sha256);
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
  SceneManifest manifest_;
  std::map<fs::path, HashIndex> indices_;
};

}  // namespace

std::vector<ImageHashes> FindImageHashes(const Sequence& sequence, const fs::path& index_folder,
                                         TaskPool& pool, const FileHashHooks& hooks) {
  std::vector<ImageHashes> hashes(sequence.images.size());
  ImageHasher hasher(sequence, index_folder, hooks);
  std::vector<Image> unknown;
  for (std::size_t i = 0; i < hashes.size(); ++i) {
    Image pair[] = {{&sequence.images[i].left, &hashes[i].left, {}},
                    {&sequence.images[i].right, &hashes[i].right, {}}};
    for (Image& image : pair) {
      if (!hasher.Lookup(image)) unknown.push_back(image);
    }
  }
  if (!unknown.empty()) hasher.HashAll(unknown, pool);
  return hashes;
}

}  // namespace cvo
