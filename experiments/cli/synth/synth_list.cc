// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <variant>

#include "core/base/error.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/text_table.h"
#include "synth/family/family.h"
#include "synth/scene/description.h"
#include "synth/scene/shipped_scenes.h"

namespace cvo {
namespace {

// Whether a body moves. Parked cars are on a route with speed 0.
bool Moves(const synth::PathDescription& path) {
  if (const auto* route = std::get_if<synth::RouteDescription>(&path)) {
    return std::any_of(route->speed.begin(), route->speed.end(),
                       [](const auto& knot) { return knot.speed_mps > 0.0; });
  }
  return std::holds_alternative<synth::SwingDescription>(path);
}

std::ptrdiff_t CountMovers(const synth::SceneParts& parts) {
  return std::count_if(parts.objects.begin(), parts.objects.end(),
                       [](const synth::ObjectDescription& object) { return Moves(object.path); });
}

int List() {
  TextTable table({"scene", "frames", "rate", "size", "movers", "about"});
  for (const synth::ShippedScene& shipped : synth::ShippedScenes()) {
    const auto scene = synth::SceneDescription::Load(shipped.name, {});
    const synth::SceneParts& parts = scene.parts();
    table.Add({scene.name(), std::to_string(parts.frames), ReadableNumber(parts.rate_hz) + " Hz",
               StrCat(parts.rig.width_px, "x", parts.rig.height_px),
               std::to_string(CountMovers(parts)), scene.about()});
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

}  // namespace

Command AddSynthListCommand(CLI::App& synth) {
  return {synth.add_subcommand("list", "List the shipped scenes and families of scenes"), List};
}

}  // namespace cvo
