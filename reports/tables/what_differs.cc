// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/tables/what_differs.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lists.h"

namespace cvo::reports {
namespace {

using Values = std::set<std::string>;
using OptionValues = std::map<std::string, Values>;  // by path

// The variants, builds and options of the runs of one folder.
struct Made {
  Values variants;
  Values builds;
  std::map<std::string, OptionValues> options;  // by variant
};

Made MadeWith(const std::vector<SuiteRun>& runs) {
  Made made;
  for (const SuiteRun& run : runs) {
    const std::string variant = KeyOf(run.planned, "variant");
    made.variants.insert(variant);
    if (!run.run) continue;
    constexpr std::size_t kTold = 12;  // characters of a hash
    if (!run.run->build.identity.empty()) {
      made.builds.insert(run.run->build.identity.substr(0, kTold));
    }
    for (const auto& [path, value] : FlatJson(run.run->options)) {
      made.options[variant][path].insert(value);
    }
  }
  return made;
}

std::string ValuesText(const Values& values) {
  constexpr std::size_t kMost = 3;
  if (values.empty()) return "-";
  if (values.size() > kMost) return Counted(values.size(), "value");
  return Joined(values, " or ");
}

std::string ChangeOf(const Values& before, const Values& after) {
  return StrCat(ValuesText(before), " -> ", ValuesText(after));
}

// The options that differ in a variant that both folders have, with the values of the first such
// variant.
std::vector<std::string> OptionChanges(const Made& before, const Made& after) {
  std::map<std::string, std::string> changes;
  for (const auto& [variant, options] : after.options) {
    const auto there = before.options.find(variant);
    if (there == before.options.end()) continue;
    OptionValues all = options;
    all.insert(there->second.begin(), there->second.end());
    for (const auto& [path, unused] : all) {
      const auto value = [&name = path](const OptionValues& from) {
        const auto found = from.find(name);
        return found == from.end() ? Values() : found->second;
      };
      const Values was = value(there->second);
      const Values is = value(options);
      if (was != is) changes.try_emplace(path, StrCat(path, " ", ChangeOf(was, is)));
    }
  }
  std::vector<std::string> texts;
  for (const auto& [path, text] : changes) texts.push_back(text);
  return texts;
}

std::string OnlyIn(const Values& one, const Values& other) {
  std::vector<std::string> only;
  std::set_difference(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(only));
  return Joined(only, ", ");
}

}  // namespace

std::string WhatDiffers(const std::vector<SuiteRun>& before, const std::vector<SuiteRun>& after) {
  const Made a = MadeWith(before);
  const Made b = MadeWith(after);
  std::vector<std::string> parts;
  const auto add = [&](const char* what, const std::string& text) {
    if (!text.empty()) parts.push_back(what + text);
  };
  constexpr std::size_t kMost = 12;
  std::vector<std::string> options = OptionChanges(a, b);
  if (options.size() > kMost) {
    const std::size_t more = options.size() - kMost;
    options.resize(kMost);
    options.push_back(StrCat("and ", more, " more"));
  }
  add("options ", Joined(options, ", "));
  add("builds ", a.builds == b.builds ? "" : ChangeOf(a.builds, b.builds));
  add("variants only before: ", OnlyIn(a.variants, b.variants));
  add("variants only after: ", OnlyIn(b.variants, a.variants));
  if (parts.empty()) return "The two folders have the same options, builds and variants.";
  return StrCat("The two folders differ: ", Joined(parts, "; "), ".");
}

}  // namespace cvo::reports
