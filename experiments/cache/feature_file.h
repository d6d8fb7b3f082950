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

// To be raised with any change to what the bytes mean: it is in the file and in its key.
inline constexpr std::uint32_t kFeatureFileVersion = 2;

// Front-end frames of a whole sequence: a header with the version and the key, the frames, and an
// index with the place and SHA-256 of each. Every byte is under one of the checksums.
class FeatureFile {
 public:
  // Empty where there is no such file. Throws Error for one that is cut, damaged, of another
  // version or of another key.
  static std::optional<FeatureFile> Open(const std::filesystem::path& file, const std::string& key,
                                         std::size_t frames);

  // Throws Error where the frame's bytes are not those that were written.
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

// Writes one, frame by frame as they come. Throws Error as NewCacheFile does.
class FeatureFileWriter {
 public:
  explicit FeatureFileWriter(const std::filesystem::path& folder);

  void Add(const FrontEndFrame& frame);
  // Completes the file, all but its name; its size.
  std::uint64_t Complete(const std::string& key);
  void Publish(const std::string& name) { file_.Publish(name); }

 private:
  NewCacheFile file_;
  std::string index_;
  std::uint32_t frames_ = 0;
};

}  // namespace cvo
