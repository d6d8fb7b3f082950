// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Faults of system calls while a suite runs (disk_calls.cc): a call fails, transfers half of its
// bytes, or the process is killed. The same command must then give the same bytes.
#include <cstdlib>
#include <map>

#include "tests/faults/fault_folder.h"

namespace cvo::disk_test {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;  // content by path
using test::ProcessResult;

struct Fault {
  std::string kind;
  std::string call;
  std::uint64_t number = 0;  // of the call, from 1; 0: none has a fault
};

class DiskFaults : public test::FaultFolder, public testing::WithParamInterface<const char*> {
 protected:
  DiskFaults() {  // one job: each run of the suite is two processes
    folder_.Write("suite.json", R"({"name": "small", "sequences": [{"folder": "wall"}],
      "variants": ["static"], "options": {"orb": {"features": 300}}})");
  }
  ProcessResult RunSuite(const Fault& fault) const {
    WriteFileBytes(At("counter"), std::string(sizeof(std::uint64_t), '\0'));
    const char* sanitizer = std::getenv("ASAN_OPTIONS");
    return test::RunProgram(
        Suite("run", {"-j", "1"}),
        {.environment = {
             StrCat("CLUSTERVO_CACHE=", At("cache")), StrCat("LD_PRELOAD=", CVO_DISK_CALLS),
             StrCat("ASAN_OPTIONS=", sanitizer ? sanitizer : "", ":verify_asan_link_order=0"),
             StrCat("DISK_FAULT=", fault.kind, ",", fault.call, ",", fault.number, ",",
                    At("counter"))}});
  }
  std::uint64_t Calls() const {
    std::uint64_t calls = 0;
    ReadFileBytes(At("counter")).copy(reinterpret_cast<char*>(&calls), sizeof(calls));
    return calls;
  }
  // Every file of the results that does not hold times, without temporary ones of killed processes.
  Files Results() const {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      const std::string name = entry.path().lexically_relative(folder_.path()).string();
      if (!entry.is_regular_file() || !name.starts_with("out/") || name.starts_with("out/lo") ||
          name.ends_with("timing.json") || name.find(".tmp-") != std::string::npos) {
        continue;  // "out/lo": the log and the lock
      }
      files[name] = ReadFileBytes(entry.path());
    }
    return files;
  }
  void Clear() const {
    for (const char* made : {"out", "cache"}) fs::remove_all(At(made));
  }
};

TEST_P(DiskFaults, TheNextRunRepairsThem) {
  constexpr int kKilled = 128 + 9;
  const std::string call = GetParam();
  ASSERT_EQ(RunSuite({"fail", call}).exit_code, 0);
  const Files expected = Results();
  const std::uint64_t calls = Calls();
  ASSERT_GT(calls, 0U);
  const bool has_bytes = call == "read" || call == "write";
  for (const std::string kind : {"fail", "kill", "short"}) {
    if (kind == "short" && !has_bytes) continue;
    const std::uint64_t times = kind == "kill" ? 2 : 1;
    for (std::uint64_t i = 1; i <= times; ++i) {
      const std::uint64_t number = 1 + i * calls / (times + 1);
      SCOPED_TRACE(StrCat(kind, " at ", call, " ", number, " of ", calls));
      Clear();
      const ProcessResult disturbed = RunSuite({kind, call, number});
      EXPECT_THAT(disturbed.exit_code, testing::AnyOf(0, 1, kind == "kill" ? kKilled : 1))
          << disturbed.err;
      EXPECT_THAT(disturbed.err, testing::Not(testing::HasSubstr("internal")));
      const ProcessResult again = RunSuite({"fail", call});
      EXPECT_EQ(again.exit_code, 0) << again.err;
      EXPECT_EQ(Results(), expected);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Calls, DiskFaults,
                         testing::Values("open", "read", "write", "sync", "rename"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace cvo::disk_test
