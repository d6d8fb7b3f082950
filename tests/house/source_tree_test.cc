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
                              kTop / ".ci/install-packages", kTop / ".ci/quote-record"});
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

// Empties the quotes of every document and has them filled again.
TEST(Documents, QuoteTheRecord) {
  const TempFolder folder;
  const std::regex quotes(R"((\n<!-- record: \w+ -->\n)(\|[^\n]*\n)+(<!-- end of record -->\n))");
  int quoting = 0;
  for (const SourceFile& document : Documents()) {
    const std::string emptied = std::regex_replace(document.content, quotes, "$1$3");
    if (emptied == document.content) continue;
    ++quoting;
    const fs::path copy = folder.path() / "document";
    std::ofstream(copy) << emptied;
    const std::string command = StrCat((kTop / ".ci/quote-record").string(), " ",
                                       (kTop / "reports/RESULTS.md").string(), " ", copy.string());
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(ReadFile(copy), document.content)
        << document.path << ": make record writes its tables";
  }
  EXPECT_GT(quoting, 0);
}

}  // namespace
}  // namespace cvo::test
