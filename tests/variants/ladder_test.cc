// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The ladder of variants from the paper's method to ours is complete, and each rung changes
// something.
#include "variants/ladder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "variants/all.h"
#include "variants/registry.h"

namespace cvo {
namespace {

std::map<std::string, double> Values(const Options& options) {
  std::map<std::string, double> values;
  VisitLeaves(options, [&](const std::string& path, const auto& value, const FieldInfo&) {
    values[path] = static_cast<double>(value);
  });
  return values;
}

template <typename V>
Options DefaultsOf() {
  Options options;
  V::SetDefaults(options);
  return options;
}

TEST(Ladder, AllRungsTogetherEqualFull) {
  EXPECT_EQ(Values(DefaultsOf<PaperWith<kAllRungs>>()), Values(Options()));
}

template <std::size_t kRung>
void ExpectThatItChangesSomething() {
  using Without = PaperWith<kAllRungs & ~(1U << kRung)>;
  EXPECT_TRUE((CountDifferences<Without, Full>() > 0) ||
              Values(DefaultsOf<Without>()) != Values(Options()))
      << kLadder[kRung].name;
}

TEST(Ladder, RemovingAnyRungChangesFull) {
  [&]<std::size_t... kRung>(std::index_sequence<kRung...>) {
    (ExpectThatItChangesSomething<kRung>(), ...);
  }
  (std::make_index_sequence<kRungs>());
}

TEST(Ladder, NamesDeriveFromTheRungs) {
  EXPECT_EQ(Variants().back().name, "paper_to_trace_back");
  EXPECT_EQ(FindVariant("no_left_image").changes,
            "full without this addition: landmarks of bodies are also found if only the left image "
            "shows them");
}

TEST(Registry, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const VariantInfo& variant : Variants()) {
    EXPECT_TRUE(names.insert(variant.name).second) << variant.name;
  }
  EXPECT_EQ(NamedVariantInfos().size() + 2 * kRungs - 1, Variants().size());
}

TEST(Registry, DefaultOptionsOfEveryVariantAreInRange) {
  for (const VariantInfo& variant : Variants()) {
    EXPECT_NO_THROW(variant.defaults().Check()) << variant.name;
  }
  EXPECT_EQ(Values(FindVariant("full").defaults()), Values(Options()));
  EXPECT_EQ(FindVariant("paper").defaults().association.gamma, 4.0);
}

}  // namespace
}  // namespace cvo
