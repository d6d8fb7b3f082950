// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>

#include "core/base/error.h"
#include "experiments/jobs/folder_lock.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(FolderLock, AdmitsOneProcessAndNamesIt) {
  const test::TempFolder folder;
  const auto file = folder.path() / "lock";
  std::optional<FolderLock> lock(file);
  EXPECT_THAT(ErrorMessage([&] { const FolderLock second(file); }),
              AllOf(HasSubstr(folder.path().string() + ": found in use by process "),
                    HasSubstr(std::to_string(::getpid()) + " on ")));
  lock.reset();
  EXPECT_EQ(ErrorMessage([&] { const FolderLock second(file); }), "");
}

TEST(FolderLock, IsReleasedWhenItsProcessIsKilled) {
  const test::TempFolder folder;
  const auto file = folder.path() / "lock";
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t holder = ::fork();
  if (holder == 0) {
    const FolderLock lock(file);
    if (::write(ready[1], "x", 1) == 1) ::pause();
    ::_exit(0);
  }
  // Wait until the child holds the lock: an earlier attempt would take it for a moment, and the
  // child would be refused.
  ::close(ready[1]);
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  ::close(ready[0]);
  EXPECT_THAT(ErrorMessage([&] { const FolderLock lock(file); }),
              HasSubstr(StrCat("process ", holder, " on ")));
  ::kill(holder, SIGKILL);
  ::waitpid(holder, nullptr, 0);
  EXPECT_EQ(ErrorMessage([&] { const FolderLock lock(file); }), "");
}

TEST(FolderLock, ReportsWhyItCannotBeTaken) {
  EXPECT_THAT(ErrorMessage([] { const FolderLock lock("/proc/none/lock"); }),
              HasSubstr("/proc/none/lock: cannot write: "));
}

}  // namespace
}  // namespace cvo
