// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/suite/suite.h"

namespace cvo::test {

// The smallest suite: one scene, one variant, one seed.
inline Json SmallSuite() {
  return {{"name", "small"},
          {"sequences", {{{"scene", "tiny"}, {"detections", "good"}}}},
          {"variants", {"full"}},
          {"seeds", 1},
          {"table", {{"rows", {"variant"}}, {"metrics", {"camera_ate"}}}}};
}

// The same on a folder of images.
inline Json FolderSuite(const std::string& folder) {
  Json json = SmallSuite();
  json["sequences"] = Json::array({{{"folder", folder}}});
  json["variants"] = {"static"};
  return json;
}

// As from a file: names of files and commands are resolved too.
inline Suite Parse(const Json& json) { return ParseSuite(json, "s.json", "."); }

}  // namespace cvo::test
