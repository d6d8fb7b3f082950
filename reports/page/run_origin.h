// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cvo::reports {

// A name and a value, both for people.
using Fact = std::pair<std::string, std::string>;

// What made a result: the program (result.json) and the machine (timing.json). What a file lacks is
// left out; a file that cannot be read is named in `missing`.
struct RunOrigin {
  std::vector<Fact> build;    // commit, compiler, versions
  std::vector<Fact> machine;  // host, processor
  std::vector<Fact> time;     // when, how long
  std::vector<std::string> missing;
};

RunOrigin ReadRunOrigin(const std::filesystem::path& run_folder);

}  // namespace cvo::reports
