// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "core/files/json/json.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/text_table.h"
#include "variants/registry.h"

namespace cvo {
namespace {

int ListVariants(bool json) {
  if (json) {
    Json list = Json::array();
    for (const VariantInfo& variant : Variants()) {
      list.push_back({{"name", variant.name}, {"changes", variant.changes}});
    }
    std::cout << DumpJson(list);
    return 0;
  }
  TextTable table({"variant", "description"});
  for (const VariantInfo& variant : Variants()) {
    table.Add({std::string(variant.name), std::string(variant.changes)});
  }
  table.Print(std::cout);
  return 0;
}

}  // namespace

Command AddVariantsCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand("variants", "List the available estimator variants");
  const auto json = std::make_shared<bool>(false);
  app->add_flag("--json", *json, "print JSON");
  return {app, [json] { return ListVariants(*json); }};
}

}  // namespace cvo
