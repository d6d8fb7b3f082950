// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the diagnosis of a body in a frame, and its wording.
#include "reports/runs/body_story.h"

#include <gmock/gmock.h>

#include "reports/runs/body_words.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::reports {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int kBody = 3;
constexpr std::int64_t kCluster = 7;

// Returns `count` landmarks on a body, all with this label.
std::vector<LabelledLandmark> On(int body, std::int64_t label, int count) {
  LabelledLandmark landmark;
  landmark.assigned = landmark.inferred = label;
  landmark.truth_body = body;
  return std::vector<LabelledLandmark>(static_cast<std::size_t>(count), landmark);
}

// One frame, in which the body is visible.
struct OneFrame {
  RunDetail run;
  BodyDetail body;
  LandmarksByFrame landmarks;
  Detected detected;

  OneFrame() {
    body.id = kBody;
    body.name = "chair_1";
    body.cluster = kCluster;
    body.truth = {{10, Pose{}}};
    body.visible = {10};
  }
  void Add(int of, std::int64_t label, int count) {
    for (const LabelledLandmark& landmark : On(of, label, count)) {
      landmarks[10].push_back(landmark);
    }
  }
  void Estimate(double error_m) {
    body.estimated = {{10, {}, error_m}};
    Report(kCluster);
  }
  void Report(std::int64_t id) {
    ClusterRow row;
    row.frame = 10;
    row.id = id;
    run.clusters.push_back(row);
  }
  BodyStory Story() const { return TellStory(run, body, landmarks, detected); }
  BodyStage Stage() const { return Story().frames.at(0).stage; }
};

TEST(BodyStory, AnEstimateIsGoodOrItsMotionIsWrong) {
  OneFrame frame;
  frame.Add(kBody, kCluster, 20);
  frame.Estimate(0.09);
  EXPECT_EQ(frame.Stage(), BodyStage::kGood);
  frame.Estimate(0.11);
  EXPECT_EQ(frame.Stage(), BodyStage::kMotion);
  frame.Add(0, kCluster, 10);
  EXPECT_EQ(frame.Stage(), BodyStage::kLabel);
  frame.Add(4, kCluster, 30);
  EXPECT_EQ(frame.Stage(), BodyStage::kJoined);
  EXPECT_EQ(frame.Story().frames[0].other_body, 4);
  frame.body.visible.clear();
  EXPECT_EQ(frame.Stage(), BodyStage::kHidden);
}

TEST(BodyStory, WithoutAnEstimateNamesTheFirstFailedStage) {
  OneFrame frame;
  frame.Add(kBody, 0, 2);
  EXPECT_EQ(frame.Stage(), BodyStage::kNoLandmarks);
  frame.Add(kBody, 0, 8);
  EXPECT_EQ(frame.Stage(), BodyStage::kLabel);
  frame.detected[10] = false;
  EXPECT_EQ(frame.Stage(), BodyStage::kNoDetection);
  frame.detected[10] = true;
  EXPECT_EQ(frame.Stage(), BodyStage::kLabel);
  frame.Add(kBody, 9, 5);
  EXPECT_EQ(frame.Stage(), BodyStage::kUnconfirmed);
  frame.Report(9);
  EXPECT_EQ(frame.Stage(), BodyStage::kIdentity);
}

TEST(BodyStory, ClusterMayBeJoinedWithAnotherBody) {
  OneFrame frame;
  frame.Add(kBody, 9, 6);
  frame.Add(4, 9, 20);
  EXPECT_EQ(frame.Stage(), BodyStage::kJoined);
  frame.Add(kBody, 0, 7);
  EXPECT_EQ(frame.Stage(), BodyStage::kLabel);
}

TEST(BodyStory, ComparesTheWrongLabelWithTheTrueOne) {
  OneFrame frame;
  frame.Add(kBody, kCluster, 10);
  frame.Estimate(0.01);
  LabelledLandmark wrong = On(kBody, 0, 1)[0];
  wrong.second = kCluster;
  wrong.energies = {0.1, 0.2, 0.3};
  wrong.second_energies = {2.1, 0.2, 0.1};
  frame.landmarks[10].push_back(wrong);
  wrong.second = -1;
  frame.landmarks[10].push_back(wrong);
  const BodyStory story = frame.Story();
  const LabelContest& contest = story.frames[0].contest;
  EXPECT_EQ(contest.wrong, 2);
  EXPECT_EQ(contest.label, 0);
  EXPECT_EQ(contest.told, 1);
  EXPECT_THAT(FrameLines(story, story.frames[0], {}),
              Contains(HasSubstr("static 0.1 + 0.2 + 0.3 = 0.6, cluster 7 2.1 + 0.2 + 0.1 = 2.4")));
  EXPECT_THAT(FrameLines(story, story.frames[0], {}), Contains(HasSubstr("the 2D boxes decide")));
}

// Frames 10 to 29: not estimated, good, 12 cm off, good, lost, good; hidden in one lost frame.
BodyStory LongStory() {
  OneFrame frame;
  frame.body.truth.clear();
  frame.body.visible.clear();
  for (int i = 10; i < 30; ++i) {
    frame.body.truth.emplace_back(i, Pose{});
    if (i != 22) frame.body.visible.push_back(i);
    frame.landmarks[i] = On(kBody, i < 12 || (i >= 20 && i < 25) ? 0 : kCluster, 12);
    if (i < 12 || (i >= 20 && i < 25)) continue;
    frame.body.estimated.push_back({i, {}, i == 16 || i == 17 ? 0.12 : 0.02});
  }
  return frame.Story();
}

TEST(BodyStory, HasEventsForFoundLostWrongAndWorst) {
  const BodyStory story = LongStory();
  EXPECT_EQ(story.Judged(), 19);
  EXPECT_EQ(story.Count(BodyStage::kLabel), 6);
  EXPECT_EQ(story.Cause(), BodyStage::kLabel);
  std::vector<std::string> events;
  for (const BodyEvent& event : story.events) {
    events.push_back(StrCat(event.frame, " ", event.what));
  }
  EXPECT_THAT(events,
              ElementsAre("10 visible, not estimated for 2 frames from 10 on: label wrong",
                          "12 first estimated",
                          "16 off by more than 10 cm for 2 frames from 16 on: motion wrong, worst "
                          "error, 12 cm",
                          "20 lost for 4 frames from 20 on: label wrong", "25 found again"));
  EXPECT_THAT(StoryLines(story), Contains("frames by failed stage: label wrong 6, motion wrong 2"));
}

TEST(ReadLabelledLandmarks, NeedsTheSecondLabel) {
  const test::TempFolder folder;
  folder.Write("old.csv", "frame,cluster,inferred,energy_2d,energy_3d,energy_motion,truth_body\n");
  EXPECT_THAT(ErrorMessage([&] { ReadLabelledLandmarks(folder.path() / "old.csv"); }),
              HasSubstr("found no column \"second\""));
  folder.Write("new.csv",
               "frame,cluster,inferred,energy_2d,energy_3d,energy_motion,truth_body,second,"
               "second_2d,second_3d,second_motion\n4,7,,1,2,3,,0,4,5,6\n");
  const LandmarksByFrame landmarks = ReadLabelledLandmarks(folder.path() / "new.csv");
  const LabelledLandmark& landmark = landmarks.at(4).at(0);
  EXPECT_EQ(landmark.assigned, 7);
  EXPECT_EQ(landmark.inferred, -1);
  EXPECT_EQ(landmark.truth_body, -1);
  EXPECT_EQ(landmark.second, 0);
  EXPECT_THAT(landmark.second_energies, ElementsAre(4, 5, 6));
}

}  // namespace
}  // namespace cvo::reports
