// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/json/json_record.h"

#include <gtest/gtest.h>

#include "tests/support/error_message.h"

namespace cvo::json_record_test {
namespace {

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

// A row of a table in which the columns determine the type of the cells.
struct Cell {
  bool known = false;
  double value = 0.0;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive, const std::string& column) {
    archive.Constant("column", column);
    archive.Flag("status", self.known, "missing", "ok");
    if (archive.Has("value", self.known)) archive.Field("value", self.value);
  }
};

struct Row {
  std::vector<std::string> columns;
  std::vector<std::string> keys;
  std::vector<Cell> cells;
  std::string note;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("columns", self.columns);
    archive.Named("keys", self.keys, self.columns);
    archive.Each("cells", self.cells, self.columns);
    archive.Added("note", self.note);
  }
};

constexpr const char* kRow = R"({"columns":["a","b"],"keys":{"a":"x","b":"y"},)"
                             R"("cells":[{"column":"a","status":"missing"},)"
                             R"({"column":"b","status":"ok","value":2.5}],"note":""})";

TEST(JsonRecord, FieldsMayDependOnOthers) {
  const auto read = [](const std::string& text) {
    return FromJson<Row>(ParseJson(text, "f"), "f");
  };
  const auto problem = [&](const std::string& from, const std::string& to) {
    std::string text = kRow;
    return ErrorMessage([&] { read(text.replace(text.find(from), from.size(), to)); });
  };
  const Row row = read(kRow);
  EXPECT_EQ(row.keys, (std::vector<std::string>{"x", "y"}));
  EXPECT_FALSE(row.cells[0].known);
  EXPECT_EQ(row.cells[1].value, 2.5);
  EXPECT_EQ(ToJson(row).dump(), kRow);
  EXPECT_EQ(problem(R"(,"note":"")", ""), "") << "of an older file";
  EXPECT_EQ(problem(R"("column":"b")", R"("column":"c")"),
            "f, cells[1], field column: found \"c\", expected \"b\"");
  EXPECT_EQ(problem("missing", "gone"),
            "f, cells[0], field status: found \"gone\", expected one of \"missing\", \"ok\"");
  EXPECT_EQ(problem(R"(,"b":"y")", ""), "f, keys, field b: found nothing, expected a value");
  EXPECT_EQ(problem(R"(["a","b"])", R"(["a"])"), "f, cells: found 2 elements, expected 1");
}

}  // namespace
}  // namespace cvo::json_record_test
