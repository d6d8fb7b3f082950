// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <functional>

#include "core/base/error.h"
#include "core/files/temporary.h"
#include "tests/support/temp_folder.h"

namespace cvo::atomic_file_test {
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

std::string Problem(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
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
  const std::string problem = Problem([&] {
    const FileSizeLimit limit(1000);
    WriteFilesAtomically(folder.path(), {{"a.json", "new"}, {"b.txt", std::string(5000, 'x')}});
  });
  EXPECT_THAT(problem, AllOf(HasSubstr((folder.path() / "b.txt").string()),
                             HasSubstr("cannot write"), HasSubstr(std::strerror(EFBIG))));
  EXPECT_EQ(test::ReadFile(folder.path() / "a.json"), "old");
  EXPECT_THAT(Names(folder.path()), ElementsAre("a.json"));
}

TEST(WriteFilesAtomically, DiskFull) {
  const test::TempFolder folder;
  const fs::path disk = folder.path() / "disk";
  fs::create_directory(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64k") != 0) {
    GTEST_SKIP() << "cannot mount a small disk: " << std::strerror(errno);
  }
  const std::string problem = Problem([&] {
    WriteFilesAtomically(disk, {{"a.json", "short"}, {"b.txt", std::string(200'000, 'x')}});
  });
  const std::vector<std::string> names = Names(disk);
  ::umount(disk.c_str());
  EXPECT_THAT(problem, AllOf(HasSubstr("b.txt"), HasSubstr(std::strerror(ENOSPC))));
  EXPECT_THAT(names, IsEmpty());
}

TEST(WriteFilesAtomically, MissingFolder) {
  const test::TempFolder folder;
  const std::string problem = Problem([&] {
    WriteFilesAtomically(folder.path() / "none", {{"a.json", "new"}});
  });
  EXPECT_THAT(problem, AllOf(HasSubstr("none/a.json"), HasSubstr(std::strerror(ENOENT))));
}

TEST(WriteFilesAtomically, FolderInsteadOfAFile) {
  const test::TempFolder folder;
  fs::create_directory(folder.path() / "a.json");
  EXPECT_THAT(Problem([&] {
                WriteFilesAtomically(folder.path(), {{"a.json", "new"}});
              }),
              HasSubstr("a.json"));
  EXPECT_THAT(Names(folder.path()), ElementsAre("a.json"));
}

TEST(WriteFilesAtomically, IgnoresTemporariesOfAKilledRun) {
  const test::TempFolder folder;
  const fs::path leftover = TemporaryName(folder.path() / "a.json", "0");
  folder.Write(leftover.filename(), "half");
  WriteFilesAtomically(folder.path(), {{"a.json", "new"}});
  EXPECT_EQ(test::ReadFile(folder.path() / "a.json"), "new");
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

TEST(WriteFilesAtomically, AFailedWriteLeavesNoFolderAndKeepsStaleFiles) {
  const test::TempFolder folder;
  folder.Write("stale", "old");
  EXPECT_NE(Problem([&] {
              const FileSizeLimit limit(1000);
              WriteFilesAtomically(folder.path(),
                                   {{"in/1.txt", "one"}, {"last", std::string(5000, 'x')}},
                                   {"stale"});
            }),
            "");
  EXPECT_THAT(Names(folder.path()), ElementsAre("stale"));
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
  EXPECT_THAT(Problem([&] { const OutputFolder output(folder.path() / "file", {"a.json"}); }),
              HasSubstr("file"));
  EXPECT_THAT(Problem([&] { const OutputFolder output(folder.path() / "file/out", {"a.json"}); }),
              HasSubstr("file"));
  fs::create_directories(folder.path() / "out" / "a.json");
  EXPECT_THAT(Problem([&] { const OutputFolder output(folder.path() / "out", {"a.json"}); }),
              AllOf(HasSubstr("a.json"), HasSubstr("found a folder")));
  EXPECT_THAT(Problem([&] {
                const OutputFolder output(folder.path(), {"a.json", "file/"});
              }),
              AllOf(HasSubstr("file"), HasSubstr("expected a folder or nothing")));
  EXPECT_EQ(Problem([&] { const OutputFolder output(folder.path(), {"a.json", "out/"}); }), "");
  EXPECT_THAT(Problem([] { const OutputFolder output("/proc/none", {"a.json"}); }),
              HasSubstr("/proc/none"));
  EXPECT_NE(Problem([&] {
              const FileSizeLimit limit(100);
              const OutputFolder output(folder.path() / "full", {"a.json"});
            }),
            "");
}

}  // namespace
}  // namespace cvo::atomic_file_test
