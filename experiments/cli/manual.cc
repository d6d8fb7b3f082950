// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/manual.h"

#include <functional>
#include <iostream>
#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/cli/command.h"

namespace cvo {
namespace {

std::vector<const CLI::App*> CommandsBelow(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

using VisitApp = std::function<void(const std::string& path, const CLI::App& app)>;

// Every command with the words that lead to it, "clustervo experiment run".
void ForEachCommand(const std::string& path, const CLI::App& app, const VisitApp& visit) {
  visit(path, app);
  for (const CLI::App* below : CommandsBelow(app)) {
    ForEachCommand(path + " " + below->get_name(), *below, visit);
  }
}

// Names of commands below, and flags.
std::string WordsAfter(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::App* below : CommandsBelow(app)) {
    words.push_back(below->get_name());
  }
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  return Joined(words, " ");
}

// With `before` in front of each of these characters.
std::string Escaped(const std::string& text, const std::string& special,
                    const std::string& before) {
  std::string escaped;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) escaped += before;
    escaped += c;
  }
  return escaped;
}

// Text of a line of troff.
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

}  // namespace

std::string BashCompletion(const CLI::App& program) {
  std::string cases;
  ForEachCommand("clustervo", program, [&](const std::string& path, const CLI::App& app) {
    cases += StrCat("    '", path, "') words='", WordsAfter(app), "' ;;\n");
  });
  return StrCat(
      "# Completion of clustervo for bash and zsh.\n"
      "[ -n \"$ZSH_VERSION\" ] && autoload -U +X bashcompinit && bashcompinit\n"
      "_clustervo() {\n"
      "  local current=${COMP_WORDS[COMP_CWORD]} path=clustervo words= i\n"
      "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
      "    case \"$path ${COMP_WORDS[i]}\" in\n      ",
      [&] {
        std::vector<std::string> paths;
        ForEachCommand("clustervo", program, [&](const std::string& path, const CLI::App&) {
          if (path != "clustervo") paths.push_back("'" + path + "'");
        });
        return Joined(paths, "|");
      }(),
      ") path=\"$path ${COMP_WORDS[i]}\" ;;\n"
      "    esac\n"
      "  done\n"
      "  case \"$path\" in\n",
      cases,
      "  esac\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
      "  [ ${#COMPREPLY[@]} -gt 0 ] || COMPREPLY=($(compgen -f -- \"$current\"))\n"
      "}\n"
      "complete -o filenames -F _clustervo clustervo\n");
}

std::string FishCompletion(const CLI::App& program) {
  std::string lines = "# Completion of clustervo for fish.\n";
  ForEachCommand("clustervo", program, [&](const std::string& path, const CLI::App& app) {
    const std::string inside = path == "clustervo"
                                   ? "__fish_use_subcommand"
                                   : "__fish_seen_subcommand_from " + app.get_name();
    const auto add = [&](const std::string& what, const std::string& about) {
      lines += StrCat("complete -c clustervo -n '", inside, "' ", what, " -d '",
                      Escaped(about, "'\\", "\\"), "'\n");
    };
    for (const CLI::App* below : CommandsBelow(app)) {
      add("-a " + below->get_name(), below->get_description());
    }
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) {
        add("-l " + name, option->get_description());
      }
    }
  });
  return lines;
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

Command AddManualCommand(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "manual", "Print the man page, or the completion of commands and flags for a shell");
  const auto what = std::make_shared<std::string>();
  app->add_option("WHAT", *what, "man, bash, zsh or fish")
      ->type_name("")
      ->required()
      ->check(CLI::IsMember({"man", "bash", "zsh", "fish"}).description(""));
  app->footer(
      "Examples:\n"
      "  clustervo manual man > ~/.local/share/man/man1/clustervo.1\n"
      "  eval \"$(clustervo manual bash)\"      # in ~/.bashrc; zsh in ~/.zshrc\n"
      "  clustervo manual fish > ~/.config/fish/completions/clustervo.fish");
  return {app, [&program, what] {
            std::cout << (*what == "man"    ? ManPage(program)
                          : *what == "fish" ? FishCompletion(program)
                                            : BashCompletion(program));
            return 0;
          }};
}

}  // namespace cvo
