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

// What the program writes: named in messages and tests, but no part of the repository.
const std::set<std::string>& WrittenDocuments() {
  static const std::set<std::string> names = {"table.md", "check.md", "ci.md", "gate.md"};
  return names;
}

std::string NameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// "4" and "4.2" of the headings "## 4 ..." and "### 4.2 ...".
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

}  // namespace

std::vector<std::string> CheckCitations(const std::vector<SourceFile>& files,
                                        const std::vector<SourceFile>& documents) {
  static const std::regex section(R"(METHOD[.]md (?:section )?(\d+(?:\.\d+)?))");
  static const std::regex document(R"(([A-Za-z0-9_]+[.]md)\b|\bdesign (?:note|file)s?\b)");
  static const std::regex source(R"(`([a-z0-9_]+\.(?:h|cc))`)");
  std::set<std::string> known = WrittenDocuments();
  std::set<std::string> names;
  std::vector<std::string> violations;
  for (const SourceFile& file : documents) known.insert(NameOf(file.path));
  for (const SourceFile& file : files) names.insert(NameOf(file.path));
  const auto method = std::find_if(documents.begin(), documents.end(),
                                   [](const SourceFile& file) { return file.path == kMethod; });
  const std::set<std::string> sections =
      method == documents.end() ? std::set<std::string>() : Sections(method->content);
  for (const auto* group : {&files, &documents}) {
    for (const SourceFile& file : *group) {
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
  if (method == documents.end()) return violations;
  ForEachMatch(*method, source, [&](const std::smatch& match, const std::string& where) {
    if (!names.contains(match[1])) violations.push_back(where + "no such file: " + match.str());
  });
  return violations;
}

}  // namespace cvo::test
