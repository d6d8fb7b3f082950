// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace cvo {

// A headless Chromium with an empty profile of its own that has no network to use.
class Browser {
 public:
  // CLUSTERVO_BROWSER, else /usr/bin/chromium. Throws Error where it is not there. What a page
  // needs is written below `scratch`, which must exist.
  explicit Browser(std::filesystem::path scratch);

  // The page's text once it has run. Throws Error with why the browser ended.
  std::string Run(const std::string& page) const;

  // The page as PDF.
  std::string Print(const std::string& page) const;

 private:
  // Starts it with these flags and the page, its output to a file whose bytes are returned.
  std::string Start(const std::string& page, const std::string& flag,
                    const std::filesystem::path& out) const;

  std::filesystem::path program_;
  std::filesystem::path scratch_;
};

}  // namespace cvo
