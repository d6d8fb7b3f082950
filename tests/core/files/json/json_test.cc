// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/json/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "core/files/json/json_rows.h"
#include "tests/support/temp_folder.h"

namespace cvo::json_test {
namespace {

using testing::HasSubstr;

std::string ParseProblem(const std::string& text) {
  try {
    ParseJson(text, "options.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ParseJson, NamesLineAndColumn) {
  const std::string problem = ParseProblem("{\n  \"a\": 1,\n  \"b\": }\n");
  EXPECT_THAT(problem, HasSubstr("options.json, line 3, column 8"));
  EXPECT_EQ(problem.find('\n'), std::string::npos);
}

TEST(ParseJson, RefusesAnythingButOneValue) {
  for (const char* text :
       {"", "{", "{} {}", "[1,]", "{\"a\": NaN}", "{\"a\": 1} // why", "1e999"}) {
    EXPECT_THAT(ParseProblem(text), HasSubstr("options.json")) << text;
  }
}

TEST(ParseJson, RefusesDuplicateKeys) {
  EXPECT_THAT(ParseProblem(R"({"a": {"b": 1, "c": 2, "b": 3}})"), HasSubstr("key \"b\" twice"));
  EXPECT_EQ(ParseProblem(R"({"a": {"b": 1}, "c": {"b": 3}, "d": [{"b": 1}, {"b": 2}]})"), "");
}

TEST(ParseJson, RefusesControlCharactersInKeysAndDeepNesting) {
  EXPECT_EQ(ParseProblem(R"({"a\u001bb": 1})"),
            "options.json: found key \"a?b\", expected keys without control characters");
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_EQ(ParseProblem(nested(100)), "");
  EXPECT_THAT(ParseProblem(nested(101)), HasSubstr("more than 100 values within each other"));
  EXPECT_THAT(ParseProblem(nested(1000000)), HasSubstr("more than 100 values"));
}

TEST(ParseJson, RefusesInvalidUtf8WithOneReadableLine) {
  const std::string problem = ParseProblem("{\"a\": \"\xff\n\"}");
  EXPECT_THAT(problem, HasSubstr("options.json, line 1, column 8"));
  EXPECT_EQ(problem.find_first_of("\n\xff"), std::string::npos);
}

TEST(ParseJson, ChecksButDoesNotKeepSkippedMembers) {
  const std::string text = R"({"frames": [{"frames": 1}, {"a": 2}], "b": {"frames": 3}})";
  EXPECT_EQ(ParseJson(text, "here", {"frames"}), (Json{{"b", {{"frames", 3}}}}));
  for (const char* bad : {R"({"frames": [nan]})", R"({"frames": {"a": 1, "a": 2}})",
                          R"({"frames": 1, "frames": 2})", R"({"frames": [1)"}) {
    EXPECT_THROW(ParseJson(bad, "here", {"frames"}), Error) << bad;
  }
}

TEST(FlatJson, ValuesByDottedPath) {
  EXPECT_THAT(FlatJson({{"a", {{"b", 0.5}, {"c", {1, 2}}}}, {"d", true}}),
              testing::ElementsAre(testing::Pair("a.b", "0.5"), testing::Pair("a.c", "[1,2]"),
                                   testing::Pair("d", "true")));
}

TEST(ReadJson, NamesTheFile) {
  const test::TempFolder folder;
  EXPECT_THROW(ReadJson(folder.path() / "missing.json"), Error);
  EXPECT_THROW(ReadJson(folder.path()), Error);
  const auto file = folder.Write("half.json", "{\"a\": ");
  try {
    ReadJson(file);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string()));
  }
}

TEST(DumpJson, NumbersRoundTripExactly) {
  const std::vector<double> numbers = {0.1,
                                       1.0,
                                       -0.0,
                                       1.0 / 3.0,
                                       1e-7,
                                       6.02214076e23,
                                       std::numeric_limits<double>::denorm_min(),
                                       std::numeric_limits<double>::max()};
  const Json back = ParseJson(DumpJson(numbers), "numbers");
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_TRUE(back[i].is_number_float());
    EXPECT_EQ(back[i].get<double>(), numbers[i]);
    EXPECT_EQ(std::signbit(back[i].get<double>()), std::signbit(numbers[i]));
  }
  EXPECT_EQ(DumpJson(0.1), "0.1\n");
  EXPECT_EQ(DumpJson(1.0), "1.0\n");
  EXPECT_EQ(DumpJson(std::uint64_t{18446744073709551615U}), "18446744073709551615\n");
}

TEST(DumpJson, RefusesNonFiniteNumbersAndNamesThem) {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  try {
    DumpJson({{"frames", Json::array({{{"pose", {1.0, 2.0}}}, {{"pose", {1.0, nan}}}})}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "frames[1].pose[1]: found nan, expected a finite number");
  }
  EXPECT_THROW(DumpJson({{"a", infinity}}), Error);
  EXPECT_THROW(DumpJson({{"a", -infinity}}), Error);
}

TEST(DumpJson, RowsTakeOneLineEach) {
  const Json rows = {{"name", "x"}, {"rows", Json::array({{{"a", 1}, {"b", {1.5, 2.5}}}})}};
  EXPECT_EQ(DumpJson(rows),
            "{\n  \"name\": \"x\",\n  \"rows\": [\n    {\"a\": 1, \"b\": [1.5, 2.5]}\n  ]\n}\n");
  EXPECT_EQ(DumpJson(Json::object()), "{}\n");
}

TEST(DumpJson, InvalidUtf8StillGivesValidJson) {
  EXPECT_NO_THROW(ParseJson(DumpJson({{"name", "\xff\"\n"}}), "text"));
}

TEST(DumpJsonWithRows, AgreesWithDumpJson) {
  const Json head = {{"a", 1}, {"b", {{"c", 0.5}}}};
  const std::vector<Json> all = {{{"x", 1}, {"y", {1.0, 2.0}}},
                                 Json::array({"p", "q"}),
                                 {{"x", 2}, {"inner", {{"list", {1, 2}}, {"z", nullptr}}}},
                                 7};
  for (std::size_t count = 0; count <= all.size(); ++count) {
    Json whole = head;
    whole["rows"] = Json(std::vector<Json>(all.begin(), all.begin() + static_cast<long>(count)));
    if (count == 0) whole["rows"] = Json::array();
    std::size_t next = 0;
    std::string text;
    DumpJsonWithRows(
        head, "rows", [&](Json& row) { return next < count && (row = all[next++], true); },
        [&text](std::string_view part) { text += part; });
    EXPECT_EQ(text, DumpJson(whole)) << count;
    whole["z"] = {{"last", true}};
    next = 0;
    text.clear();
    DumpJsonWithRows(
        head, "rows", [&](Json& row) { return next < count && (row = all[next++], true); },
        [&text](std::string_view part) { text += part; }, {{"z", {{"last", true}}}});
    EXPECT_EQ(text, DumpJson(whole)) << count;
  }
}

TEST(DumpJsonWithRows, NamesTheRowOfANonFiniteNumber) {
  int rows = 0;
  const auto next = [&rows](Json& row) {
    row = {{"x", rows == 2 ? std::nan("") : 1.0}};
    return rows++ < 3;
  };
  try {
    DumpJsonWithRows({{"a", 1}}, "rows", next, [](std::string_view) {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("rows[2].x: found nan"));
  }
}

}  // namespace
}  // namespace cvo::json_test
