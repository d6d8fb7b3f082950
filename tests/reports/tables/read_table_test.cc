// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/base/error.h"
#include "reports/tables/make_table.h"
#include "reports/tables/table.h"
#include "reports/tables/table_texts.h"
#include "tests/reports/results/result_files.h"
#include "tests/reports/tables/hostile_table.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::Json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string ErrorOf(const std::string& text) {
  return ErrorMessage([&] { ReadTable(text, "table.json"); });
}

// Returns the error message about the hostile table after one change.
std::string ErrorAfter(const std::function<void(Json&)>& change) {
  Json json = Json::parse(TableJson(test::HostileTable()));
  change(json);
  const std::string error = ErrorOf(json.dump());
  EXPECT_THAT(error, Not(HasSubstr("\n")));
  return error;
}

TEST(ReadTable, RoundTripsByteForByte) {
  Table table = test::HostileTable();
  const std::string json = TableJson(table);
  const Table read = ReadTable(json, "table.json");
  EXPECT_EQ(TableJson(read), json);
  EXPECT_EQ(TableText(read, true), TableText(table, true));
  EXPECT_EQ(TableMarkdown(read), TableMarkdown(table));
  table.change = true;
  EXPECT_TRUE(ReadTable(TableJson(table), "table.json").change);
  EXPECT_FALSE(read.change);
}

TEST(ReadTable, RoundTripsSuiteAndEmptyTables) {
  test::SuiteResults suite;
  suite.name = "ablation";
  suite.table["rows"] = {"variant"};
  double second = 0.25;
  for (const char* scene : {"a", "b", "c"}) {
    second += 0.1;
    suite.Add(
        test::WithBodies(test::Result(scene), Json::array({test::BodyOf(1, {0.1, -1.0, 0.3})})),
        "full");
    suite.Add(
        test::WithBodies(test::Result(scene), Json::array({test::BodyOf(1, {0.2, second, 0.3})})),
        "2d");
  }
  suite.table["reference"] = "full";
  const std::string json = TableJson(MakeTable(suite.Written(), ShippedReference(), ""));
  EXPECT_THAT(json, AllOf(HasSubstr("\"reference_lower_percent\""), HasSubstr("\"other scenes\"")));
  EXPECT_EQ(TableJson(ReadTable(json, "table.json")), json);
  const std::string empty = TableJson({});
  EXPECT_EQ(TableJson(ReadTable(empty, "table.json")), empty);
}

TEST(ReadTable, RefusesOtherFilesInOneLine) {
  const std::string json = TableJson(test::HostileTable());
  EXPECT_EQ(ErrorOf(""), "table.json: found an empty file, expected JSON");
  EXPECT_THAT(ErrorOf(json.substr(0, json.size() / 2)),
              HasSubstr("table.json: found text that ends after"));
  EXPECT_THAT(ErrorOf("[1]"), HasSubstr("table.json: found a JSON array, expected an object"));
  EXPECT_THAT(ErrorOf("{\"a\": 1}"), HasSubstr("without schema_version and kind"));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["schema_version"] = 1; }),
              HasSubstr("table.json: found schema_version 1, expected 3"));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["kind"] = "run"; }),
              HasSubstr("found kind \"run\", expected kind \"table\""));
}

TEST(ReadTable, NamesTheWrongField) {
  EXPECT_THAT(ErrorAfter([](Json& table) { table.erase("columns"); }),
              HasSubstr("table.json, field columns: found nothing"));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["rows"][1]["cells"][3].erase("value"); }),
              HasSubstr("rows[1], cells[3], field value: found nothing, expected a value"));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["rows"][0]["cells"].erase(4); }),
              HasSubstr("rows[0], cells: found 4 elements, expected 5"));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["columns"].erase(4); }),
              HasSubstr("rows[0], cells: found 5 elements, expected 4"));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["rows"][0]["cells"][1]["metric"] = "x"; }),
              HasSubstr("field metric: found \"x\", expected \"camera_ate\""));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["rows"][0]["cells"][1]["runs"] = {2}; }),
              HasSubstr("field runs: found 2, expected indices of the row's 2 runs"));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["rows"][0]["cells"][1]["status"] = "?"; }),
              HasSubstr("field status: found \"?\""));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["rows"][0]["keys"].erase("variant"); }),
              HasSubstr("rows[0], keys, field variant: found nothing"));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["rows"][0]["jobs"]["done"] = -1; }),
              HasSubstr("field done: found -1, expected an integer from 0"));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["others"][0]["source"] = "x"; }),
              HasSubstr("field source: found \"x\", expected the id of one of the sources"));
  EXPECT_THAT(
      ErrorAfter([](Json& table) { table["others"][0]["cells"][0]["comparison"] = "equal"; }),
      HasSubstr("field comparison: found \"equal\""));
  EXPECT_THAT(ErrorAfter([](Json& table) { table["others"][0]["cells"][0]["metric"] = "x"; }),
              HasSubstr("field metric: found \"x\""));
  EXPECT_THAT(ErrorAfter([](Json&) {}), IsEmpty());
}

}  // namespace
}  // namespace cvo::reports
