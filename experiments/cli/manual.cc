// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// clustervo manual: the man page and completions of shells.
#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "experiments/cli/command.h"

namespace cvo {
namespace {

// Commands below this one that help lists.
std::vector<const CLI::App*> CommandsBelow(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* below) { return !below->get_group().empty(); });
}

using VisitApp = std::function<void(const std::string& path, const CLI::App& app)>;

// Visits `app` and every command below it, with the words that lead to it, such as "clustervo
// experiment run".
void ForEachCommand(const std::string& path, const CLI::App& app, const VisitApp& visit) {
  visit(path, app);
  for (const CLI::App* below : CommandsBelow(app)) {
    ForEachCommand(path + " " + below->get_name(), *below, visit);
  }
}

// Names of the subcommands and flags of a command, separated by spaces.
std::string WordsAfter(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::App* below : CommandsBelow(app)) words.push_back(below->get_name());
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  }
  return Joined(words, " ");
}

// All commands except the program itself, in quotes.
std::string QuotedCommands(const CLI::App& program, const char* separator) {
  std::vector<std::string> paths;
  ForEachCommand("clustervo", program, [&](const std::string& path, const CLI::App&) {
    if (path != "clustervo") paths.push_back("'" + path + "'");
  });
  return Joined(paths, separator);
}

// Bash and zsh code that sets `offered` to the words that may follow the words `before`.
std::string FindOffered(const CLI::App& program, const std::string& before) {
  std::string cases;
  ForEachCommand("clustervo", program, [&](const std::string& path, const CLI::App& app) {
    cases += StrCat("    '", path, "') offered='", WordsAfter(app), "' ;;\n");
  });
  return StrCat("  local command=clustervo offered= word\n  for word in ", before,
                "; do\n    case \"$command $word\" in\n      ", QuotedCommands(program, "|"),
                ") command=\"$command $word\" ;;\n    esac\n  done\n  case \"$command\" in\n",
                cases, "  esac\n");
}

// Escapes text for a quoted string of fish.
std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\'' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

// Completion scripts, generated from the same data as --help so that no command or flag is missing.
std::string BashCompletion(const CLI::App& program) {
  return StrCat(
      "# Completion of clustervo for bash.\n_clustervo() {\n",
      FindOffered(program, "\"${COMP_WORDS[@]:1:COMP_CWORD-1}\""),
      "  local current=${COMP_WORDS[COMP_CWORD]}\n"
      "  COMPREPLY=($(compgen -W \"$offered\" -- \"$current\"))\n"
      "  [ ${#COMPREPLY[@]} -gt 0 ] || mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
      "}\n"
      "complete -o filenames -F _clustervo clustervo\n");
}

std::string ZshCompletion(const CLI::App& program) {
  return StrCat("#compdef clustervo\n_clustervo() {\n",
                FindOffered(program, "${words[2,CURRENT-1]}"),
                "  compadd -- ${=offered}\n  _files\n}\n"
                "# Loaded by zsh at the first completion, or read with eval.\n"
                "if [ \"$funcstack[1]\" = _clustervo ]; then\n  _clustervo \"$@\"\nelse\n"
                "  compdef _clustervo clustervo\nfi\n");
}

std::string FishCompletion(const CLI::App& program) {
  std::string lines = StrCat(
      "# Completion of clustervo for fish.\n"
      "function __clustervo_is_at\n  set -l command clustervo\n"
      "  set -l words (commandline -opc)\n"
      "  for word in $words[2..-1]\n    switch \"$command $word\"\n      case ",
      QuotedCommands(program, " "),
      "\n        set command \"$command $word\"\n    end\n  end\n"
      "  test \"$command\" = \"$argv\"\nend\n");
  ForEachCommand("clustervo", program, [&](const std::string& path, const CLI::App& app) {
    const auto add = [&](const std::string& what, const std::string& about) {
      lines += StrCat("complete -c clustervo -n '__clustervo_is_at ", path, "' ", what, " -d '",
                      Escaped(about), "'\n");
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
