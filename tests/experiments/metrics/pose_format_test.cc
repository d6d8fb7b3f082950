// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/metrics/trajectory.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::pose_format_test {
namespace {

using testing::HasSubstr;

constexpr const char* kTum = "1.5 0 0 0 0 0 0 1\n";
constexpr const char* kKitti = "1 0 0 4 0 1 0 5 0 0 1 6\n";

class PoseFormat : public testing::Test {
 protected:
  std::string Detected(const std::string& text) {
    return DetectPoseFormat(folder_.Write("poses.txt", text));
  }
  std::string Refused(const std::string& text) {
    return ErrorMessage([&] { Detected(text); });
  }
  test::TempFolder folder_;
};

TEST_F(PoseFormat, IsDetectedFromTheFirstNonCommentLine) {
  EXPECT_EQ(Detected(kTum), "tum");
  EXPECT_EQ(Detected(kKitti), "kitti");
  EXPECT_EQ(Detected(std::string("# 1 2 3\n\n  #4 5\n") + kTum), "tum");
  EXPECT_EQ(Detected(std::string("\n") + kKitti + kTum), "kitti");
  EXPECT_EQ(Detected("1.5 0 0 0 0 0 0 1 # of frame 3\n"), "tum") << "a comment after the pose";
}

TEST_F(PoseFormat, IsRefusedWithTheLineIfUnknown) {
  for (const auto& [text, columns] : {std::pair("# x\n1 2 3 4 5 6 7\n", ":2: found 7 columns"),
                                      {"1 2 3 4 5 6 7 8 9\n", ":1: found 9 columns"},
                                      {"1 2 3 4 5 6 7 8 9 10 11\n", ":1: found 11 columns"},
                                      {"\n1 2 3 4 5 6 7 8 9 10 11 12 13\n", ":2: found 13 columns"},
                                      {"1\n", ":1: found 1 columns"}}) {
    EXPECT_THAT(Refused(text), HasSubstr(columns));
  }
  EXPECT_THAT(Refused(""), HasSubstr("found no pose"));
  EXPECT_THAT(Refused("# nothing\n\n"), HasSubstr("found no pose"));
}

TEST_F(PoseFormat, FindsTheLineOfAPoseByIndex) {
  const auto path = folder_.Write("poses.txt", std::string("# times\n") + kTum + "\n  # gap\n" +
                                                   "2.5 0 0 0 0 0 0 1\n" + "3.5 0 0 0 0 0 0 1\n");
  EXPECT_EQ(WhereTumPose(path, 0), path.string() + ":2");
  EXPECT_EQ(WhereTumPose(path, 1), path.string() + ":5");
  EXPECT_EQ(WhereTumPose(path, 2), path.string() + ":6");
  EXPECT_THAT(ErrorMessage([&] { WhereTumPose(path, 3); }), HasSubstr("no such pose"));
}

}  // namespace
}  // namespace cvo::pose_format_test
