// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// `clustervo detect` as a process, with a tiny network that the test writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/experiments/yolo/tiny_network.h"

namespace cvo {
namespace {

using test::ProcessResult;
using testing::HasSubstr;

class Detect : public testing::Test {
 protected:
  Detect() {
    test::WriteTinySequence((folder_.path() / "tiny").string(), 3);
    arguments_ = {"detect",  (folder_.path() / "tiny").string(),
                  "--model", test::WriteTinyNetwork(folder_),
                  "--names", folder_.Write("two.names", "person\ncar\n").string(),
                  "-o",      boxes()};
  }

  std::string boxes() const { return (folder_.path() / "boxes.txt").string(); }
  ProcessResult Run(const std::vector<std::string>& more) const {
    std::vector<std::string> all = arguments_;
    all.insert(all.end(), more.begin(), more.end());
    return test::RunProgram(all);
  }

  test::TempFolder folder_;
  std::vector<std::string> arguments_;
};

// A run accepts the boxes, and a second call writes the same bytes.
TEST_F(Detect, WritesBoxesThatARunReads) {
  const ProcessResult result = Run({"--frames", "1:"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("2 boxes in 2 frames"));
  const std::string rows = test::ReadFile(boxes());
  EXPECT_THAT(rows, testing::StartsWith("1 -1 Car -1 -1 -10 "));
  EXPECT_EQ(Run({"--frames", "1:", "-t", "2"}).exit_code, 0);
  EXPECT_EQ(test::ReadFile(boxes()), rows);
  const ProcessResult run =
      test::RunProgram({"run", (folder_.path() / "tiny").string(), "-o",
                        (folder_.path() / "out").string(), "--detections", boxes()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST_F(Detect, BadInputLeavesNothing) {
  EXPECT_EQ(Run({"--input", "33x64"}).exit_code, 2);
  EXPECT_EQ(Run({"--min-score", "nan"}).exit_code, 2);
  const ProcessResult result = Run({"--weights", folder_.Write("w.weights", "").string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("w.weights: found"));
  EXPECT_FALSE(std::filesystem::exists(boxes()));
}

}  // namespace
}  // namespace cvo
