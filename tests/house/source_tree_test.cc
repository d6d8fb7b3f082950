// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Applies the house rules to the source tree, and tests the files that are needed before a build.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "tests/house/house_rules.h"
#include "tests/support/temp_folder.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

const fs::path kTop = CVO_SOURCE_DIR;

bool IsSource(const fs::path& path) {
  const fs::path extension = path.extension();
  return extension == ".h" || extension == ".cc" || extension == ".cmake" || extension == ".in" ||
         extension == ".sh" || path.filename() == "CMakeLists.txt";
}

bool IsDocument(const fs::path& path) { return path.extension() == ".md"; }

std::vector<SourceFile> FilesThat(bool (*is_wanted)(const fs::path&), std::vector<fs::path> paths) {
  for (const char* folder : {"core", "variants", "experiments", "synth", "reports", "tests"}) {
    if (!fs::is_directory(kTop / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(kTop / folder)) {
      if (entry.is_regular_file() && is_wanted(entry.path())) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<SourceFile> files;
  for (const fs::path& path : paths) {
    files.push_back({path.lexically_relative(kTop).generic_string(), ReadFile(path)});
  }
  return files;
}

std::vector<SourceFile> Sources() {
  return FilesThat(IsSource, {kTop / "CMakeLists.txt", kTop / "Makefile", kTop / ".ci/run",
                              kTop / ".ci/install-packages", kTop / ".ci/quote-record",
                              kTop / ".ci/compare-record", kTop / ".ci/record-status"});
}

std::vector<SourceFile> Documents() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(kTop)) {
    if (IsDocument(entry.path())) paths.push_back(entry.path());
  }
  return FilesThat(IsDocument, std::move(paths));
}

template <typename Check>
std::vector<std::string> OnAll(Check check) {
  std::vector<std::string> violations;
  for (const SourceFile& file : Sources()) {
    for (std::string& violation : check(file)) violations.push_back(std::move(violation));
  }
  return violations;
}

TEST(SourceTree, IsFound) { EXPECT_GT(Sources().size(), 50u); }

TEST(SourceTree, IncludesFollowTheLayers) { EXPECT_THAT(OnAll(CheckIncludes), IsEmpty()); }

TEST(SourceTree, FilesHaveTheirLicense) { EXPECT_THAT(OnAll(CheckLicense), IsEmpty()); }

TEST(SourceTree, TypesHaveUniqueNames) { EXPECT_THAT(CheckTypeNames(Sources()), IsEmpty()); }

TEST(SourceTree, FilesAreShort) { EXPECT_THAT(OnAll(CheckLength), IsEmpty()); }

TEST(SourceTree, HasNoForbiddenText) { EXPECT_THAT(OnAll(CheckForbiddenText), IsEmpty()); }

TEST(SourceTree, CitationsExist) { EXPECT_THAT(CheckCitations(Sources(), Documents()), IsEmpty()); }

TEST(SourceTree, FilesAreConcepts) { EXPECT_THAT(CheckConcepts(Sources()), IsEmpty()); }

TEST(SourceTree, EverySourceIsBuilt) { EXPECT_THAT(CheckRegistered(Sources()), IsEmpty()); }

// Returns the first group of the first match of the pattern in the file. Empty if there is none.
std::string Found(const char* file, const char* pattern) {
  const std::string text = ReadFile(kTop / file);
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : "";
}

TEST(ReleaseFiles, AgreeOnTheVersion) {
  const std::string version = Found("CMakeLists.txt", R"(project\(ClusterVO VERSION ([\d.]+))");
  EXPECT_THAT(version, testing::MatchesRegex("[0-9]+[.][0-9]+[.][0-9]+"));
  EXPECT_EQ(Found("CHANGELOG.md", R"(\n## ([\d.]+)\n)"), version) << "the newest entry";
  EXPECT_EQ(Found("CITATION.cff", R"(\nversion: ([\d.]+)\n)"), version);
  const std::string minor = version.substr(0, version.rfind('.'));
  for (const char* file : {"README.md", "tests/consumer/CMakeLists.txt"}) {
    EXPECT_EQ(Found(file, R"(find_package\(ClusterVO ([\d.]+))"), minor) << file;
  }
}

TEST(ReleaseFiles, EveryPackageHasAReason) {
  std::istringstream lines(ReadFile(kTop / "packages.txt"));
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(
        std::regex_match(line, std::regex(R"(|#.*|\[[a-z]+\] # \S.*|[a-z0-9.+-]+ +# \S.*)")))
        << line;
  }
}

// Public CI and the development container use the shared script and list of packages.
TEST(ReleaseFiles, ShareOneListOfPackagesAndOneScript) {
  EXPECT_THAT(ReadFile(kTop / ".github/workflows/ci.yml"), HasSubstr("run: .ci/run\n"));
  EXPECT_THAT(ReadFile(kTop / ".devcontainer/Dockerfile"),
              AllOf(HasSubstr("COPY packages.txt"), HasSubstr("RUN /setup/.ci/install-packages")));
}

const fs::path kRecord = kTop / "reports/RESULTS.md";

// What reports/record.txt lists: suites with their minutes, and whether they are in the sample.
struct Recorded {
  std::string suite;
  int minutes = 0;
  bool quick = false;
};
std::vector<Recorded> RecordedSuites() {
  std::vector<Recorded> suites;
  std::istringstream lines(ReadFile(kTop / "reports/record.txt"));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string quick;
    Recorded& recorded = suites.emplace_back();
    words >> recorded.suite >> recorded.minutes >> quick;
    recorded.quick = quick == "quick";
  }
  return suites;
}

// Empties the quotes of every document and has them filled again.
TEST(Documents, QuoteTheRecord) {
  const TempFolder folder;
  const std::regex quotes(R"((\n<!-- record: (\w+)[^\n]* -->\n)(\|[^\n]*\n)*(<!-- end of record))");
  std::set<std::string> quoted;
  for (const SourceFile& document : Documents()) {
    const std::string& text = document.content;
    const auto first = std::sregex_iterator(text.begin(), text.end(), quotes);
    for (auto quote = first; quote != std::sregex_iterator(); ++quote) quoted.insert((*quote)[2]);
    if (first == std::sregex_iterator()) continue;
    const fs::path copy = folder.path() / "document";
    std::ofstream(copy) << std::regex_replace(text, quotes, "$1$4");
    const std::string command =
        StrCat((kTop / ".ci/quote-record").string(), " ", kRecord.string(), " ", copy.string());
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(ReadFile(copy), text) << document.path << ": make record writes its tables";
  }
  std::set<std::string> recorded;
  for (const Recorded& one : RecordedSuites()) recorded.insert(one.suite);
  EXPECT_THAT(recorded, testing::IsSupersetOf(quoted));
  EXPECT_THAT(quoted, testing::IsSupersetOf({"ablation", "kitti_raw", "ladder", "leave_one_out"}));
}

// Other tables have no figures, such as 0.044 or -0.006 (0.028), but those of earlier builds.
TEST(Documents, HaveNoFiguresTypedByHand) {
  const std::regex figures(R"((\|\s*[-+(*]*\d+\.\d+[^|]*){3,}\|)");
  for (const SourceFile& document : Documents()) {
    if (document.path == "HISTORY.md" || document.path == "reports/RESULTS.md") continue;
    std::istringstream lines(document.content);
    bool quoted = false;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("<!-- ")) quoted = line.starts_with("<!-- record: ");
      EXPECT_FALSE(!quoted && std::regex_search(line, figures)) << document.path << ": " << line;
    }
  }
}

TEST(Record, TakesThreeHoursAndItsSampleTwentyMinutes) {
  int all = 0;
  int sample = 0;
  for (const Recorded& one : RecordedSuites()) {
    EXPECT_TRUE(fs::exists(kTop / "experiments/configs" / (one.suite + ".json"))) << one.suite;
    EXPECT_GT(one.minutes, 0) << one.suite;
    all += one.minutes;
    if (one.quick) sample += one.minutes;
  }
  EXPECT_LE(all, 180);
  EXPECT_GT(sample, 0);
  EXPECT_LE(sample, 20);
}

TEST(Record, TellsWhatHasMoved) {
  const TempFolder folder;
  const std::string head = "| sequence | variant | ATE [m] | R |\n|---|---|---:|---:|\n";
  const std::string rows = "| a | full | 0.200\\* (0.1..0.3) | 1.0 |\n| | ORB | 0.4 | |\n";
  folder.Write("record", "## other\n\n" + head + "\n## mine\n\nAbout.\n\n" + head + rows);
  const auto compared = [&](const std::string& suite, const std::string& table) {
    folder.Write("table", "About.\n\n" + head + table);
    const std::string at = folder.path().string();
    const std::string command =
        StrCat((kTop / ".ci/compare-record").string(), " ", at, "/record ", suite, " ", at,
               "/table > ", at, "/said; echo $? >> ", at, "/said");
    EXPECT_EQ(std::system(command.c_str()), 0);
    return ReadFile(folder.path() / "said");
  };
  EXPECT_EQ(compared("mine", rows), "mine: same, 3 values\n0\n");
  EXPECT_EQ(compared("mine", "| a | full | 0.250 (0.1..0.3) | 1.0 |\n| | ORB | 0.4 | |\n"),
            "mine: 1 of 3 values moved, most by 20.0 % (a full, ATE [m]: "
            "0.200\\* (0.1..0.3) -> 0.250 (0.1..0.3))\n1\n");
  EXPECT_EQ(compared("mine", "| a | full | 0.200\\* (0.1..0.3) | 1.0 |\n| b | full | 1 | 1 |\n"),
            "mine: 0 of 2 values moved, 2 rows are in one of the two\n1\n");
  EXPECT_EQ(compared("none", rows), "none: not in the record\n1\n");
}

// A record of another build names its commits; the gate decides whether it still holds.
TEST(Record, TellsOfWhatBuildItIs) {
  const TempFolder folder;
  const std::string at = folder.path().string();
  const auto state = [&](const std::string& gate, const std::string& made) {
    const std::string command = StrCat("cd ", at, " && ", (kTop / ".ci/record-status").string(),
                                       " record ./program '", gate, "' ", made, " > said");
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::string said = ReadFile(folder.path() / "said");
    EXPECT_THAT(ReadFile(folder.path() / "record"),
                HasSubstr("# Results\n\n" + said + "\nText.\n"));
    std::replace(said.begin(), said.end(), '\n', ' ');
    return said;
  };
  const auto program = [&](const std::string& build) {
    folder.Write("program",
                 "#!/bin/sh\necho 'build      " + build + "01'\necho 'commit     abcdef0123'\n");
    fs::permissions(folder.path() / "program", fs::perms::owner_all);
  };
  fs::create_directories(folder.path() / "reports/baselines");
  const auto baseline = [&](int build, int values) {
    folder.Write("reports/baselines/ci.json",
                 StrCat("{\n \"build\": ", build, ",\n \"values\": ", values,
                        ",\n \"checksum\": ", build + values, "\n}\n"));
  };
  folder.Write("record", "# Results\n\nText.\n\n## a\n\n2 runs; build 111111111111\n");
  program("111111111111");
  baseline(1, 2);
  EXPECT_EQ(state("false", "made"),
            "**Record:** build 111111111111, commit abcdef01, baseline fb991473. "
            "The sources beside it are of this build. ");
  program("222222222222");
  EXPECT_THAT(state("true", ""), HasSubstr("are of build 222222222222, by commits not known here"));
  EXPECT_THAT(state("false", ""), HasSubstr("values have moved, make record."));
  baseline(2, 2);  // written again, after the record
  EXPECT_THAT(state("true", ""), HasSubstr("the record holds."));
  baseline(2, 3);
  EXPECT_THAT(state("true", ""), HasSubstr("values have moved, make record."));
  EXPECT_THAT(state("true", "made"), HasSubstr("Of build 111111111111: a."));
}

}  // namespace
}  // namespace cvo::test
