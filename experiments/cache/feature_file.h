// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/disk.h"
#include "experiments/cache/cache_file.h"
#include "experiments/cache/front_end_frame.h"

namespace cvo {

// Must be incremented with any change to the meaning of the bytes. It is part of the file and of
// its key.
inline constexpr std::uint32_t kFeatureFileVersion = 3;

// Front-end output of all frames of a sequence: a header with version and key, the frames, and an
// index with the position and SHA-256 of each. Every byte is covered by a checksum.
class FeatureFile {
 public:
  // Returns nothing if there is no such file. Throws Error for a file that is truncated, damaged,
  // of another version or of another key.
  static std::optional<FeatureFile> Open(const std::filesystem::path& file, const std::string& key,
                                         std::size_t frames);

  // Reads a frame. Throws Error if its bytes are not those that were written.
  FrontEndFrame Frame(std::size_t index) const;

 private:
  FeatureFile(FileDescriptor file, const std::string& name, const std::string& key,
              std::size_t frames);

  struct Place {
    std::uint64_t offset;
    std::uint64_t size_bytes;
    std::string sha256;
  };

  std::string Read(std::uint64_t offset, std::uint64_t count) const;
  std::vector<Place> ReadIndex(std::uint64_t offset, std::size_t frames) const;

  std::string name_;
  FileDescriptor file_;
  std::uint64_t size_bytes_;
  std::vector<Place> places_;
};

// Writes a FeatureFile frame by frame. Throws Error as NewCacheFile does.
class FeatureFileWriter {
 public:
  explicit FeatureFileWriter(const std::filesystem::path& folder);

  void Add(const FrontEndFrame& frame);
  // Completes the file except for its name. Returns its size in bytes.
  std::uint64_t Complete(const std::string& key);
  void Publish(const std::string& name) { file_.Publish(name); }

 private:
  NewCacheFile file_;
  std::string index_;
  std::uint32_t frames_ = 0;
};

}  // namespace cvo
