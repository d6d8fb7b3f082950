// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/command.h"

#include <optional>

#include "core/base/error.h"
#include "core/files/number.h"
#include "experiments/record/build_identity.h"

namespace cvo {

Command Group(CLI::App& app, std::vector<Command> commands) {
  app.require_subcommand(1);
  return {&app, [commands = std::move(commands)] {
            for (const Command& command : commands) {
              if (command.app->parsed()) return command.run();
            }
            return 0;
          }};
}

std::string FiniteProblem(const std::string& text) {
  const std::optional<double> number = ParseDouble(text);
  return number ? "" : StrCat("found '", text, "', expected a finite number");
}

std::string VersionText() {
  const BuildIdentity& build = ThisBuild();
  return StrCat("clustervo ", build.version, "\nbuild      ", build.identity, "\nestimator  ",
                build.estimator_sources, "\nevaluation ", build.evaluation_sources, "\ncommit     ",
                build.commit, "\ncompiler   ", build.compiler, ", ", build.build_type, ", ",
                build.flags, "\nlibraries  OpenCV ", build.libraries.opencv, ", Eigen ",
                build.libraries.eigen, "\nCPU level  ", build.cpu_level);
}

}  // namespace cvo
