// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/identity_switches.h"

#include <gmock/gmock.h>

#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::reports {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Returns the rows of `count` landmarks of one cluster on one body in a frame.
std::string Rows(int frame, int count, const std::string& cluster, const std::string& body) {
  std::string rows;
  for (int i = 0; i < count; ++i) {
    rows += std::to_string(frame) + "," + std::to_string(i) + "," + cluster + "," + body + "\n";
  }
  return rows;
}

const std::string kHeader = "frame,id,cluster,truth_body\n";

std::vector<BodyDetail> BodySeenIn(const std::vector<int>& frames) {
  BodyDetail body;
  body.id = 2;
  body.visible = frames;
  return {body};
}

TEST(IdentitySwitches, AreWhereAnotherClusterHasMostLandmarks) {
  const test::TempFolder folder;
  folder.Write("landmarks.csv", kHeader + Rows(1, 5, "7", "2") + Rows(1, 9, "0", "2") +
                                    Rows(1, 9, "8", "3") + Rows(2, 2, "8", "2") +
                                    Rows(3, 4, "7", "2") + Rows(3, 4, "6", "2") +
                                    Rows(4, 4, "8", "2") + Rows(4, 3, "7", "2") +
                                    Rows(5, 9, "9", "2") + Rows(6, 3, "8", "2"));
  const auto switches = ReadIdentitySwitches(folder.path(), BodySeenIn({1, 2, 3, 4, 6}));
  // Frame 2: too few landmarks. Frame 3: a tie, which keeps the last cluster. Frame 5: not visible.
  // Frame 6: cluster 8 as before.
  ASSERT_TRUE(switches);
  ASSERT_EQ(switches->size(), 1U);
  EXPECT_EQ((*switches)[0].frame, 4);
  EXPECT_EQ((*switches)[0].body, 2);
  EXPECT_EQ((*switches)[0].from, 7);
  EXPECT_EQ((*switches)[0].to, 8);
}

TEST(IdentitySwitches, AreNotKnownWithoutLandmarks) {
  const test::TempFolder folder;
  EXPECT_FALSE(ReadIdentitySwitches(folder.path(), BodySeenIn({1})));
}

TEST(IdentitySwitches, ADamagedFileIsAnError) {
  const test::TempFolder folder;
  const auto message = [&] {
    return ErrorMessage(
        [&] { static_cast<void>(ReadIdentitySwitches(folder.path(), BodySeenIn({1}))); });
  };
  folder.Write("landmarks.csv", kHeader + "1,1,7");
  EXPECT_THAT(message(), HasSubstr("whole lines"));
  folder.Write("landmarks.csv", kHeader + "1,1,7\n");
  EXPECT_THAT(message(), AllOf(HasSubstr("landmarks.csv:2"), HasSubstr("3 cells")));
  folder.Write("landmarks.csv", kHeader + "1,1,x,2\n");
  EXPECT_THAT(message(), HasSubstr("column cluster"));
}

}  // namespace
}  // namespace cvo::reports
