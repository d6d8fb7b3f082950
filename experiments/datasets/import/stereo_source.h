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

// Sorts the image files of one folder by time: by value if all names are distinct numbers (times in
// seconds or nanoseconds), otherwise by name, with runs of digits compared as numbers, so that
// frame_2 precedes frame_10.
void SortByNumber(std::vector<std::filesystem::path>& files);

// Throws Error naming the first image whose number no image of the other camera has. Nothing is
// checked, and images remain paired by position, if names have no number or share one, or if all
// names are numbers and the cameras have none in common, as with timestamps of unsynchronised
// cameras.
void CheckPartners(const std::vector<std::filesystem::path>& left,
                   const std::vector<std::filesystem::path>& right);

struct SourceImage {
  cv::Mat grey;        // 8 bits; empty if damaged
  cv::Size size;       // from the header if damaged; empty at the end of the source
  std::string damage;  // "<file>: found ..., expected ..."; empty if intact
};

// Images of one camera in temporal order: a folder of image files (SortByNumber), or a video.
class ImageSource {
 public:
  virtual ~ImageSource() = default;

  // Number of images; for a video, as stated in its header.
  virtual std::size_t size() const = 0;
  // Returns the next image. Throws Error if not even its header can be read.
  virtual SourceImage Next() = 0;
  // The image files if the source is a folder, otherwise empty.
  virtual std::vector<std::filesystem::path> files() const { return {}; }
  // Frame rate of a video if its header states one, otherwise 0.
  virtual double rate_hz() const { return 0.0; }
};

// Throws Error if there is no image.
std::unique_ptr<ImageSource> OpenImages(const std::filesystem::path& path);

// Reads one time per image from a file with one per line, in seconds, or in nanoseconds if it is an
// integer above 1e12. Throws Error unless there are `count` times in strictly increasing order.
std::vector<std::int64_t> ReadTimes(const std::filesystem::path& path, std::size_t count);

// Returns the times in the names of files, in nanoseconds. Empty unless all names are integers
// above 1e12 in strictly increasing order.
std::vector<std::int64_t> TimesOfNames(const std::vector<std::filesystem::path>& files);

}  // namespace cvo
