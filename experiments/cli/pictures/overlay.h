// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cvo {

struct OverlayFlags {
  std::vector<std::string> runs = {};
  std::string suite = {};
  std::string sequence = {};
  std::string variants = "full";
  std::optional<std::uint64_t> seed = {};
  std::string output = {};
  int frame = -1;
  std::string frames = {};
  int every = 1;
  double scale = 1.0;
  std::string labels = {};
  bool sheet = false;
  bool video = false;
  bool no_images = false;
  bool no_inset = false;
  bool quiet = false;
};

// Draws runs on their images. Returns the exit code. Throws Error.
int DrawOverlays(const OverlayFlags& flags);

}  // namespace cvo
