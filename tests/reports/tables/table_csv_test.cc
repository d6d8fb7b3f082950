// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "reports/tables/table_texts.h"
#include "tests/reports/tables/hostile_table.h"

namespace cvo::reports {
namespace {

using testing::Each;
using testing::IsSupersetOf;
using testing::Not;
using testing::SizeIs;
using Fields = std::vector<std::string>;
using Named = std::map<std::string, std::string>;
using Expected = std::vector<Named::value_type>;

// Parses CSV as specified by RFC 4180; only CRLF ends a record.
std::vector<Fields> ParseCsv(const std::string& csv) {
  std::vector<Fields> records = {{""}};
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
std::vector<Named> NamedRecords(const std::string& csv) {
  const std::vector<Fields> records = ParseCsv(csv);
  std::vector<Named> named;
  for (std::size_t i = 1; i < records.size(); ++i) {
    EXPECT_EQ(records[i].size(), records[0].size()) << "record " << i;
    named.emplace_back();
    for (std::size_t j = 0; j < records[0].size(); ++j) {
      named.back()[records[0][j]] = records[i][j];
    }
  }
  return named;
}

TEST(CsvField, IsQuotedWhereRequiredAndNeverAFormula) {
  for (const auto& [text, field] : Expected{{"plain text", "plain text"},
                                            {"a,b", "\"a,b\""},
                                            {"a\"b", "\"a\"\"b\""},
                                            {"a\nb", "\"a\nb\""},
                                            {"a\x1b[31m\tb", "a\xEF\xBF\xBD[31m b"},
                                            {"", ""},
                                            {"=1+1", "'=1+1"},
                                            {"@SUM(A1)", "'@SUM(A1)"},
                                            {"+cmd", "'+cmd"},
                                            {"-cmd|x", "'-cmd|x"},
                                            {"\t=1", "' =1"},
                                            {"\n=1", "\"'\n=1\""},
                                            {"\xEF\xBC\x9D"
                                             "1",
                                             "'\xEF\xBC\x9D"
                                             "1"},                // full width
                                            {"-0.5", "-0.5"}}) {  // a number
    EXPECT_EQ(CsvField(text), field);
  }
}

TEST(TableCsv, HasARecordPerRow) {
  const auto records = NamedRecords(TableCsv(test::HostileTable()));
  ASSERT_THAT(records, SizeIs(4));
  EXPECT_THAT(records[0],
              IsSupersetOf(Expected{{"variant", "full"},
                                    {"frames", "0:72"},
                                    {"runs_done", "2"},
                                    {"object_ate [m]", "0.05761"},  // all digits
                                    {"object_ate low", "0.034"},
                                    {"object_ate marks", ""},
                                    {"object_coverage", "0.9"},
                                    {"object_coverage n", "1 scene, 2 seeds, 2 runs"}}));
  EXPECT_THAT(records[1], IsSupersetOf(Expected{{"object_ate marks", "distinguishable"},
                                                {"variant", test::kLatex},
                                                {"object_ate difference", "0.0467"},
                                                {"object_ate difference low", "0.0112"},
                                                {"object_coverage difference", ""},
                                                {"object_id_switches", ""},
                                                {"object_id_switches marks", "missing"},
                                                {"object_id_switches note",
                                                 "no value in any run, <i>not</i> 100 % & more"}}));
  EXPECT_EQ(records[2].at("camera_ate marks"), "not comparable");
  EXPECT_THAT(records[3], IsSupersetOf(Expected{{"sequence", "'" + std::string(test::kFormula)},
                                                {"variant", "x,\"y\"\nz \xEF\xBF\xBD[31m"},
                                                {"runs_planned", "3"}}));
}

TEST(TableCsv, NoFieldIsAFormulaAndAnEmptySuiteHasOnlyAHeader) {
  for (const Fields& record : ParseCsv(TableCsv(test::HostileTable()))) {
    EXPECT_THAT(record, Each(Not(testing::MatchesRegex("[=+@].*"))));
  }
  EXPECT_THAT(ParseCsv(TableCsv({})), SizeIs(1));
}

}  // namespace
}  // namespace cvo::reports
