// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/files/json/json_record.h"
#include "experiments/datasets/sequence.h"

namespace cvo {

// How a data set lays out the files of a sequence. layouts/my_set.cc defines
// `SequenceLayout MySetLayout()` and needs no other entry anywhere.
struct SequenceLayout {
  std::string type;   // what --type names
  std::string shape;  // the files it is known by, for messages
  // Whether a folder is one of it, complete or not. No two layouts know the same folder.
  bool (*knows)(const std::filesystem::path& folder);
  // Whether it has images of both cameras: FindSequences leaves out others.
  bool (*has_images)(const std::filesystem::path& folder);
  Sequence (*read)(const SequenceRequest& request);
  // Every key of SequenceRequest::layout that it takes, with its default.
  Json settings = Json::object();
};

// All of them, by type.
const std::vector<SequenceLayout>& SequenceLayouts();

// SequenceRequest::layout, whose keys have been checked, as a layout's record of settings.
template <JsonRecord Settings>
Settings LayoutSettings(const SequenceRequest& request) {
  return FromJson<Settings>(request.layout, "layout settings");
}

}  // namespace cvo
