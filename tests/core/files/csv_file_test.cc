// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/csv_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::csv_file_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class CsvFileTest : public testing::Test {
 protected:
  CsvFile Read(const std::string& text) const { return CsvFile(folder_.Write("table.csv", text)); }
  std::string Problem(
      const std::string& text,
      const std::function<void(const CsvFile&)>& use = [](const CsvFile&) {}) const {
    return ErrorMessage([&] { use(Read(text)); });
  }

  test::TempFolder folder_;
};

TEST_F(CsvFileTest, CellsByRowAndColumn) {
  const CsvFile file = Read("id,name,x,y\n7,a chair,1.5,-2e3\r\n9007199254740993,,0,1\n");
  ASSERT_EQ(file.rows(), 2U);
  EXPECT_EQ(file.Integer(0, file.Column("id")), 7);
  EXPECT_EQ(file.Id(1, 0), 9007199254740993);
  EXPECT_EQ(file.Name(0, 1), "a chair");
  EXPECT_TRUE(file.Empty(1, 1));
  EXPECT_THAT(file.Numbers<2>(0, file.Columns({"x", "y"})), ElementsAre(1.5, -2000.0));
  EXPECT_EQ(Read("a\n").rows(), 0U);
}

TEST_F(CsvFileTest, ErrorsOfDamagedFilesNameTheLine) {
  EXPECT_THAT(Problem(""), HasSubstr("table.csv:1: found nothing"));
  EXPECT_THAT(Problem("a,b\n1,2\n3,4"), HasSubstr("table.csv:3: found a last line without a line"));
  EXPECT_THAT(Problem("a,b\n1\n"), HasSubstr("table.csv:2: found 1 cells, expected 2, as line 1"));
  EXPECT_THAT(Problem("a,b\n\n"), HasSubstr("table.csv:2: found 1 cells"));
  EXPECT_THAT(Problem("a\n\xff\n"), HasSubstr("table.csv:2: found bytes that are no characters"));
  EXPECT_THAT(Problem("a\n1\n", [](const CsvFile& file) { file.Column("b"); }),
              HasSubstr("no column b"));
  EXPECT_THAT(Problem("a,c,b\n",
                      [](const CsvFile& file) {
                        file.Columns({"a", "b"});
                      }),
              HasSubstr("column b elsewhere, expected behind a"));
  EXPECT_THAT(ErrorMessage([&] { CsvFile(folder_.Write("t", "a,b\n"), "a,c"); }),
              HasSubstr("found \"a,b\", expected the header \"a,c\""));
}

TEST_F(CsvFileTest, ErrorsOfNonNumericCellsNameTheColumn) {
  for (const char* cell : {"nan", "inf", "1e999", "", "1 ", "0x1", "one"}) {
    EXPECT_THAT(Problem("a,b\n1," + std::string(cell) + "\n",
                        [](const CsvFile& file) { file.Number(0, 1); }),
                HasSubstr("in column b, expected a finite number"))
        << cell;
  }
  EXPECT_THAT(Problem("a\n3000000000\n", [](const CsvFile& file) { file.Integer(0, 0); }),
              HasSubstr("a whole number"));
  EXPECT_THAT(Problem("a,b\n,1\n", [](const CsvFile& file) { file.Name(0, 0); }),
              HasSubstr("a name"));
}

}  // namespace
}  // namespace cvo::csv_file_test
