// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/formats/table_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "reports/formats/csv_text.h"
#include "tests/reports/formats/hostile_table.h"

namespace cvo::reports {
namespace {

using testing::Each;
using testing::Not;
using testing::SizeIs;

using Record = std::vector<std::string>;

// Parses CSV as specified by RFC 4180; only CRLF ends a record.
std::vector<Record> ParseCsv(const std::string& csv) {
  std::vector<Record> records = {{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    std::string& field = records.back().back();
    const bool twice = i + 1 < csv.size() && csv[i + 1] == csv[i];
    if (csv[i] == '"' && quoted && twice) {
      field += csv[i++];
    } else if (csv[i] == '"') {
      quoted = !quoted;
    } else if (csv[i] == ',' && !quoted) {
      records.back().emplace_back();
    } else if (csv.compare(i, 2, "\r\n") == 0 && !quoted) {
      records.push_back({""});
      ++i;
    } else {
      field += csv[i];
    }
  }
  EXPECT_FALSE(quoted);
  records.pop_back();
  return records;
}

// Returns each record as a map from field name to value.
std::vector<std::map<std::string, std::string>> Named(const std::string& csv) {
  const std::vector<Record> records = ParseCsv(csv);
  std::vector<std::map<std::string, std::string>> named;
  for (std::size_t i = 1; i < records.size(); ++i) {
    EXPECT_EQ(records[i].size(), records[0].size()) << "record " << i;
    named.emplace_back();
    for (std::size_t j = 0; j < records[0].size(); ++j) {
      named.back()[records[0][j]] = records[i][j];
    }
  }
  return named;
}

TEST(CsvField, IsQuotedWhereRequired) {
  EXPECT_EQ(CsvField("plain text"), "plain text");
  EXPECT_EQ(CsvField("a,b"), "\"a,b\"");
  EXPECT_EQ(CsvField("a\"b"), "\"a\"\"b\"");
  EXPECT_EQ(CsvField("a\nb"), "\"a\nb\"");
  EXPECT_EQ(CsvField("a\x1b[31m\tb"), "a\xEF\xBF\xBD[31m b");
  EXPECT_EQ(CsvField(""), "");
}

TEST(CsvField, IsNeverAFormula) {
  EXPECT_EQ(CsvField("=1+1"), "'=1+1");
  EXPECT_EQ(CsvField("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(CsvField("+cmd"), "'+cmd");
  EXPECT_EQ(CsvField("-cmd|x"), "'-cmd|x");
  EXPECT_EQ(CsvField("\t=1"), "' =1");
  EXPECT_EQ(CsvField("\n=1"), "\"'\n=1\"");
  EXPECT_EQ(CsvField("\xEF\xBC\x9D"
                     "1"),
            "'\xEF\xBC\x9D"
            "1")
      << "full width";
  EXPECT_EQ(CsvField("-0.5"), "-0.5") << "a number";
}

TEST(TableCsv, HasARecordPerRow) {
  const auto records = Named(TableCsv(test::HostileTable()));
  ASSERT_THAT(records, SizeIs(4 + 5 + 1));
  EXPECT_EQ(records[0].at("variant"), "full");
  EXPECT_EQ(records[0].at("frames"), "0:72");
  EXPECT_EQ(records[0].at("runs_done"), "2");
  EXPECT_EQ(records[0].at("object_ate [m]"), "0.05761") << "all digits";
  EXPECT_EQ(records[0].at("object_ate low"), "0.034");
  EXPECT_EQ(records[0].at("object_ate marks"), "best");
  EXPECT_EQ(records[0].at("object_coverage"), "0.9");
  EXPECT_EQ(records[0].at("object_coverage n"), "1 scene, 2 seeds, 2 runs");
  EXPECT_EQ(records[1].at("object_ate marks"), "distinguishable");
  EXPECT_EQ(records[1].at("variant"), test::kLatex);
  EXPECT_EQ(records[1].at("object_id_switches"), "");
  EXPECT_EQ(records[1].at("object_id_switches marks"), "missing");
  EXPECT_EQ(records[1].at("object_id_switches note"),
            "no value in any run, <i>not</i> 100 % & more");
  EXPECT_EQ(records[2].at("camera_ate marks"), "not comparable");
  EXPECT_EQ(records[6].at("system"), "Unknown");
  EXPECT_EQ(records[6].at("source"), "a paper (CVPR <2020>) table_2");
  EXPECT_EQ(records[6].at("camera_ate [m]"), "0.04");
  EXPECT_EQ(records[6].at("camera_ate note"), "contract not stated: alignment");
  EXPECT_EQ(records[8].at("sequence"), "'" + std::string(test::kFormula));
  EXPECT_EQ(records[8].at("variant"), "x,\"y\"\nz \xEF\xBF\xBD[31m");
  EXPECT_EQ(records[8].at("runs_planned"), "3");
  EXPECT_EQ(records[9].at("object_ate [m]"), "0.5");
}

TEST(TableLongCsv, HasARecordPerCell) {
  const std::string csv = TableLongCsv(test::HostileTable());
  const auto records = Named(csv);
  ASSERT_THAT(records, SizeIs(4 * 5 + 5 + 1));
  const auto& best = records[3];
  EXPECT_EQ(best.at("metric"), "object_ate");
  EXPECT_EQ(best.at("unit"), "m");
  EXPECT_EQ(best.at("value"), "0.05761");
  EXPECT_EQ(best.at("high"), "0.085");
  EXPECT_EQ(best.at("interval"), "least and largest of 2 runs of one scene");
  EXPECT_EQ(best.at("seeds"), "2");
  EXPECT_EQ(best.at("coverage"), "0.9") << "never accuracy alone";
  EXPECT_EQ(best.at("marks"), "best");
  EXPECT_EQ(best.at("distinguishable"), "");
  const auto& worse = records[5 + 3];
  EXPECT_EQ(worse.at("reference"), "full");
  EXPECT_EQ(worse.at("difference"), "0.0467");
  EXPECT_EQ(worse.at("difference_low"), "0.0112");
  EXPECT_EQ(worse.at("difference_high"), "0.0874");
  EXPECT_EQ(worse.at("pairs"), "11");
  EXPECT_EQ(worse.at("distinguishable"), "true");
  EXPECT_EQ(worse.at("left_out"), "1 of 12 bodies (of all runs) without a value");
  EXPECT_EQ(records[5 + 4].at("message"), "no value in any run, <i>not</i> 100 % & more");
  EXPECT_EQ(records[5 + 4].at("runs"), "");
  EXPECT_EQ(records[2 * 5 + 1].at("not_comparable"), "delta \"1 frame\"");
  const auto& theirs = records[3 * 5 + 3];
  EXPECT_EQ(theirs.at("system"), "Unknown");
  EXPECT_EQ(theirs.at("comparison"), "contract not stated");
  EXPECT_EQ(theirs.at("source"), "a paper (CVPR <2020>) table_2");
  EXPECT_EQ(records.back().at("comparison"), "other scenes");
}

TEST(TableLongCsv, NoFieldIsAFormula) {
  for (const std::string& csv :
       {TableCsv(test::HostileTable()), TableLongCsv(test::HostileTable())}) {
    for (const Record& record : ParseCsv(csv)) {
      EXPECT_THAT(record, Each(Not(testing::MatchesRegex("[=+@].*"))));
    }
  }
}

TEST(TableCsv, OfAnEmptySuiteHasOnlyAHeader) {
  EXPECT_THAT(ParseCsv(TableCsv({})), SizeIs(1));
  EXPECT_THAT(ParseCsv(TableLongCsv({})), SizeIs(1));
}

}  // namespace
}  // namespace cvo::reports
