// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/command.h"

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/text/closest_names.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/cli/output_file.h"
#include "experiments/runner/identity.h"

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

CLI::Validator OneOf(std::vector<std::string> names) {
  return {[names = std::move(names)](const std::string& text) -> std::string {
            if (std::find(names.begin(), names.end(), text) != names.end()) return "";
            return StrCat("found ", Quoted(text), DidYouMean(text, names), ", expected one of ",
                          Joined(names, ", "));
          },
          ""};
}

void RefuseFlags(const CLI::App& app, const std::vector<std::string>& flags,
                 const std::string& why) {
  for (const std::string& flag : flags) {
    const CLI::Option* option = app.get_option_no_throw(flag);
    if (option != nullptr && option->count() > 0) throw UsageError(StrCat(flag, ": ", why));
  }
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
