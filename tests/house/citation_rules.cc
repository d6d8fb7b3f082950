// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "tests/house/house_rules.h"

namespace cvo::test {
namespace {

constexpr char kMethod[] = "core/METHOD.md";

// Documents that the program writes: named in messages and tests, but not in the repository.
const std::set<std::string>& WrittenDocuments() {
  static const std::set<std::string> names = {"table.md", "check.md", "ci.md", "gate.md"};
  return names;
}

std::string NameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// Returns the numbers of sections, "4" and "4.2" for the headings "## 4 ..." and "### 4.2 ...".
std::set<std::string> Sections(const std::string& method) {
  static const std::regex heading(R"(^#+ (\d+(?:\.\d+)?) )");
  std::set<std::string> sections;
  std::istringstream in(method);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_search(line, match, heading)) sections.insert(match[1]);
  }
  return sections;
}

// Returns the names of option groups and fields of the estimator, "orb" and "levels" for
// visit.Group("orb", ...) and visit.Field("levels", ...).
std::set<std::string> OptionNames(const std::vector<SourceFile>& files) {
  static const std::regex named(R"re(visit\.(?:Group|Field)\(\s*"(\w+)")re");
  std::set<std::string> names;
  for (const SourceFile& file : files) {
    if (!file.path.starts_with("core/") || file.content.find("visit.") == std::string::npos) {
      continue;
    }
    std::sregex_iterator it(file.content.begin(), file.content.end(), named);
    for (; it != std::sregex_iterator(); ++it) names.insert((*it)[1]);
  }
  return names;
}

template <typename Judge>
void ForEachMatch(const SourceFile& file, const std::regex& what, Judge judge) {
  std::istringstream in(file.content);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    for (std::sregex_iterator it(line.begin(), line.end(), what), end; it != end; ++it) {
      judge(*it, StrCat(file.path, ":", number, ": "));
    }
  }
}

void CheckMethod(const SourceFile& method, const std::vector<SourceFile>& files,
                 std::vector<std::string>& violations) {
  static const std::regex name(R"(`([a-z0-9_]+)\.([a-z0-9_]+)`)");
  const std::set<std::string> options = OptionNames(files);
  std::set<std::string> names;
  for (const SourceFile& file : files) names.insert(NameOf(file.path));
  ForEachMatch(method, name, [&](const std::smatch& match, const std::string& where) {
    const bool is_file = match[2] == "h" || match[2] == "cc";
    const bool exists = is_file ? names.contains(match[1].str() + "." + match[2].str())
                                : options.contains(match[1]) && options.contains(match[2]);
    if (exists) return;
    violations.push_back(where + (is_file ? "no such file: " : "no such option: ") + match.str());
  });
}

}  // namespace

std::vector<std::string> CheckCitations(const std::vector<SourceFile>& files,
                                        const std::vector<SourceFile>& documents) {
  static const std::regex section(R"(METHOD[.]md (?:section )?(\d+(?:\.\d+)?))");
  static const std::regex document(R"(([A-Za-z0-9_]+[.]md)\b|\bdesign (?:note|file)s?\b)");
  std::set<std::string> known = WrittenDocuments();
  std::set<std::string> sections;
  std::vector<std::string> violations;
  for (const SourceFile& file : documents) {
    known.insert(NameOf(file.path));
    if (file.path != kMethod) continue;
    sections = Sections(file.content);
    CheckMethod(file, files, violations);
  }
  for (const auto* group : {&files, &documents}) {
    for (const SourceFile& file : *group) {
      const auto has = [&](const char* text) {
        return file.content.find(text) != std::string::npos;
      };
      if (!has(".md") && !has("design ")) continue;  // regular expressions are slow
      ForEachMatch(file, section, [&](const std::smatch& match, const std::string& where) {
        if (sections.contains(match[1])) return;
        violations.push_back(where + "METHOD.md has no section " + match[1].str());
      });
      ForEachMatch(file, document, [&](const std::smatch& match, const std::string& where) {
        if (match[1].matched && known.contains(match[1])) return;
        violations.push_back(where + "no such document in the repository: " + match.str());
      });
    }
  }
  return violations;
}

}  // namespace cvo::test
