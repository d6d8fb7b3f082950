// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the files that are needed before a build: versions and packages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "tests/support/temp_folder.h"

namespace cvo::test {
namespace {

const std::filesystem::path kRepository = CVO_SOURCE_DIR;

// Returns the first group of the first match of the pattern in the file. Empty if there is none.
std::string Found(const char* file, const char* pattern) {
  const std::string text = ReadFile(kRepository / file);
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
  std::istringstream lines(ReadFile(kRepository / "packages.txt"));
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(std::regex_match(line, std::regex(R"((#.*)|([a-z0-9.+-]+ +# \S.*))"))) << line;
  }
}

// Public CI and the development container use the shared script and list of packages.
TEST(ReleaseFiles, ShareOneListOfPackagesAndOneScript) {
  EXPECT_THAT(ReadFile(kRepository / ".github/workflows/ci.yml"),
              testing::HasSubstr("run: .ci/run\n"));
  EXPECT_THAT(ReadFile(kRepository / ".devcontainer/Dockerfile"),
              testing::AllOf(testing::HasSubstr("COPY packages.txt"),
                             testing::HasSubstr("RUN /setup/.ci/install-packages")));
}

}  // namespace
}  // namespace cvo::test
