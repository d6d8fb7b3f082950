// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

#include "core/base/error.h"
#include "tests/house/house_rules.h"

namespace cvo::test {
namespace {

constexpr int kLongestFile = 400;

std::vector<std::string> Lines(const std::string& content) {
  std::vector<std::string> lines;
  std::istringstream in(content);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
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
      R"((core|variants|synth|reports|experiments/(datasets|metrics|record|runner|scene_check))/.*\.(h|cc))");
  static const std::regex any(".*");
  // Only cpu_level.* asks for the architecture. A kernel for it, chosen at run time, asks for
  // CVO_WITH_AVX2 instead.
  static const std::regex portable(R"((core|variants)/(?!features/cpu_level\.).*\.(h|cc))");
  static const std::regex step(
      R"(core/(clusters|bodies|labelling|odometry)/(?!visual_odometry\.h).*\.(h|cc))");
  static const std::vector<TextRule> rules = {
      {portable,
       std::regex(
           R"(^\s*#\s*((ifdef|ifndef|elif|else|define|undef)\b|if (?!defined\(CVO_WITH_AVX2\)$)))"),
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
       "time cap: results would depend on the computer"},
      {step, std::regex(R"(\bOptions\b)"), "all options in a step: it takes those it reads"}};
  return rules;
}

std::string WithoutComment(const std::string& line) { return line.substr(0, line.find("//")); }

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
  const auto lines = std::count(file.content.begin(), file.content.end(), '\n');
  if (!IsCode(file.path) || lines <= kLongestFile) return {};
  return {StrCat(file.path, ":1: ", lines, " lines, at most ", kLongestFile)};
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

}  // namespace cvo::test
