// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace cvo {

// A headless Chromium with an empty profile of its own and no network access.
class Browser {
 public:
  // Uses the program CLUSTERVO_BROWSER, or /usr/bin/chromium by default. Throws Error if it cannot
  // be run. Files that a page needs are written to `scratch`, which must exist.
  explicit Browser(std::filesystem::path scratch);

  // Returns the DOM of the page, as HTML, after its scripts have run. Throws Error with the reason
  // if the browser fails.
  std::string Run(const std::string& page) const;

  // Returns the page as PDF. Throws Error as Run.
  std::string Print(const std::string& page) const;

 private:
  // Runs the browser on the page with this flag. Returns the content of the output file `out`.
  std::string Start(const std::string& page, const std::string& flag,
                    const std::filesystem::path& out) const;

  std::filesystem::path program_;
  std::filesystem::path scratch_;
};

}  // namespace cvo
