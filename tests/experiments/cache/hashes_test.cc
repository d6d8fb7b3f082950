// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Hashes of unchanged files are known without reading them; changed files are always read.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/runner/file_hashes.h"
#include "tests/experiments/cache/disk.h"
#include "tests/experiments/cache/frames.h"
#include "tests/support/temp_folder.h"

namespace cvo::hashes_test {
namespace {

namespace fs = std::filesystem;
using test::NamesIn;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int kFrames = 3;
constexpr std::int64_t kHour_ns = 3'600'000'000'000;

class CacheHashes : public testing::Test {
 protected:
  CacheHashes() {
    sequence_.folder = temp_.path() / "sequence";
    for (int i = 0; i < kFrames; ++i) {
      const std::string name = StrCat(i, ".png");
      sequence_.images.push_back(
          {temp_.Write(fs::path("sequence/image_0") / name, "left " + name),
           temp_.Write(fs::path("sequence/image_1") / name, "right " + name)});
    }
  }

  // Computes the hashes as if it were `later_ns` from now. By default no file counts as recent.
  std::vector<ImageHashes> Hashes(std::int64_t later_ns = kHour_ns) {
    read_ = 0;
    FileHashHooks hooks;
    hooks.notice = [this](const std::string& line) { notices_.push_back(line); };
    hooks.hashed = [this](std::size_t done, std::size_t total) {
      EXPECT_EQ(done, ++read_);
      EXPECT_LE(done, total);
    };
    hooks.now_ns = [later_ns, now = FileHashHooks().now_ns] { return now() + later_ns; };
    TaskPool pool(2);
    return FindImageHashes(sequence_, index(), pool, hooks);
  }
  fs::path index() const { return index_.empty() ? temp_.path() / "hashes" : index_; }
  fs::path KeptFile() const { return index() / NamesIn(index()).at(0); }

  void ExpectRight(const std::vector<ImageHashes>& hashes) {
    ASSERT_THAT(hashes, SizeIs(kFrames));
    for (std::size_t i = 0; i < kFrames; ++i) {
      EXPECT_EQ(hashes[i].left, HashFile(sequence_.images[i].left));
      EXPECT_EQ(hashes[i].right, HashFile(sequence_.images[i].right));
    }
  }

  static timespec ModifiedTime(const fs::path& file) {
    struct stat status {};
    EXPECT_EQ(::stat(file.c_str(), &status), 0);
    return status.st_mtim;
  }
  static void SetModifiedTime(const fs::path& file, const timespec& time) {
    const timespec times[2] = {{0, UTIME_OMIT}, time};
    ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
  }

  test::TempFolder temp_;
  fs::path index_;
  Sequence sequence_;
  std::size_t read_ = 0;
  std::vector<std::string> notices_;
};

TEST_F(CacheHashes, ASecondCallReadsNothing) {
  ExpectRight(Hashes());
  EXPECT_EQ(read_, 2U * kFrames);
  ExpectRight(Hashes());
  EXPECT_EQ(read_, 0U);
  EXPECT_THAT(notices_, IsEmpty());
}

TEST_F(CacheHashes, ChangedBytesOfTheSameLengthAndTimeAreDetected) {
  (void)Hashes();
  const fs::path& image = sequence_.images[1].right;
  const timespec modified = ModifiedTime(image);
  WriteFileBytes(image, "RIGHT 1.png");
  SetModifiedTime(image, modified);
  ExpectRight(Hashes());
  EXPECT_EQ(read_, 2U * kFrames);
  // Replaces the file by renaming, as editors and synchronisation tools do.
  fs::rename(temp_.Write("new", "Right 1.png"), image);
  SetModifiedTime(image, modified);
  ExpectRight(Hashes());
  EXPECT_EQ(read_, 2U * kFrames);
  ExpectRight(Hashes());
  EXPECT_EQ(read_, 0U);
}

TEST_F(CacheHashes, ARecentFileIsReadAgain) {
  ExpectRight(Hashes(0));
  ExpectRight(Hashes(0));
  EXPECT_EQ(read_, 2U * kFrames);
  EXPECT_FALSE(fs::exists(index()));
  (void)Hashes(-kHour_ns);  // the files appear to be from the future
  ExpectRight(Hashes());
  EXPECT_EQ(read_, 2U * kFrames);
}

TEST_F(CacheHashes, OnlyExistingFilesHaveAHash) {
  const std::string bytes = ReadFileBytes(sequence_.images[0].left);
  fs::remove(sequence_.images[0].left);
  EXPECT_EQ(Hashes()[0].left, "");
  WriteFileBytes(sequence_.images[0].left, bytes);
  EXPECT_EQ(Hashes()[0].left, Sha256Hex(bytes));
}

TEST_F(CacheHashes, DamagedHashesAreIgnored) {
  (void)Hashes();
  const std::string whole = ReadFileBytes(KeptFile());
  for (std::size_t i = 0; i < 24; ++i) {
    const std::size_t at = i * whole.size() / 24;
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    WriteFileBytes(KeptFile(), i % 2 == 0 ? damaged : whole.substr(0, at));
    ExpectRight(Hashes());
    EXPECT_EQ(read_, 2U * kFrames) << at;
    EXPECT_EQ(ReadFileBytes(KeptFile()), whole);
  }
}

TEST_F(CacheHashes, APipeHasNoHash) {
  fs::remove(sequence_.images[0].left);
  ASSERT_EQ(::mkfifo(sequence_.images[0].left.c_str(), 0600), 0);
  EXPECT_EQ(Hashes()[0].left, "");
}

TEST_F(CacheHashes, WithoutAnIndexAllFilesAreRead) {
  TaskPool pool(2);
  for (int i = 0; i < 2; ++i) {
    ExpectRight(FindImageHashes(sequence_, "", pool));
  }
}

TEST_F(CacheHashes, AnUnwritableIndexOnlyCostsTime) {
  index_ = temp_.Write("file", "");
  ExpectRight(Hashes());
  EXPECT_THAT(notices_, testing::Contains(HasSubstr("not kept")));
  const test::SmallDisk disk(temp_.path() / "disk", "64k");
  if (!disk.mounted()) GTEST_SKIP() << disk.problem();
  index_ = disk.path();
  ExpectRight(Hashes());
  ASSERT_TRUE(disk.MakeReadOnly());
  notices_.clear();
  ExpectRight(Hashes());
  EXPECT_EQ(read_, 0U);
  temp_.Write("sequence/image_0/0.png", "another one");
  ExpectRight(Hashes());
  EXPECT_EQ(read_, 2U * kFrames);
  EXPECT_THAT(notices_, SizeIs(1));
}

TEST_F(CacheHashes, ManyProcessesShareThem) {
  std::vector<pid_t> children;
  for (int child = 0; child < 6; ++child) {
    const pid_t pid = ::fork();
    ASSERT_GE(pid, 0);
    if (pid != 0) {
      children.push_back(pid);
      continue;
    }
    bool fine = true;
    for (int round = 0; round < 5; ++round) {
      std::error_code ignored;
      if (child == 0) fs::remove_all(index(), ignored);
      fine = fine && Hashes()[1].left == Sha256Hex("left 1.png");
    }
    ::_exit(fine ? 0 : 1);
  }
  for (const pid_t pid : children) {
    int status = -1;
    ASSERT_EQ(::waitpid(pid, &status, 0), pid);
    EXPECT_EQ(status, 0);
  }
  (void)Hashes();
  ExpectRight(Hashes());
  EXPECT_EQ(read_, 0U);
  EXPECT_THAT(NamesIn(index()), SizeIs(1));
}

}  // namespace
}  // namespace cvo::hashes_test
