// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/results/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"

namespace cvo::reports {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(JsonText, FindsMembersWithoutParsingThem) {
  const std::string text = R"( {"a": [1, {"b": "]}"}], "c" : "x\"}\\", "d":-1.5e3 ,
    "e": {}, "f": null}
)";
  const auto members = JsonMembers(text, "here");
  EXPECT_THAT(members, ElementsAre(Pair("a", R"([1, {"b": "]}"}])"), Pair("c", R"("x\"}\\")"),
                                   Pair("d", "-1.5e3"), Pair("e", "{}"), Pair("f", "null")));
  EXPECT_EQ(FindMember(members, "d"), "-1.5e3");
  EXPECT_EQ(FindMember(members, "b"), "");
  EXPECT_THAT(JsonElements(R"([1, "a,b", [2, 3], {"x": [4]}])", "here"),
              ElementsAre("1", R"("a,b")", "[2, 3]", R"({"x": [4]})"));
  EXPECT_THAT(JsonElements("[]", "here"), IsEmpty());
  EXPECT_THAT(JsonMembers(" { } ", "here"), IsEmpty());
}

TEST(JsonText, WhateverIsCutOffIsAnError) {
  const std::string text = R"({"a": [1, {"b": "]}"}], "c": "x\"}", "e": {"f": 3}})";
  ASSERT_EQ(JsonMembers(text, "here").size(), 3U);
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_THROW(JsonMembers(text.substr(0, size), "here"), Error) << size;
  }
}

TEST(JsonText, RefusesWhatIsNoObject) {
  for (const char* text : {"[1]", "7", R"({"a" 1})", R"({"a": 1} x)", R"({a: 1})", R"({"a": })"}) {
    EXPECT_THROW(JsonMembers(text, "here"), Error) << text;
  }
}

}  // namespace
}  // namespace cvo::reports
