// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The folder of the cache: its size limit, use by several processes, and disk failures.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "core/base/error.h"
#include "core/files/host_name.h"
#include "core/files/text_file.h"
#include "experiments/cache/front_end_cache.h"
#include "tests/experiments/cache/disk.h"
#include "tests/experiments/cache/frames.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::folder_test {
namespace {

namespace fs = std::filesystem;
using test::BytesOf;
using test::Load;
using test::NamesIn;
using test::SomeFrames;
using test::SomeKey;
using test::Store;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::size_t kFrames = 4;

class CacheFolderTest : public testing::Test {
 protected:
  FrontEndCache Cache(const fs::path& folder, std::uint64_t limit_bytes = 1'000'000) {
    return {folder, limit_bytes, [this](const std::string& line) { notices_.push_back(line); }};
  }
  FrontEndCache Cache(std::uint64_t limit_bytes = 1'000'000) {
    return Cache(temp_.path(), limit_bytes);
  }
  fs::path FileOf(const std::string& key) const { return temp_.path() / (key + ".features"); }

  // Sets the last use of a file to `seconds` ago.
  static void Age(const fs::path& file, time_t seconds) {
    timespec times[2] = {{0, UTIME_OMIT}, {::time(nullptr) - seconds, 0}};
    ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
  }

  test::TempFolder temp_;
  std::vector<std::string> notices_;
  const std::vector<FrontEndFrame> frames_ = SomeFrames(kFrames);
};

TEST_F(CacheFolderTest, LeastRecentlyUsedIsRemovedFirst) {
  Store(Cache(), SomeKey('a'), frames_);
  Store(Cache(), SomeKey('b'), frames_);
  Store(Cache(), SomeKey('c'), frames_);
  const std::uint64_t size_bytes = fs::file_size(FileOf(SomeKey('a')));
  Age(FileOf(SomeKey('a')), 300);
  Age(FileOf(SomeKey('b')), 200);
  Age(FileOf(SomeKey('c')), 100);
  EXPECT_TRUE(Cache().Find(SomeKey('a'), kFrames));  // marks it as just used
  Store(Cache(3 * size_bytes), SomeKey('d'), frames_);
  EXPECT_THAT(NamesIn(temp_.path()),
              ElementsAre(SomeKey('a') + ".features", SomeKey('c') + ".features",
                          SomeKey('d') + ".features"));
  Store(Cache(size_bytes), SomeKey('e'), frames_);
  EXPECT_THAT(NamesIn(temp_.path()), ElementsAre(SomeKey('e') + ".features"));
  EXPECT_THAT(notices_, IsEmpty());
}

TEST_F(CacheFolderTest, AnEntryAboveTheLimitIsNotStored) {
  Store(Cache(), SomeKey('a'), frames_);
  const std::uint64_t size_bytes = fs::file_size(FileOf(SomeKey('a')));
  Store(Cache(size_bytes), SomeKey('b'), SomeFrames(40));
  EXPECT_THAT(NamesIn(temp_.path()), SizeIs(1));
  ASSERT_THAT(notices_, SizeIs(1));
  EXPECT_THAT(notices_[0], HasSubstr(StrCat("the cache may have ", size_bytes)));
  Store(Cache(0), SomeKey('b'), frames_);  // disabled on request: no notice
  EXPECT_THAT(notices_, SizeIs(1));
}

TEST_F(CacheFolderTest, AnExistingEntryIsKept) {
  FrontEndRecording late = Cache().Record();
  late.Add(frames_[0]);
  Store(Cache(), SomeKey('a'), frames_);
  struct stat before {};
  ASSERT_EQ(::stat(FileOf(SomeKey('a')).c_str(), &before), 0);
  late.Finish(SomeKey('a'));
  struct stat after {};
  ASSERT_EQ(::stat(FileOf(SomeKey('a')).c_str(), &after), 0);
  EXPECT_EQ(after.st_ino, before.st_ino);
  EXPECT_EQ(Load(Cache(), SomeKey('a'), kFrames), BytesOf(frames_));
}

TEST_F(CacheFolderTest, OnlyTemporariesOfDeadWritersAreRemoved) {
  const fs::path dead = temp_.Write(StrCat(".new.tmp-", HostName(), ".9999999-0"), "half");
  FrontEndRecording live = Cache().Record();
  live.Add(frames_[0]);
  Store(Cache(), SomeKey('a'), frames_);
  EXPECT_FALSE(fs::exists(dead));
  for (std::size_t i = 1; i < kFrames; ++i) live.Add(frames_[i]);
  live.Finish(SomeKey('b'));
  EXPECT_EQ(Load(Cache(), SomeKey('b'), kFrames), BytesOf(frames_));
  EXPECT_THAT(notices_, IsEmpty());
}

TEST_F(CacheFolderTest, ManyProcessesWriteReadAndEvictAtOnce) {
  Store(Cache(), SomeKey('a'), frames_);
  const std::uint64_t size_bytes = fs::file_size(FileOf(SomeKey('a')));
  const std::string expected = BytesOf(frames_);
  std::vector<pid_t> children;
  for (int child = 0; child < 6; ++child) {
    const pid_t pid = ::fork();
    ASSERT_GE(pid, 0);
    if (pid != 0) {
      children.push_back(pid);
      continue;
    }
    // There is room for two of three entries, so that entries come and go while others are read.
    const FrontEndCache cache = Cache(2 * size_bytes);
    bool fine = true;
    for (int round = 0; round < 10; ++round) {
      const std::string key = SomeKey(static_cast<char>('a' + (child + round) % 3));
      Store(cache, key, frames_);
      const std::string loaded = Load(cache, key, kFrames);
      fine = fine && (loaded.empty() || loaded == expected);
    }
    ::_exit(fine && notices_.empty() ? 0 : 1);
  }
  for (const pid_t pid : children) {
    int status = -1;
    ASSERT_EQ(::waitpid(pid, &status, 0), pid);
    EXPECT_EQ(status, 0);
  }
  EXPECT_THAT(NamesIn(temp_.path()), testing::Each(testing::EndsWith(".features")));
}

TEST_F(CacheFolderTest, AKilledWriterLeavesNoEntry) {
  const pid_t pid = ::fork();
  ASSERT_GE(pid, 0);
  if (pid == 0) {
    FrontEndRecording recording = Cache().Record();
    for (const FrontEndFrame& frame : frames_) recording.Add(frame);
    ::kill(::getpid(), SIGKILL);
  }
  ASSERT_EQ(::waitpid(pid, nullptr, 0), pid);
  ASSERT_THAT(NamesIn(temp_.path()), SizeIs(1));
  Store(Cache(), SomeKey('a'), frames_);
  EXPECT_THAT(NamesIn(temp_.path()), ElementsAre(SomeKey('a') + ".features"));
}

TEST_F(CacheFolderTest, AFullDiskOnlyEndsTheRecording) {
  const test::SmallDisk disk(temp_.path() / "disk", "16k");
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  const FrontEndCache cache = Cache(disk.path());
  Store(cache, SomeKey('a'), frames_);
  Store(cache, SomeKey('b'), SomeFrames(200));
  ASSERT_THAT(notices_, SizeIs(1));
  EXPECT_THAT(notices_[0], HasSubstr(std::strerror(ENOSPC)));
  EXPECT_THAT(NamesIn(disk.path()), ElementsAre(SomeKey('a') + ".features"));
  EXPECT_EQ(Load(cache, SomeKey('a'), kFrames), BytesOf(frames_));
}

TEST_F(CacheFolderTest, AReadOnlyFolderIsReadable) {
  const test::SmallDisk disk(temp_.path() / "disk", "64k");
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  const FrontEndCache cache = Cache(disk.path());
  Store(cache, SomeKey('a'), frames_);
  Store(cache, SomeKey('b'), frames_);
  fs::resize_file(disk.path() / (SomeKey('b') + ".features"), 100);
  ASSERT_TRUE(disk.MakeReadOnly());
  EXPECT_EQ(Load(cache, SomeKey('a'), kFrames), BytesOf(frames_));
  EXPECT_THAT(notices_, IsEmpty());
  EXPECT_EQ(Load(cache, SomeKey('b'), kFrames), "");
  ASSERT_THAT(notices_, SizeIs(1));
  EXPECT_THAT(notices_[0], HasSubstr("cannot remove it"));
  Store(cache, SomeKey('c'), frames_);
  ASSERT_THAT(notices_, SizeIs(2));
  EXPECT_THAT(notices_[1], HasSubstr(std::strerror(EROFS)));
}

TEST_F(CacheFolderTest, AFileInPlaceOfTheFolderOnlyCausesNotices) {
  const fs::path file = temp_.Write("frontend", "");
  EXPECT_FALSE(Cache(file).Find(SomeKey('a'), kFrames));
  Store(Cache(file), SomeKey('a'), frames_);
  EXPECT_FALSE(notices_.empty());
}

TEST(CacheLimit, ReadsSizes) {
  EXPECT_EQ(CacheLimit("0"), 0U);
  EXPECT_EQ(CacheLimit("12"), 12U);
  EXPECT_EQ(CacheLimit("1.5K"), 1500U);
  EXPECT_EQ(CacheLimit("20G"), 20'000'000'000U);
  for (const char* bad : {"G", "-1", "20g", "1e30", "20 G", "nan"}) {
    EXPECT_THAT(ErrorMessage([&] { (void)CacheLimit(bad); }), HasSubstr("--cache-size")) << bad;
  }
  ASSERT_EQ(::setenv("CLUSTERVO_CACHE_SIZE", "3M", 1), 0);
  EXPECT_EQ(CacheLimit(""), 3'000'000U);
  EXPECT_EQ(CacheLimit("5"), 5U);
  ASSERT_EQ(::setenv("CLUSTERVO_CACHE_SIZE", "much", 1), 0);
  EXPECT_THAT(ErrorMessage([] { (void)CacheLimit(""); }), HasSubstr("CLUSTERVO_CACHE_SIZE"));
  ASSERT_EQ(::unsetenv("CLUSTERVO_CACHE_SIZE"), 0);
  EXPECT_EQ(CacheLimit(""), 20'000'000'000U);
}

}  // namespace
}  // namespace cvo::folder_test
