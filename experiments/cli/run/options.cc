// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/interface/options.h"

#include <iostream>
#include <memory>
#include <vector>

#include "core/files/json/options_json.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/text_table.h"

namespace cvo {
namespace {

std::string Range(const OptionLeaf& leaf) {
  if (std::holds_alternative<bool*>(leaf.value)) return "true, false";
  return StrCat("[", leaf.info.min, ", ", leaf.info.max, "]");
}

std::string DefaultText(const OptionLeaf& leaf) {
  std::string text = DumpJson(ValueToJson(leaf));
  text.pop_back();  // the newline
  return text;
}

Json LeafToJson(const OptionLeaf& leaf) {
  return {{"path", leaf.path},
          {"type", TypeName(leaf)},
          {"unit", leaf.info.unit},
          {"min", leaf.info.min},
          {"max", leaf.info.max},
          {"default", ValueToJson(leaf)},
          {"meaning", leaf.info.meaning},
          {"source", leaf.info.source}};
}

int ListOptions(bool json) {
  Options options;
  const std::vector<OptionLeaf> leaves = OptionLeaves(options);
  if (json) {
    Json list = Json::array();
    for (const OptionLeaf& leaf : leaves) list.push_back(LeafToJson(leaf));
    std::cout << DumpJson(list);
    return 0;
  }
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

}  // namespace

Command AddOptionsCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "options", "List the estimator's options: default, unit, range, meaning, source");
  const auto json = std::make_shared<bool>(false);
  app->add_flag("--json", *json, "print JSON");
  app->footer(
      "Change them with clustervo run ... --set window.spatial=5, or with --config FILE.json:\n"
      "  {\"window\": {\"spatial\": 5}}");
  return {app, [json] { return ListOptions(*json); }};
}

}  // namespace cvo
