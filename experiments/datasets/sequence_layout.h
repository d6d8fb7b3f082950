// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/files/json/json_record.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

// How a data set lays out the files of a sequence. layouts/my_set.cc defines `SequenceLayout
// MySetLayout()`; a new layout needs no other registration.
struct SequenceLayout {
  std::string type;   // value of --type
  std::string shape;  // its characteristic files, for messages
  // Whether a folder has this layout, complete or not. No two layouts recognise the same folder.
  bool (*knows)(const std::filesystem::path& folder);
  // Whether the folder has images of both cameras; FindSequences omits those that do not.
  bool (*has_images)(const std::filesystem::path& folder);
  Sequence (*read)(const SequenceRequest& request);
  // Every key that SequenceRequest::layout may have, with its default.
  Json settings = Json::object();
};

// Returns all layouts, sorted by type.
const std::vector<SequenceLayout>& SequenceLayouts();

// Returns SequenceRequest::layout, whose keys have been checked, as a layout's record of settings.
template <JsonRecord Settings>
Settings LayoutSettings(const SequenceRequest& request) {
  return FromJson<Settings>(request.layout, "layout settings");
}

}  // namespace cvo
