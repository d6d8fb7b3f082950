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

// Returns the left image of a frame as the run saw it, or an empty image if there is none. `frame`
// is the index within the folder of the sequence.
using ImageOfFrame = std::function<cv::Mat(int frame)>;

struct ThumbnailOptions {
  int width_px = 320;    // maximum; never wider than the image
  int most_frames = 50;  // maximum number, evenly spaced over the run
  int quality = 60;      // of the JPEGs, 1 to 100; 60 gives about 12 kB per frame
  // Of all JPEGs together. If they exceed it, the quality is lowered in steps of 10, to no less
  // than 20.
  std::size_t most_bytes = 700'000;

  void Check() const;
};

struct Thumbnail {
  int frame = 0;
  double time_s = 0.0;  // since the first frame of the run
  std::string jpeg;
  std::string alt;  // text alternative: what the picture shows
};

struct ThumbnailStrip {
  int width_px = 0;
  int height_px = 0;
  std::vector<Thumbnail> thumbnails;
  std::vector<std::string> missing;  // what the drawings lack, frames without an image
};

// Draws evenly spaced frames of a run like `clustervo overlay` does, only smaller. Throws Error for
// options out of range, and for an image that does not have the size of the run's camera.
ThumbnailStrip MakeThumbnails(const OverlayRun& run, const ImageOfFrame& image_of_frame,
                              const ThumbnailOptions& options = {});

}  // namespace cvo::reports
