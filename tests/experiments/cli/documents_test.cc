// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

#include "core/files/json/json.h"
#include "core/files/text_file.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/real_data.h"
#include "tests/support/temp_folder.h"

namespace cvo::documents_test {
namespace {

namespace fs = std::filesystem;
using Words = test::Arguments;
using test::ExpectError;
using test::ProcessResult;
using test::RunProgram;
using testing::HasSubstr;
using testing::Not;

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

TEST(Documents, SuitesCanBePlanned) {
  const test::TempFolder folder;
  int suites = 0;
  for (const fs::path& document : Documents()) {
    for (const Block& block : BlocksOf(document)) {
      if (block.language != "json") continue;
      ++suites;
      const fs::path file = folder.Write("suite.json", block.text);
      const test::ProcessResult result =
          RunProgram({"experiment", "status", file.string(), "-o", (folder.path() / "out").string(),
                      "--data", folder.path().string()});
      EXPECT_EQ(result.exit_code, 0) << document << "\n" << result.err;
    }
  }
  EXPECT_GT(suites, 0);
}

// Suites whose boxes are found by a network before the runs.

constexpr char kTinyNetwork[] = R"({"model": "tiny.cfg", "names": "two.names", "min_score": 0.3})";

class DetectorSuite : public test::CommandTest {
 protected:
  ProcessResult RunSuite(const std::string& sequences, const std::string& variants,
                         const fs::path& data) const {
    const fs::path suite = folder_.Write(
        "suite.json", StrCat(R"({"name": "found", "sequences": [)", sequences, R"(], "variants": )",
                             variants, R"(, "seeds": 1, "table": {"rows": ["variant", )",
                             R"("detections"], "metrics": ["camera_ate"]}})"));
    return Run({"experiment", "run", suite.string(), "-o", Path("out"), "-j", "1", "--data", data});
  }
  std::vector<fs::path> Boxes() const {
    std::vector<fs::path> files;
    for (const auto& file : fs::directory_iterator(folder_.path() / "cache" / "detections")) {
      if (file.path().extension() == ".txt") files.push_back(file.path());
    }
    return files;
  }
  Json Jobs() const { return ReadJson(folder_.path() / "out" / "plan.json")["jobs"]; }
};

// The network runs once for all jobs, and its boxes are kept. Other settings give other boxes.
TEST_F(DetectorSuite, BoxesAreFoundOnceAndKept) {
  test::WriteTinySequence(folder_.path() / "wall", 4);
  test::WriteTinyNetwork(folder_);
  folder_.Write("two.names", "person\ncar\n");
  const std::string sequence = StrCat(R"({"folder": "wall", "detections": )", kTinyNetwork, "}");
  const ProcessResult run = RunSuite(sequence, R"(["static"])", folder_.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("finding boxes in 1 sequence\n"));
  ASSERT_EQ(Boxes().size(), 1U);
  const std::string rows = test::ReadFile(Boxes()[0]);
  EXPECT_THAT(rows, testing::StartsWith("0 -1 Car -1 -1 -10 "));
  EXPECT_EQ(test::LineCount(rows), 4U);
  EXPECT_EQ(Jobs()[0]["detections"], "tiny");

  const ProcessResult more = RunSuite(sequence, R"(["static", "full"])", folder_.path());
  EXPECT_THAT(more.err, Not(HasSubstr("finding boxes")));
  EXPECT_EQ(more.out, "found: 2 jobs: 2 done\n") << more.err;
  const Json result =
      ReadJson(folder_.path() / "out" / "jobs" / std::string(Jobs()[1]["job"]) / "result.json");
  EXPECT_EQ(result["detection_counts"]["given"], 4);

  // Boxes that do not match their checksum, or have none, are not used.
  const fs::path checksum = Boxes()[0].string() + ".sha256";
  WriteFileBytes(Boxes()[0], rows.substr(0, rows.find('\n') + 1));
  const ProcessResult damaged = RunSuite(sequence, R"(["static"])", folder_.path());
  EXPECT_THAT(damaged.err, HasSubstr("cached boxes are damaged and will be found again"));
  EXPECT_EQ(test::ReadFile(Boxes()[0]), rows);
  fs::remove(checksum);
  EXPECT_THAT(RunSuite(sequence, R"(["static"])", folder_.path()).err,
              HasSubstr("finding boxes in 1"));
  EXPECT_TRUE(fs::exists(checksum));

  std::string stricter = sequence;
  stricter.replace(stricter.find("0.3"), 3, "0.99");
  EXPECT_EQ(RunSuite(stricter, R"(["static"])", folder_.path()).exit_code, 0);
  EXPECT_EQ(Boxes().size(), 2U);
}

TEST_F(DetectorSuite, ReportsMissingAndInvalidNetworks) {
  test::WriteTinySequence(folder_.path() / "wall", 4);
  test::WriteTinyNetwork(folder_);
  const std::string sequence = StrCat(R"({"folder": "wall", "detections": )", kTinyNetwork, "}");
  const std::string both = sequence + R"(, {"folder": "wall"})";
  // A missing network is missing input, not a failure; an invalid one is a failure.
  const ProcessResult missing = RunSuite(both, R"(["static"])", folder_.path());
  EXPECT_EQ(missing.exit_code, 0);
  EXPECT_THAT(missing.out, HasSubstr("missing input: wall: no file two.names below"));
  folder_.Write("two.names", "person\n");
  const ProcessResult wrong = RunSuite(both, R"(["static"])", folder_.path());
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_THAT(wrong.out, HasSubstr("its boxes were not found"));
  EXPECT_THAT(wrong.out, HasSubstr("found 2 classes, expected 1, as many as names"));
  ExpectError(RunSuite(R"({"folder": "wall", "detections": {"model": "tiny.cfg"}})",
                       R"(["static"])", folder_.path()),
              "sequences.0.detections.names");
}

TEST_F(DetectorSuite, RunsARealNetworkOnARealDrive) {
  const auto data = test::RealData();
  const fs::path network = "detectors/yolo-fastest-1.1-xl";
  if (!data || !fs::exists(*data / network)) GTEST_SKIP() << "CLUSTERVO_DATA has no detectors";
  const ProcessResult run = RunSuite(
      StrCat(R"({"folder": "2011_09_26_drive_0013_sync", "frames": "10:13", "detections": {)",
             R"("model": ")", (network / "yolo-fastest-1.1-xl.cfg").string(), R"(", "names": ")",
             (network / "coco.names").string(), R"(", "input": "960x320"}})"),
      R"(["full"])", *data);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  ASSERT_EQ(Boxes().size(), 1U);
  EXPECT_THAT(test::ReadFile(Boxes()[0]), testing::StartsWith("10 -1 Car "));
}

}  // namespace
}  // namespace cvo::documents_test
