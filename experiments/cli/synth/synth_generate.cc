// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "core/files/json/json.h"
#include "experiments/cli/command.h"
#include "experiments/cli/output_file.h"
#include "experiments/cli/run/known_names.h"
#include "experiments/cli/run/text_table.h"
#include "synth/family/generate.h"

namespace cvo {
namespace {

struct GenerateFlags {
  std::string family;
  std::string seed;
  std::vector<std::string> set;
  std::string output;
  bool knobs = false;
};

int PrintKnobs(const synth::Family& family) {
  TextTable table({"knob", "unit", "drawn from", "may be set to", "about"});
  for (const synth::Knob& knob : family.knobs) {
    table.Add({knob.name, knob.unit, knob.draw.dump(), Json(knob.may).dump(),
               knob.about + (knob.per_body ? " (drawn for each body)" : "")});
  }
  table.Print(std::cout);
  return 0;
}

int Generate(const GenerateFlags& flags) {
  const auto family = LoadNamed(flags.family, [&] { return synth::LoadFamily(flags.family); });
  if (flags.knobs) return PrintKnobs(family);
  if (flags.seed.empty() || flags.output.empty()) {
    throw UsageError("--seed and --output are required, unless --knobs is given");
  }
  CheckOutputFile(flags.output, {flags.family});
  const Json scene = LoadNamed(flags.family, [&] {
    return synth::GenerateScene(family, synth::ParseFamilySeed(flags.seed), flags.set);
  });
  WriteOutputFile(flags.output, DumpJson(scene), {flags.family});
  std::cout << "written: " << flags.output << '\n';
  return 0;
}

}  // namespace

Command AddSynthGenerateCommand(CLI::App& synth) {
  CLI::App* app = synth.add_subcommand("generate", "Write the scene file of one seed of a family");
  const auto flags = std::make_shared<GenerateFlags>();
  app->add_option("FAMILY", flags->family, "a family (clustervo synth list) or a JSON file")
      ->type_name("")
      ->required();
  app->add_option("--seed", flags->seed,
                  "seed of the scene; 0 to 999: development, 1000 to 1999: test split, for "
                  "reporting only, 2000 and above: no split")
      ->type_name("N");
  app->add_option("--set", flags->set, "set one parameter (knob); can be repeated")
      ->type_name("KNOB=VALUE")
      ->allow_extra_args(false);
  app->add_option("-o,--output", flags->output, "scene file to write")->type_name("FILE");
  app->add_flag("--knobs", flags->knobs, "only list the parameters (knobs) of the family");
  app->footer(
      "The same seed and knobs give byte-identical files on every machine. A scene of a family "
      "can\nalso be given by name, without a file: clustervo synth render room@17 -o room_17.\n"
      "Example: clustervo synth generate room --seed 17 --set movers=3 -o room_17.json");
  return {app, [flags] { return Generate(*flags); }};
}

}  // namespace cvo
