// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/text_table.h"
#include "synth/diversity/diversity.h"

namespace cvo {
namespace {

// Returns "room" for "room_17". Any other scene is a family of its own.
std::string FamilyOf(const std::filesystem::path& folder) {
  const std::string name = ReadJson(folder / "scene.json").value("name", "");
  const std::size_t mark = name.find_last_not_of("0123456789");
  const bool numbered = mark != std::string::npos && mark + 1 < name.size() && name[mark] == '_';
  return numbered ? name.substr(0, mark) : name;
}

std::string Spread(const std::vector<double>& values) {
  if (values.empty()) return "-";
  return StrCat(ReadableNumber(synth::Quantile(values, 0.1)), " / ",
                ReadableNumber(synth::Quantile(values, 0.5)), " / ",
                ReadableNumber(synth::Quantile(values, 0.9)));
}

int PrintDiversity(const std::vector<std::string>& folders) {
  std::map<std::string, synth::Diversity> families;
  for (const std::string& folder : folders) synth::AddSequence(folder, families[FamilyOf(folder)]);
  TextTable table({"family", "scenes", "bodies", "speed [m/s]", "height [px]", "visible [s]",
                   "hidden [s]", "contrast [grey]", "disparity [px]", "moving [1]"});
  for (const auto& [name, found] : families) {
    table.Add({name, std::to_string(found.scenes), std::to_string(found.size_px.size()),
               Spread(found.speed_mps), Spread(found.size_px), Spread(found.visible_s),
               Spread(found.hidden_s), Spread(found.contrast), Spread(found.disparity_px),
               Spread(found.moving_part)});
  }
  table.Print(std::cout);
  return 0;
}

}  // namespace

Command AddSynthDiversityCommand(CLI::App& synth) {
  CLI::App* app = synth.add_subcommand("diversity",
                                       "Show how the bodies of rendered sequences vary: 10 % / "
                                       "median / 90 % quantiles by family; moving: of the "
                                       "pixels of a frame, those on bodies that move");
  const auto folders = std::make_shared<std::vector<std::string>>();
  app->add_option("DIR", *folders, "folders of rendered sequences")->type_name("")->required();
  app->footer("Example: clustervo synth diversity room_0 room_1 street_0");
  return {app, [folders] { return PrintDiversity(*folders); }};
}

}  // namespace cvo
