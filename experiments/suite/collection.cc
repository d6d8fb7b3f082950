// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/collection.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "experiments/suite/shipped/shipped_suites.h"
#include "synth/scene/object_reader.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using synth::ObjectReader;

std::vector<std::string> Texts(const Json& value, const std::string& where) {
  const auto is_text = [](const Json& element) { return element.is_string(); };
  if (!value.is_array() || !std::all_of(value.begin(), value.end(), is_text)) {
    ThrowError(where, value.dump(), "a list of texts");
  }
  return value.get<std::vector<std::string>>();
}

CollectionFigure ReadFigure(ObjectReader object) {
  CollectionFigure figure;
  figure.suite = object.Text("suite");
  figure.sequence = object.Text("sequence");
  figure.variants = object.TextOr("variants", "full");
  for (const double frame : object.Numbers("frames", {0.0, 1e6}, {1, 2, 3, 4})) {
    figure.frames.push_back(static_cast<int>(frame));
  }
  object.Finish();
  return figure;
}

void ReadRows(ObjectReader& object, CollectionSection& section) {
  section.columns = Texts(object.Value("columns"), object.Where("columns"));
  for (const Json& row : object.Value("rows")) {
    section.rows.push_back(Texts(row, object.Where("rows")));
    if (section.rows.back().size() == section.columns.size()) continue;
    ThrowError(object.Where("rows"), StrCat(section.rows.back().size(), " cells"),
               StrCat(section.columns.size(), ", one per column"));
  }
  if (!object.Has("measured")) return;
  for (const auto& [variant, cells] : object.Value("measured").items()) {
    section.measured.emplace_back(variant, Texts(cells, object.Where("measured")));
    if (section.measured.back().second.size() + 1 == section.columns.size()) continue;
    ThrowError(object.Where("measured"), StrCat(section.measured.back().second.size(), " cells"),
               StrCat(section.columns.size() - 1, ", all columns but the last"));
  }
}

// Resolves a suite file relative to the collection's folder; other names stay as they are.
std::string SuitePath(const std::string& suite, const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / suite, ignored) ? (folder / suite).string() : suite;
}

CollectionSection ReadSection(ObjectReader object, const fs::path& folder) {
  CollectionSection section;
  section.title = object.Text("title");
  section.suite = SuitePath(object.TextOr("suite", ""), folder);
  if (object.Has("text")) section.text = Texts(object.Value("text"), object.Where("text"));
  section.data = object.TextOr("data", "");
  section.times = object.BoolOr("times", false);
  if (object.Has("columns")) ReadRows(object, section);
  for (ObjectReader& figure : object.ObjectsOr("figures")) {
    section.figures.push_back(ReadFigure(std::move(figure)));
  }
  object.Finish();
  return section;
}

Collection ReadCollection(const Json& json, const std::string& where, const fs::path& folder) {
  ObjectReader object(json, where, "");
  Collection collection;
  collection.name = object.Text("name");
  collection.about = object.TextOr("about", "");
  for (ObjectReader& section : object.ObjectsOr("sections")) {
    collection.sections.push_back(ReadSection(std::move(section), folder));
  }
  object.Finish();
  if (collection.sections.empty()) ThrowError(where + ", sections", "none", "at least one");
  return collection;
}

}  // namespace

std::vector<std::string> CollectionNames() {
  std::vector<std::string> names;
  for (const ShippedSuite& shipped : ShippedCollections()) names.push_back(shipped.name);
  return names;
}

std::optional<Collection> FindCollection(const std::string& name) {
  for (const ShippedSuite& shipped : ShippedCollections()) {
    if (shipped.name == name) return ReadCollection(ParseJson(shipped.text, name), name, {});
  }
  std::error_code ignored;
  if (!fs::is_regular_file(name, ignored)) return std::nullopt;
  const Json json = ReadJson(name);
  if (!json.is_object() || !json.contains("sections")) return std::nullopt;
  return ReadCollection(json, name, fs::absolute(name).parent_path());
}

std::string SuiteFolderName(const std::string& suite) { return fs::path(suite).stem().string(); }

}  // namespace cvo
