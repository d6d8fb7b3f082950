// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <limits>
#include <opencv2/core.hpp>
#include <string>

#include "core/base/error.h"
#include "core/files/atomic_file.h"
#include "core/files/images/image_file.h"
#include "core/files/text_file.h"
#include "core/record/csv_record.h"
#include "tests/support/error_message.h"
#include "tests/support/image_file.h"
#include "tests/support/temp_folder.h"

namespace cvo::files_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> Names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// While this object exists, writing a file beyond the limit fails with EFBIG, as it does with
// ENOSPC on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int) = nullptr;
};

TEST(WriteFilesAtomically, WritesAndReplaces) {
  const test::TempFolder folder;
  folder.Write("a.json", "old");
  const std::string large(3'000'000, 'x');
  WriteFilesAtomically(folder.path(), {{"a.json", "new"}, {"b.txt", large}, {"c.txt", ""}});
  EXPECT_EQ(test::ReadFile(folder.path() / "a.json"), "new");
  EXPECT_EQ(test::ReadFile(folder.path() / "b.txt"), large);
  EXPECT_THAT(Names(folder.path()), ElementsAre("a.json", "b.txt", "c.txt"));
}

TEST(StagedFile, AppendsAndAppearsWithTheOthers) {
  const test::TempFolder folder;
  StagedFile(folder.path() / "lost.csv").Append("1\n");
  EXPECT_THAT(Names(folder.path()), IsEmpty());
  StagedFile rows(folder.path() / "rows.csv");
  rows.Append("1\n");
  rows.Append("2\n");
  StagedFiles files(folder.path());
  files.Add(std::move(rows));
  files.Add("a.json", "new");
  EXPECT_TRUE(files.Has("rows.csv"));
  EXPECT_FALSE(files.Has("b.json"));
  EXPECT_FALSE(fs::exists(folder.path() / "a.json"));
  files.Publish();
  EXPECT_EQ(test::ReadFile(folder.path() / "rows.csv"), "1\n2\n");
  EXPECT_THAT(Names(folder.path()), ElementsAre("a.json", "rows.csv"));
}

TEST(StagedFile, ConcatenatesAnyNumberOfParts) {
  const test::TempFolder folder;
  std::string all;
  StagedFiles files(folder.path());
  files.Add("rows.csv", [&all](const TextSink& sink) {
    for (std::size_t i = 0; i < 2000; ++i) {
      const std::string part((i * 7919) % 1000 + (i == 1000 ? 1'000'000 : 0),
                             static_cast<char>('a' + i % 26));
      all += part;
      sink(part);
    }
  });
  files.Publish();
  EXPECT_EQ(test::ReadFile(folder.path() / "rows.csv"), all);
}

TEST(WriteFilesAtomically, AFailedWriteChangesNothing) {
  const test::TempFolder folder;
  folder.Write("a.json", "old");
  const std::string problem = ErrorMessage([&] {
    const FileSizeLimit limit(1000);
    WriteFilesAtomically(folder.path(), {{"a.json", "new"}, {"b.txt", std::string(5000, 'x')}});
  });
  EXPECT_THAT(problem, AllOf(HasSubstr((folder.path() / "b.txt").string()),
                             HasSubstr("cannot write"), HasSubstr(std::strerror(EFBIG))));
  EXPECT_EQ(test::ReadFile(folder.path() / "a.json"), "old");
  EXPECT_THAT(Names(folder.path()), ElementsAre("a.json"));
}

TEST(WriteFilesAtomically, FolderInsteadOfAFile) {
  const test::TempFolder folder;
  fs::create_directory(folder.path() / "a.json");
  EXPECT_THAT(ErrorMessage([&] {
                WriteFilesAtomically(folder.path(), {{"a.json", "new"}});
              }),
              HasSubstr("a.json"));
  EXPECT_THAT(Names(folder.path()), ElementsAre("a.json"));
}

TEST(WriteFilesAtomically, CreatesAndClearsSubfolders) {
  const test::TempFolder folder;
  WriteFilesAtomically(folder.path(), {{"in/1.txt", "one"}, {"in/2.txt", "two"}, {"last", ""}});
  EXPECT_THAT(Names(folder.path()), ElementsAre("in", "last"));
  EXPECT_THAT(Names(folder.path() / "in"), ElementsAre("1.txt", "2.txt"));
  WriteFilesAtomically(folder.path(), {{"in/1.txt", "new"}, {"last", ""}},
                       {"in/2.txt", "in/none.txt"});
  EXPECT_EQ(test::ReadFile(folder.path() / "in" / "1.txt"), "new");
  EXPECT_THAT(Names(folder.path() / "in"), ElementsAre("1.txt"));
  WriteFilesAtomically(folder.path(), {{"last", ""}}, {"in/1.txt"});
  EXPECT_THAT(Names(folder.path()), ElementsAre("last"));
}

TEST(OutputFolder, IsRemovedIfEmpty) {
  const test::TempFolder folder;
  { const OutputFolder output(folder.path() / "x" / "y", {"a.json"}); }
  EXPECT_FALSE(fs::exists(folder.path() / "x" / "y"));
  {
    const OutputFolder output(folder.path() / "z", {"a.json"});
    EXPECT_THAT(Names(output.path()), IsEmpty());
    WriteFilesAtomically(output.path(), {{"a.json", "new"}});
  }
  EXPECT_THAT(Names(folder.path() / "z"), ElementsAre("a.json"));
  fs::create_directory(folder.path() / "mine");
  { const OutputFolder output(folder.path() / "mine", {"a.json"}); }
  EXPECT_TRUE(fs::exists(folder.path() / "mine"));
}

TEST(OutputFolder, NamesTheObstacle) {
  const test::TempFolder folder;
  folder.Write("file", "");
  EXPECT_THAT(ErrorMessage([&] { const OutputFolder output(folder.path() / "file", {"a.json"}); }),
              HasSubstr("file"));
  EXPECT_THAT(
      ErrorMessage([&] { const OutputFolder output(folder.path() / "file/out", {"a.json"}); }),
      HasSubstr("file"));
  fs::create_directories(folder.path() / "out" / "a.json");
  EXPECT_THAT(ErrorMessage([&] { const OutputFolder output(folder.path() / "out", {"a.json"}); }),
              AllOf(HasSubstr("a.json"), HasSubstr("found a folder")));
  EXPECT_THAT(ErrorMessage([&] {
                const OutputFolder output(folder.path(), {"a.json", "file/"});
              }),
              AllOf(HasSubstr("file"), HasSubstr("expected a folder or nothing")));
  EXPECT_EQ(ErrorMessage([&] {
              const OutputFolder output(folder.path(), {"a.json", "out/"});
            }),
            "");
  EXPECT_THAT(ErrorMessage([] { const OutputFolder output("/proc/none", {"a.json"}); }),
              HasSubstr("/proc/none"));
  EXPECT_NE(ErrorMessage([&] {
              const FileSizeLimit limit(100);
              const OutputFolder output(folder.path() / "full", {"a.json"});
            }),
            "");
}

TEST(Temporary, OldOnesAreLeftovers) {
  const test::TempFolder temp;
  const auto add = [&temp](int hours) {
    const fs::path name = TemporaryName(temp.path() / "a b.tmp-1").filename();
    const fs::path path = temp.Write(name / "in", "abc").parent_path();
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(hours));
    return path;
  };
  const fs::path recent = add(23);
  const fs::path old = add(25);
  const fs::path other = temp.Write(".a.tmp-of mine", "abc");
  fs::last_write_time(other, fs::file_time_type::clock::now() - std::chrono::hours(25));
  EXPECT_TRUE(IsTemporary(recent));
  EXPECT_FALSE(IsTemporary(other));
  RemoveLeftovers(temp.path());
  EXPECT_TRUE(fs::exists(recent));
  EXPECT_FALSE(fs::exists(old));
  RemoveTemporaries(temp.path());
  EXPECT_FALSE(fs::exists(recent));
  EXPECT_TRUE(fs::exists(other));
  RemoveLeftovers(temp.path() / "none");
}

struct CsvRow {
  std::int64_t id = 0;
  std::string name;
  int count = 0;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  std::optional<RigidTransform> pose;
  std::optional<ImageBox> box;

  template <typename Self, typename Archive>
  static void VisitColumns(Self& self, Archive& archive) {
    archive.Cells("id", self.id);
    archive.Cells("name", self.name);
    archive.Cells("count", self.count);
    archive.Cells("x,y,z", self.p);
    archive.Cells("tx,ty,tz,qx,qy,qz,qw", self.pose);
    archive.Cells("left,top,right,bottom", self.box);
  }
};

class CsvRecord : public testing::Test {
 protected:
  std::vector<CsvRow> Read(const std::string& rows) const {
    const std::string file = folder_.Write("t.csv", CsvHeader<CsvRow>() + "\n" + rows);
    std::vector<CsvRow> read;
    ReadCsv<CsvRow>(file, [&](CsvRow row, std::size_t) { read.push_back(std::move(row)); });
    return read;
  }
  std::string Problem(const std::string& rows) const {
    return ErrorMessage([&] { Read(rows); });
  }

  test::TempFolder folder_;
};

TEST_F(CsvRecord, IsReadAsItIsWritten) {
  const std::string rows =
      "9007199254740993,a chair,-7,1.5,-2000,0.1,1,2,3,0,0,0.6,0.8,1,2,3.5,4\n"
      "1,,0,0,0,0,,,,,,,,,,,\n";
  const std::vector<CsvRow> read = Read(rows);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].id, 9007199254740993);
  EXPECT_EQ(read[0].name, "a chair");
  EXPECT_EQ(read[0].p, Eigen::Vector3d(1.5, -2000.0, 0.1));
  EXPECT_EQ(read[0].pose.value().translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(read[0].pose->rotation().w(), 0.8);
  EXPECT_EQ(read[0].box.value().right_px, 3.5);
  EXPECT_FALSE(read[1].pose || read[1].box);
  EXPECT_EQ(CsvLine(read[0]) + CsvLine(read[1]), rows);
  EXPECT_EQ(Read("1,,0,0,0,0,,,,,,,,,,,\r\n").size(), 1U);
  CsvRow bad;
  bad.p.y() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(ErrorMessage([&] { CsvLine(bad); }), HasSubstr("not finite"));
}

TEST_F(CsvRecord, ErrorsNameTheLineAndTheColumn) {
  const std::string empty = ",,,,,,,,,,,\n";
  EXPECT_THAT(Problem("1,a,0,0,0,0" + empty + "3,4"),
              HasSubstr("t.csv:3: found a last line without a line"));
  EXPECT_THAT(Problem("1\n"), HasSubstr("t.csv:2: found 1 cells, expected 17, as line 1"));
  EXPECT_THAT(Problem("\n"), HasSubstr("t.csv:2: found 1 cells"));
  EXPECT_THAT(Problem("1,\xff,0,0,0,0" + empty), HasSubstr("bytes that are no characters"));
  for (const char* cell : {"nan", "inf", "1e999", "", "1 ", "0x1", "one"}) {
    EXPECT_THAT(Problem(StrCat("1,a,0,0,", cell, ",0", empty)),
                HasSubstr("in column y, expected a finite number"))
        << cell;
  }
  EXPECT_THAT(Problem("1,a,3000000000,0,0,0" + empty), HasSubstr("column count, expected a whole"));
  EXPECT_THAT(Problem("1,a,0,0,0,0,1,2,3,0,0,0,,,,,\n"), HasSubstr("in column qw"));
  EXPECT_THAT(Problem("1,a,0,0,0,0,1,2,3,0,0,0,2,,,,\n"), HasSubstr("length is not 1"));
  EXPECT_THAT(Problem("1,a,0,0,0,0,,,,,,,,5,0,4,1\n"), HasSubstr("left > right"));
  const std::string other = folder_.Write("t", "a,b\n");
  EXPECT_THAT(ErrorMessage([&] { CsvFile(other, "a,c"); }),
              HasSubstr("found \"a,b\", expected the header \"a,c\""));
  EXPECT_THAT(ErrorMessage([&] { CsvFile(folder_.Write("t", ""), "a"); }),
              HasSubstr("t:1: found nothing"));
}

}  // namespace
}  // namespace cvo::files_test

namespace cvo {

namespace {

using testing::HasSubstr;

cv::Mat Gradient(int type) {
  cv::Mat image(32, 48, type);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) image.row(v).col(u) = cv::Scalar::all(5 * u + v);
  }
  return image;
}

TEST(ImageFile, LosslessFormatsGiveBackTheImage) {
  const test::TempFolder folder;
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1}) {
    const cv::Mat image = Gradient(type);
    test::WriteImageFile(folder.path() / "a.png", image);
    const cv::Mat read = ReadImageFile(folder.path() / "a.png", cv::IMREAD_UNCHANGED);
    ASSERT_EQ(read.type(), type);
    EXPECT_EQ(cv::norm(read, image, cv::NORM_INF), 0.0);
  }
}

TEST(ImageFile, BytesThatAreNoImageGiveAnEmptyOne) {
  EXPECT_TRUE(DecodeImage("", cv::IMREAD_COLOR).empty());
  EXPECT_TRUE(DecodeImage("no image", cv::IMREAD_COLOR).empty());
  EXPECT_THAT(ErrorMessage([] { ReadImageFile("/no/such.png", cv::IMREAD_COLOR); }),
              HasSubstr("/no/such.png"));
  EXPECT_THAT(ErrorMessage([] { EncodeImage(".none", cv::Mat(4, 4, CV_8UC1)); }),
              HasSubstr("an image to write as .none"));
}

}  // namespace

}  // namespace cvo
