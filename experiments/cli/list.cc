// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo list: what the program knows by name.
#include <algorithm>
#include <iostream>
#include <memory>
#include <variant>

#include "core/base/error.h"
#include "core/files/json/options_json.h"
#include "core/interface/options.h"
#include "core/record/metric_catalogue.h"
#include "experiments/cli/command.h"
#include "experiments/suite/suite.h"
#include "synth/family/family.h"
#include "synth/scene/description.h"
#include "variants/registry.h"

namespace cvo {
namespace {

int ListVariants() {
  TextTable table({"name", "changes"});
  for (const VariantInfo& variant : Variants()) {
    table.Add({std::string(variant.name), std::string(variant.changes)});
  }
  table.Print(std::cout);
  return 0;
}

std::string Range(const OptionLeaf& leaf) {
  if (std::holds_alternative<bool*>(leaf.value)) return "true, false";
  return StrCat("[", leaf.info.min, ", ", leaf.info.max, "]");
}

std::string DefaultText(const OptionLeaf& leaf) {
  std::string text = DumpJson(ValueToJson(leaf));
  text.pop_back();  // the newline
  return text;
}

int ListOptions() {
  Options options;
  const std::vector<OptionLeaf> leaves = OptionLeaves(options);
  TextTable table({"option", "default", "unit", "range"});
  for (const OptionLeaf& leaf : leaves) {
    table.Add({leaf.path, DefaultText(leaf), leaf.info.unit, Range(leaf)});
  }
  const std::vector<std::string> lines = table.Lines();
  std::cout << lines.front() << '\n';
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    std::cout << lines[i + 1] << "\n    " << leaves[i].info.meaning << "  ["
              << leaves[i].info.source << "]\n";
  }
  return 0;
}

int ListSuites() {
  TextTable table({"suite", "split", "jobs", "about"});
  for (const ShippedSuite& shipped : ShippedSuites()) {
    // Skips the checks of suites, which would build every scene.
    const Suite suite = ReadCheckedSuite(ParseJson(shipped.text, shipped.name), shipped.name);
    table.Add({suite.name, SplitOf(suite), StrCat(ExpandSuite(suite).size()), suite.about});
  }
  table.Print(std::cout);
  return 0;
}

int ListScenes() {
  TextTable table({"scene", "frames", "rate", "size", "about"});
  for (const synth::ShippedScene& shipped : synth::ShippedScenes()) {
    const auto scene = synth::SceneDescription::Load(shipped.name, {});
    const synth::SceneParts& parts = scene.parts();
    table.Add({scene.name(), std::to_string(parts.frames), ReadableNumber(parts.rate_hz) + " Hz",
               StrCat(parts.rig.width_px, "x", parts.rig.height_px), scene.about()});
  }
  table.Print(std::cout);
  std::cout << '\n';
  TextTable families({"family", "knobs", "about"});
  for (const synth::ShippedFamily& shipped : synth::ShippedFamilies()) {
    const synth::Family family = synth::LoadFamily(shipped.name);
    families.Add({family.name, std::to_string(family.knobs.size()), family.about});
  }
  families.Print(std::cout);
  return 0;
}

int ListKnobs(const std::string& name) {
  const synth::Family family = LoadNamed(name, [&] { return synth::LoadFamily(name); });
  TextTable table({"knob", "unit", "drawn from", "may be set to", "about"});
  for (const synth::Knob& knob : family.knobs) {
    table.Add({knob.name, knob.unit, knob.draw.dump(), Json(knob.may).dump(),
               knob.about + (knob.per_body ? " (drawn for each body)" : "")});
  }
  table.Print(std::cout);
  return 0;
}

int ListMetrics() {
  TextTable table({"name", "unit", "higher_is_better", "meaning"});
  for (const std::string& name : reports::AllMetricNames()) {
    const reports::MetricEntry* entry = reports::FindEntry(name);
    table.Add(
        {name, NameOf(entry->unit), entry->higher_is_better() ? "true" : "false", entry->meaning});
  }
  table.Print(std::cout);
  return 0;
}

int List(const std::string& what, const std::string& family) {
  if (!family.empty() && what != "scenes") throw UsageError("FAMILY: applies to scenes");
  if (what == "variants") return ListVariants();
  if (what == "options") return ListOptions();
  if (what == "metrics") return ListMetrics();
  if (what == "suites") return ListSuites();
  return family.empty() ? ListScenes() : ListKnobs(family);
}

}  // namespace

Command AddListCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "list", "List variants, options, metrics, suites, or scenes and families of scenes");
  const FlagAdder add{*app};
  const auto what = std::make_shared<std::string>();
  const auto family = std::make_shared<std::string>();
  add("WHAT", *what, "", "variants, options, metrics, suites or scenes")
      ->required()
      ->check(OneOf({"variants", "options", "metrics", "suites", "scenes"}));
  add("FAMILY", *family, "", "with scenes: a family or a JSON file, of which to list the knobs");
  app->footer(
      "Change options with clustervo run ... --set window.spatial=5, or with --config FILE.json:\n"
      "  {\"window\": {\"spatial\": 5}}");
  return {app, [what, family] { return List(*what, *family); }};
}

}  // namespace cvo
