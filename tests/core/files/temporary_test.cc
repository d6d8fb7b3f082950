// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/files/temporary.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/files/host_name.h"
#include "tests/support/temp_folder.h"

namespace cvo::temporary_test {
namespace {

namespace fs = std::filesystem;

pid_t DeadProcess() {
  const pid_t process = ::fork();
  if (process == 0) ::_exit(0);
  ::waitpid(process, nullptr, 0);
  return process;
}

TEST(Temporary, FilesOfDeadProcessesAreLeftovers) {
  const test::TempFolder temp;
  const auto add = [&temp](const std::string& host, pid_t process) {
    return temp.Write(fs::path(StrCat(".a b.tmp-1.tmp-", host, ".", process, "-0")) / "in", "abc")
        .parent_path();
  };
  const fs::path dead = add(HostName(), DeadProcess());
  const fs::path alive = add(HostName(), ::getppid());
  // Processes of other computers cannot be checked; their files count as leftovers only when old.
  const fs::path elsewhere = add("node-2.cluster", DeadProcess());
  const fs::path long_ago = add("node-3.cluster", DeadProcess());
  fs::last_write_time(long_ago, fs::file_time_type::clock::now() - std::chrono::hours(25));
  const fs::path own = TemporaryName(temp.path() / "a", "0");
  for (const fs::path& path : {dead, alive, elsewhere, long_ago, own}) {
    EXPECT_TRUE(IsTemporary(path)) << path;
  }
  temp.Write(own.filename(), "half");
  const fs::path other = temp.Write(".a.tmp-of mine", "abc");
  EXPECT_FALSE(IsTemporary(other));
  RemoveLeftovers(temp.path());
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_FALSE(fs::exists(long_ago));
  for (const fs::path& path : {alive, elsewhere, own, other}) EXPECT_TRUE(fs::exists(path)) << path;
  RemoveTemporaries(temp.path());
  for (const fs::path& path : {alive, elsewhere, own}) EXPECT_FALSE(fs::exists(path)) << path;
  EXPECT_TRUE(fs::exists(other));
  RemoveLeftovers(temp.path() / "none");
}

}  // namespace
}  // namespace cvo::temporary_test
