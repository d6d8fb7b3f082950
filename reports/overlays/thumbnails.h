// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "reports/overlays/overlay_run.h"

namespace cvo::reports {

// The left image of a frame as the run saw it, counted in the folder of the sequence; empty where
// there is none.
using ImageOfFrame = std::function<cv::Mat(int frame)>;

struct ThumbnailOptions {
  int width_px = 320;    // at most; never wider than the image
  int most_frames = 50;  // of the run, evenly spaced
  int quality = 60;      // of JPEG, 0 to 100: about 12 kB for a frame
  std::size_t most_bytes =
      700'000;  // of all together: a lower quality is taken where they are more

  void Check() const;
};

struct Thumbnail {
  int frame = 0;
  double time_s = 0.0;  // since the first frame run
  std::string jpeg;
  std::string alt;  // what it shows, in words
};

struct ThumbnailStrip {
  int width_px = 0;
  int height_px = 0;
  std::vector<Thumbnail> thumbnails;
  std::vector<std::string> missing;  // what is drawn without, frames without an image
};

// Every k-th frame of a run, drawn as `clustervo overlay` does but for its size. Throws Error for
// an image that is not of the run's camera.
ThumbnailStrip MakeThumbnails(const OverlayRun& run, const ImageOfFrame& image_of_frame,
                              const ThumbnailOptions& options = {});

}  // namespace cvo::reports
