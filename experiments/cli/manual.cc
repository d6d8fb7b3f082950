// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>
#include <string>

#include "core/base/error.h"
#include "experiments/cli/command.h"
#include "experiments/cli/completion.h"

namespace cvo {
namespace {

// Escapes text for troff.
std::string Troff(const std::string& text) {
  std::string escaped;
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '.' || c == '\'')) escaped += "\\&";
    escaped += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
    begins = c == '\n';
  }
  return escaped;
}

std::string ManPage(const CLI::App& program) {
  std::string page = ".TH CLUSTERVO 1\n.SH NAME\nclustervo \\- " + Troff(program.get_description());
  page += "\n.SH COMMANDS\n";
  ForEachCommand("clustervo", program, [&](const std::string& path, const CLI::App& app) {
    page += StrCat(".SS ", Troff(path), "\n", Troff(app.get_description()), "\n");
    for (const CLI::Option* option : app.get_options()) {
      page += StrCat(".TP\n.B ", Troff(option->get_name(option->get_positional())), " ",
                     Troff(option->get_type_name()), "\n", Troff(option->get_description()), "\n");
    }
    if (!app.get_footer().empty()) page += ".PP\n.nf\n" + Troff(app.get_footer()) + "\n.fi\n";
  });
  return page;
}

}  // namespace

Command AddManualCommand(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("manual", "Print the man page or a shell completion script");
  app->group("");  // hidden from help
  const auto what = std::make_shared<std::string>();
  app->add_option("WHAT", *what, "man, bash, zsh or fish")
      ->type_name("")
      ->required()
      ->check(OneOf({"man", "bash", "zsh", "fish"}));
  app->footer(
      "`cmake --install` installs all of them in the standard places.\n"
      "Examples:\n"
      "  clustervo manual man > ~/.local/share/man/man1/clustervo.1\n"
      "  eval \"$(clustervo manual bash)\"      # in ~/.bashrc\n"
      "  eval \"$(clustervo manual zsh)\"       # in ~/.zshrc, after compinit\n"
      "  clustervo manual fish > ~/.config/fish/completions/clustervo.fish");
  return {app, [&program, what] {
            std::cout << (*what == "man"    ? ManPage(program)
                          : *what == "fish" ? FishCompletion(program)
                          : *what == "zsh"  ? ZshCompletion(program)
                                            : BashCompletion(program));
            return 0;
          }};
}

}  // namespace cvo
