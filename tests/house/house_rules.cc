// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/house/house_rules.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "core/base/error.h"

namespace cvo::test {
namespace {

constexpr int kLongestFile = 400;
constexpr int kShortestFile = 60;
constexpr std::size_t kUsersOfAShortFile = 3;

std::vector<std::string> Lines(const std::string& content) {
  std::vector<std::string> lines;
  std::istringstream in(content);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

auto LineCount(const SourceFile& file) {
  return std::count(file.content.begin(), file.content.end(), '\n');
}

bool IsCode(const std::string& path) { return path.ends_with(".h") || path.ends_with(".cc"); }

struct TextRule {
  std::regex where;  // paths
  std::regex what;   // within a line
  const char* message;
};

// [x] in place of x keeps a rule from matching its own source.
const std::vector<TextRule>& TextRules() {
  static const std::regex estimator(R"((core|variants)/.*\.(h|cc))");
  static const std::regex library(
      R"((core|variants|synth|reports|experiments/(datasets|metrics|runner|scene_check))/.*\.(h|cc))");
  static const std::regex any(".*");
  // json_record.h lists fields by macros, and processor.h asks what is compiled for.
  static const std::regex portable(
      R"((core|variants)/(?!features/processor\.|files/json/json_record\.).*\.(h|cc))");
  static const std::vector<TextRule> rules = {
      {portable, std::regex(R"(^\s*#\s*(ifdef|ifndef|elif|else|define|undef|if)\b)"),
       "preprocessor branch or macro in the estimator"},
      {any, std::regex("-march=[n]ative|-ffast-[m]ath|-O[f]ast"),
       "flag that makes results depend on the computer or reorders arithmetic"},
      {library, std::regex(R"(\bstd::(cout|cerr|clog)\b|\bf?printf\s*\(|\bputs\s*\()"),
       "a library must not print"},
      {library, std::regex(R"(\b(exit|abort|_Exit|terminate)\s*\()"),
       "a library must not end the process"},
      {library, std::regex(R"(^\s*(static|thread_local)\s+(?!const\b|constexpr\b)[^()]*[=;{])"),
       "mutable static"},
      {library, std::regex(R"(\bsleep_(for|until)\b|\bstd::random_device\b|\bs?rand\s*\()"),
       "sleep or hidden randomness"},
      {estimator, std::regex("max_solver_time_in_seconds"),
       "time cap: results would depend on the computer"}};
  return rules;
}

std::string WithoutComment(const std::string& line) { return line.substr(0, line.find("//")); }

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

std::vector<std::string> CheckLicense(const SourceFile& file) {
  const bool is_code =
      IsCode(file.path) || file.path.ends_with(".h.in") || file.path.ends_with(".cc.in");
  const std::string mark = is_code ? "// " : "# ";
  const std::vector<std::string> lines = Lines(file.content);
  const std::size_t first = !lines.empty() && lines[0].starts_with("#!") ? 1 : 0;
  const bool good = lines.size() >= first + 2 &&
                    lines[first].starts_with(mark + "SPDX-FileCopyrightText: ") &&
                    lines[first + 1] == mark + "SPDX-License-Identifier: Apache-2.0";
  if (good) return {};
  return {file.path + ":1: no SPDX header of two lines"};
}

std::vector<std::string> CheckLength(const SourceFile& file) {
  const auto lines = LineCount(file);
  if (!IsCode(file.path) || lines <= kLongestFile) return {};
  return {StrCat(file.path, ":1: ", lines, " lines, at most ", kLongestFile)};
}

std::vector<std::string> CheckConcepts(const std::vector<SourceFile>& files) {
  static const std::regex include(R"re(#include "([^"]+)")re");
  const auto stem = [](const std::string& path) { return path.substr(0, path.rfind('.')); };
  std::map<std::string, std::set<std::string>> includers;  // by header
  std::map<std::string, long> lines;                       // of a header and its .cc
  for (const SourceFile& file : files) {
    if (IsCode(file.path)) lines[stem(file.path)] += LineCount(file);
    const auto& text = file.content;
    for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
      const std::string header = (*it)[1];
      const bool is_own = header == stem(file.path) + ".h";
      if (!is_own) includers[header].insert(file.path);
    }
  }
  std::vector<std::string> violations;
  for (const SourceFile& file : files) {
    if (!IsCode(file.path)) continue;
    const long count = lines[stem(file.path)];
    const std::set<std::string>& users = includers[stem(file.path) + ".h"];
    if (count < kShortestFile && users.size() < kUsersOfAShortFile) {
      violations.push_back(StrCat(file.path, ":1: ", count, " lines, at least ", kShortestFile,
                                  ", or ", kUsersOfAShortFile, " files that include it"));
    }
    if (file.path.ends_with(".h") && users.size() == 1 &&
        count + lines[stem(*users.begin())] <= kLongestFile) {
      violations.push_back(file.path + ":1: only " + *users.begin() +
                           " includes it: it belongs there");
    }
  }
  return violations;
}

std::vector<std::string> CheckForbiddenText(const SourceFile& file) {
  std::vector<std::string> violations;
  const std::vector<std::string> lines = Lines(file.content);
  for (const TextRule& rule : TextRules()) {
    if (!std::regex_match(file.path, rule.where)) continue;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (std::regex_search(WithoutComment(lines[i]), rule.what)) {
        violations.push_back(StrCat(file.path, ":", i + 1, ": ", rule.message));
      }
    }
  }
  return violations;
}

std::vector<std::string> CheckRegistered(const std::vector<SourceFile>& files) {
  std::map<std::string, const SourceFile*> by_path;
  for (const SourceFile& file : files) by_path[file.path] = &file;
  std::vector<std::string> violations;
  for (const SourceFile& file : files) {
    if (!file.path.ends_with(".cc")) continue;
    bool registered = false;
    for (auto slash = file.path.rfind('/'); slash != std::string::npos && !registered;
         slash = slash == 0 ? std::string::npos : file.path.rfind('/', slash - 1)) {
      const auto cmake = by_path.find(file.path.substr(0, slash + 1) + "CMakeLists.txt");
      if (cmake == by_path.end()) continue;
      const std::string name =
          std::regex_replace(file.path.substr(slash + 1), std::regex(R"([.])"), "[.]");
      const std::string all =
          std::regex_replace(file.path.substr(slash + 1), std::regex(R"([^/]+[.]cc$)"), "[*][.]cc");
      registered = std::regex_search(
          cmake->second->content, std::regex("(^|[\\s(\"])(" + name + "|" + all + ")($|[\\s)\"])"));
    }
    if (!registered) violations.push_back(file.path + ":1: named by no CMakeLists.txt");
  }
  return violations;
}

std::vector<std::string> CheckTypeNames(const std::vector<SourceFile>& files) {
  const std::regex opened(R"(^namespace (\S+) \{)");
  const std::regex defined(R"(^(?:struct|class) (\w+)(?: final)?(?: :.*)? \{)");
  std::map<std::string, std::string> first;  // location, by qualified name
  std::vector<std::string> violations;
  for (const SourceFile& file : files) {
    if (!file.path.ends_with(".h")) continue;
    std::string scope;
    std::smatch match;
    const std::vector<std::string> lines = Lines(file.content);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (std::regex_search(lines[i], match, opened)) scope = match[1];
      if (!std::regex_search(lines[i], match, defined)) continue;
      const std::string where = StrCat(file.path, ":", i + 1);
      const auto [known, added] = first.try_emplace(scope + "::" + match[1].str(), where);
      if (!added) {
        violations.push_back(StrCat(where, ": ", known->first, " is defined in ", known->second));
      }
    }
  }
  return violations;
}

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
