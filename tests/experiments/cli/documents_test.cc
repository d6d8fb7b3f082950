// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

#include "core/files/text_file.h"
#include "tests/experiments/cli/process.h"
#include "tests/support/temp_folder.h"

namespace cvo::documents_test {
namespace {

namespace fs = std::filesystem;
using Words = test::Arguments;
using test::RunProgram;
using testing::HasSubstr;

// Commands, flags, make targets and suites in the documents must exist.

const fs::path kSource = CVO_SOURCE_DIR;

std::vector<fs::path> Documents() {
  std::vector<fs::path> documents = {kSource / "README.md", kSource / "CONTRIBUTING.md"};
  for (const char* folder : {"core", "variants", "experiments", "synth", "reports", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kSource / folder)) {
      if (entry.path().extension() == ".md") documents.push_back(entry.path());
    }
  }
  return documents;
}

struct Block {
  std::string language;
  std::string text;
};

std::vector<Block> BlocksOf(const fs::path& document) {
  std::vector<Block> blocks;
  std::istringstream lines(ReadFileBytes(document));
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.push_back({line.substr(3), ""});
    } else if (inside) {
      blocks.back().text += line + "\n";
    }
  }
  return blocks;
}

// Returns the words of every command in the shell blocks of the document: comments are removed,
// lines that end in a backslash are joined, and each part of a pipe is a command.
std::vector<Words> CommandsOf(const fs::path& document) {
  std::vector<Words> commands;
  for (const Block& block : BlocksOf(document)) {
    if (block.language != "sh") continue;
    std::string text = std::regex_replace(block.text, std::regex(R"(\\\n)"), " ");
    text = std::regex_replace(text, std::regex(R"( #[^\n]*)"), "");
    text = std::regex_replace(text, std::regex(R"(\||&&|;)"), "\n");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream stream(line);
      Words words{std::istream_iterator<std::string>(stream), {}};
      if (!words.empty()) commands.push_back(std::move(words));
    }
  }
  return commands;
}

const std::string& HelpOf(const Words& command) {
  static std::map<Words, std::string> known;
  const auto [at, is_new] = known.try_emplace(command);
  if (is_new) {
    Words arguments = command;
    arguments.emplace_back("--help");
    at->second = RunProgram(arguments).out;
  }
  return at->second;
}

bool IsSubcommand(const Words& command, const std::string& word) {
  const std::string& help = HelpOf(command);
  const std::size_t list = help.find("Subcommands:");
  return list != std::string::npos &&
         std::regex_search(help.substr(list), std::regex("\n  " + word + " "));
}

// Returns what is wrong with a command line that starts with `clustervo`. Empty if nothing is.
std::string Problem(const Words& words) {
  Words command;
  std::size_t next = 1;
  static const std::regex is_name("[a-z_]+");
  while (next < words.size() && std::regex_match(words[next], is_name) &&
         IsSubcommand(command, words[next])) {
    command.push_back(words[next++]);
  }
  if (HelpOf(command).find("Subcommands:") != std::string::npos && next < words.size() &&
      words[next][0] != '-') {
    return "no command " + words[next];
  }
  for (; next < words.size(); ++next) {
    if (words[next][0] != '-' || words[next] == "-") continue;
    const std::string flag = words[next].substr(0, words[next].find('='));
    const std::regex listed("(^|[\\s,])" + flag + "($|[\\s,])");
    if (!std::regex_search(HelpOf(command), listed)) return "no flag " + flag;
  }
  return "";
}

TEST(Documents, CommandsAndTheirFlagsExist) {
  int seen = 0;
  for (const fs::path& document : Documents()) {
    for (const Words& words : CommandsOf(document)) {
      if (fs::path(words[0]).filename() != "clustervo") continue;
      ++seen;
      EXPECT_EQ(Problem(words), "") << document << ": " << testing::PrintToString(words);
    }
  }
  EXPECT_GT(seen, 25);
}

TEST(Documents, AWrongCommandIsDetected) {
  EXPECT_EQ(Problem({"clustervo", "runs", "x"}), "no command runs");
  EXPECT_EQ(Problem({"clustervo", "synth", "draw"}), "no command draw");
  EXPECT_EQ(Problem({"clustervo", "run", "x", "--seeds", "3"}), "no flag --seeds");
  EXPECT_EQ(Problem({"clustervo", "run", "x", "-o", "y", "--seed=3"}), "");
}

TEST(Documents, TargetsOfMakeExist) {
  const std::string makefile = ReadFileBytes(kSource / "Makefile");
  int seen = 0;
  for (const fs::path& document : Documents()) {
    for (const Words& words : CommandsOf(document)) {
      if (words[0] != "make" || words.size() < 2) continue;
      ++seen;
      EXPECT_THAT(makefile, HasSubstr("\n" + words[1] + ":")) << document;
    }
  }
  EXPECT_GT(seen, 5);
}

TEST(Documents, TestsOfPromisesExist) {
  std::string tests;
  for (const auto& entry : fs::recursive_directory_iterator(kSource / "tests")) {
    if (entry.path().extension() == ".cc") tests += ReadFileBytes(entry.path());
  }
  const std::string text = ReadFileBytes(kSource / "experiments" / "README.md");
  const std::regex named(R"(`(\w+)\.([A-Z]\w+)`)");
  int seen = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), named), end; at != end; ++at, ++seen) {
    EXPECT_THAT(tests, HasSubstr((*at)[1].str() + ", " + (*at)[2].str() + ")"));
  }
  EXPECT_GT(seen, 8);
}

TEST(Documents, SuitesCanBePlanned) {
  const test::TempFolder folder;
  int suites = 0;
  for (const fs::path& document : Documents()) {
    for (const Block& block : BlocksOf(document)) {
      if (block.language != "json") continue;
      ++suites;
      const fs::path file = folder.Write("suite.json", block.text);
      const test::ProcessResult result =
          RunProgram({"experiment", "run", file.string(), "-o", (folder.path() / "out").string(),
                      "--data", folder.path().string(), "--dry-run"});
      EXPECT_EQ(result.exit_code, 0) << document << "\n" << result.err;
    }
  }
  EXPECT_GT(suites, 0);
}

}  // namespace
}  // namespace cvo::documents_test
