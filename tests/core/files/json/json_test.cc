// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/json/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/base/error.h"
#include "core/files/json/json_record.h"
#include "core/files/text/number.h"
#include "core/files/text/utf8.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::json_test {
namespace {

using testing::HasSubstr;

std::string ParseProblem(const std::string& text) {
  return ErrorMessage([&] { ParseJson(text, "options.json"); });
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
  EXPECT_THAT(ErrorMessage([&] { ReadJson(file); }), HasSubstr(file.string()));
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
  const Json bad = {{"frames", Json::array({{{"pose", {1.0, 2.0}}}, {{"pose", {1.0, nan}}}})}};
  EXPECT_EQ(ErrorMessage([&] { DumpJson(bad); }),
            "frames[1].pose[1]: found nan, expected a finite number");
  EXPECT_THROW(DumpJson({{"a", infinity}}), Error);
  EXPECT_THROW(DumpJson({{"a", -infinity}}), Error);
}

TEST(DumpJson, RowsTakeOneLineEach) {
  const Json rows = {{"name", "x"}, {"rows", Json::array({{{"a", 1}, {"b", {1.5, 2.5}}}})}};
  EXPECT_EQ(DumpJson(rows),
            "{\n  \"name\": \"x\",\n  \"rows\": [\n    {\"a\": 1, \"b\": [1.5, 2.5]}\n  ]\n}\n");
  EXPECT_EQ(DumpJson(Json::object()), "{}\n");
}

enum class Colour { kRed, kDarkBlue };
constexpr std::array<const char*, 2> EnumNames(Colour) { return {"red", "dark blue"}; }

struct Wheel {
  double size_m = 0.0;
  std::optional<Colour> colour;

  bool operator==(const Wheel&) const = default;
  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("size_m", self.size_m);
    archive.Optional("colour", self.colour);
  }
};

struct Car {
  std::string name;
  std::uint64_t seed = 0;
  int doors = 0;
  bool old = false;
  std::vector<Wheel> wheels;
  std::map<std::string, double> values;
  std::optional<double> ate_m;  // null if absent

  bool operator==(const Car&) const = default;
  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("name", self.name);
    archive.Field("seed", self.seed);
    archive.Field("doors", self.doors);
    archive.Optional("old", self.old);
    archive.Field("wheels", self.wheels);
    archive.Field("values", self.values);
    archive.Field("ate_m", self.ate_m);
  }
};

constexpr const char* kCar = R"({"name":"a","seed":18446744073709551615,"doors":-2,)"
                             R"("wheels":[{"size_m":0.5},{"size_m":1.0,"colour":"dark blue"}],)"
                             R"("values":{"x":1.5},"ate_m":null})";

Car Read(const std::string& text) { return FromJson<Car>(ParseJson(text, "f"), "f"); }

std::string Problem(const std::string& from, const std::string& to) {
  std::string text = kCar;
  return ErrorMessage([&] { Read(text.replace(text.find(from), from.size(), to)); });
}

TEST(JsonRecord, OneVisitorWritesAndReads) {
  const Car car = Read(kCar);
  EXPECT_EQ(car.seed, 18446744073709551615u);
  EXPECT_EQ(car.wheels[1].colour, Colour::kDarkBlue);
  EXPECT_FALSE(car.wheels[0].colour);
  EXPECT_EQ(ToJson(car).dump(), kCar);
  EXPECT_EQ(Read(ToJson(car).dump()), car);
}

TEST(JsonRecord, ErrorsNameTheField) {
  EXPECT_EQ(Problem("\"doors\":-2,", ""), "f, field doors: found nothing, expected a value");
  EXPECT_EQ(Problem("-2", "2.5"), "f, field doors: found 2.5, expected an integer");
  EXPECT_EQ(Problem("-2", "3000000000"),
            "f, field doors: found 3000000000, expected an integer from -2147483648 to 2147483647");
  EXPECT_EQ(Problem("18446744073709551615", "-1"),
            "f, field seed: found -1, expected an integer from 0");
  EXPECT_EQ(Problem("0.5", "\"0.5\""),
            "f, wheels[0], field size_m: found a JSON string, expected a number");
  EXPECT_EQ(Problem("0.5", "null"),
            "f, wheels[0], field size_m: found a JSON null, expected a number");
  EXPECT_EQ(Problem("dark blue", "green"),
            "f, wheels[1], field colour: found \"green\", expected one of \"red\", \"dark blue\"");
  EXPECT_EQ(Problem("{\"x\":1.5}", "[]"), "f, values: found a JSON array, expected an object");
}

TEST(Base64, MatchesTheVectorsOfRfc4648) {
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foo"), "Zm9v");
  EXPECT_EQ(Base64("foob"), "Zm9vYg==");
  EXPECT_EQ(Base64("\xff\xfe"), "//4=");
}

TEST(Escaped, TextStaysText) {
  EXPECT_EQ(HtmlEscaped("<b a='1' c=\"2\">&"), "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;");
  EXPECT_EQ(MarkdownEscaped("a|b_c [x](y) $"), "a\\|b\\_c [x]\\(y) \\$");
  EXPECT_EQ(MarkdownEscaped("https://a.b www.c.d 1:2"), "https\\://a.b www\\.c.d 1:2");
}

TEST(Utf8, PrintableReplacesControlCharacters) {
  EXPECT_EQ(PrintableLines("a\r\nb\x1b\tc\rd\n"), "a\r\nb\xEF\xBF\xBD c d\n");
  EXPECT_EQ(Printable("a\r\nb"), "a  b");
}

TEST(Utf8, AcceptsOnlyCompleteValidSequences) {
  EXPECT_EQ(Printable("z\xc3\xa9\xef\xbf\xbd\xf0\x9f\x98\x80"),
            "z\xc3\xa9\xef\xbf\xbd\xf0\x9f\x98\x80");
  EXPECT_TRUE(IsUtf8("plain, \xc3\xa9, \xef\xbf\xbd, \xf0\x9f\x98\x80"));
  for (const char* text : {"\xff", "a\xc3", "\xc0\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80"}) {
    EXPECT_FALSE(IsUtf8(text));
  }
  EXPECT_TRUE(HasControl("a\x1b[0m"));
  EXPECT_FALSE(HasControl("\xc3\xa9"));
}

TEST(Number, FixedAndGeneral) {
  EXPECT_EQ(FormatFixed(2.5, 2), "2.50");
  EXPECT_EQ(FormatGeneral(1234567.0, 4), "1.235e+06");
  EXPECT_EQ(FormatGeneral(0.0625, 4), "0.0625");
  EXPECT_EQ(FormatSigned(0.5, 3) + FormatSigned(-2.0, 3) + FormatSigned(0.0, 3), "+0.5-2+0");
  EXPECT_EQ(RoundedTo(0.0123456, 4), 0.01235);
}

}  // namespace
}  // namespace cvo::json_test
