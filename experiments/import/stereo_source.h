// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace cvo {

struct SourceImage {
  cv::Mat grey;        // 8 bits; empty if it is damaged
  cv::Size size;       // also of a damaged one, from its header; empty: at the end
  std::string damage;  // "<file>: found ..., expected ..."; empty: whole
};

// Images of one camera in order of time: a folder of image files (SortByNumber), or a video.
class ImageSource {
 public:
  virtual ~ImageSource() = default;

  // Number of images; of a video as its header states it.
  virtual std::size_t size() const = 0;
  // The next image. Throws Error for one whose header cannot be read either.
  virtual SourceImage Next() = 0;
  // The files, where the source is a folder.
  virtual std::vector<std::filesystem::path> files() const { return {}; }
  // Of a video, where its header states it; else 0.
  virtual double rate_hz() const { return 0.0; }
};

// Throws Error where there is no image.
std::unique_ptr<ImageSource> OpenImages(const std::filesystem::path& path);

// One time per image: from a file with one per line, in seconds, or in nanoseconds where they are
// whole numbers above 1e12; strictly increasing. Throws Error unless there are `count`.
std::vector<std::int64_t> ReadTimes(const std::filesystem::path& path, std::size_t count);

// Times that stand in the names of files, in nanoseconds (whole numbers above 1e12); empty where
// they do not.
std::vector<std::int64_t> TimesOfNames(const std::vector<std::filesystem::path>& files);

}  // namespace cvo
