// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/suite/suite_flags.h"

#include <cstdlib>

#include "experiments/suite/parse_suite.h"
#include "synth/write/render_cache.h"

namespace cvo {

void SuiteFlags::AddTo(CLI::App& app) {
  app.add_option("SUITE", suite, "a shipped suite (clustervo experiment list) or a suite file")
      ->type_name("")
      ->required();
  app.add_option("-o,--output", output, "output folder of the suite")->type_name("DIR")->required();
  app.add_option("--data", data, "root folder of the real sequences; default: CLUSTERVO_DATA")
      ->type_name("FOLDER");
  app.add_option("--seeds", overrides.seeds, "use seeds 1 to N instead of the suite's")
      ->type_name("N")
      ->check(CLI::Range(1, 10000).description(""));
  app.add_option("--frames", overrides.frames,
                 "use frames A to B-1 of every sequence instead of the suite's")
      ->type_name("A:B");
  app.add_option("--set", overrides.set,
                 "set an option (see clustervo options), an axis of the suite's grid, or, with the "
                 "prefix scene., a value of all scenes; can be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
}

Suite SuiteFlags::Load() const { return Override(LoadSuite(suite), overrides); }

PlanRequest SuiteFlags::Request() const {
  PlanRequest request;
  const char* variable = std::getenv("CLUSTERVO_DATA");
  request.data = !data.empty() ? data : variable == nullptr ? "" : variable;
  request.cache = synth::CacheFolder();
  return request;
}

}  // namespace cvo
