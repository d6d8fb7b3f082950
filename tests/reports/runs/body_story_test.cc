// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Tests the diagnosis of a body in a frame, and its wording.
#include "reports/runs/body_story.h"

#include <gmock/gmock.h>

namespace cvo::reports {
namespace {

using testing::ElementsAre;

constexpr int kBody = 3;
constexpr std::int64_t kCluster = 7;

// Returns `count` landmarks on a body, all with this label.
std::vector<LabelledLandmark> On(int body, std::int64_t label, int count) {
  LabelledLandmark landmark;
  landmark.label = label;
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
    ObjectRow row;
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

TEST(BodyStory, CountsFramesByStageAndNamesTheCauseAndTheWorst) {
  const BodyStory story = LongStory();
  EXPECT_EQ(story.Judged(), 19);
  EXPECT_EQ(story.Count(BodyStage::kLabel), 6);
  EXPECT_EQ(story.Cause(), BodyStage::kLabel);
  EXPECT_THAT(StoryLines(story),
              testing::IsSupersetOf({"frames by failed stage: label wrong 6, motion wrong 2",
                                     "worst error: 12 cm in frame 16"}));
}

TEST(BodyStory, TimelineHasARowForEachStretchOfAStage) {
  std::vector<std::string> rows;
  for (const TimelineRow& row : TimelineOf(LongStory(), {})) {
    rows.push_back(StrCat(row.frames, " ", row.stage, " ", row.error_cm));
  }
  EXPECT_THAT(rows, ElementsAre("10-11 label wrong -", "12-15 good 2", "16-17 motion wrong 12",
                                "18-19 good 2", "20-21 label wrong -", "23-24 label wrong -",
                                "25-29 good 2"));
}

TEST(BodyStory, TimelineSaysWhatTheLandmarksAreLabelledAs) {
  OneFrame frame;
  frame.Add(kBody, kCluster, 6);
  frame.Add(kBody, 0, 2);
  frame.Add(4, kCluster, 20);
  frame.detected[10] = true;
  frame.Estimate(0.2);
  BodyDetail other;
  other.id = 4;
  other.name = "chair_2";
  const TimelineRow row = TimelineOf(frame.Story(), {frame.body, other}).at(0);
  EXPECT_EQ(row.landmarks, "8: 6 cluster 7 (its own), 2 static; its cluster is mostly on chair_2");
  EXPECT_EQ(row.detected, "1 of 1");
}

}  // namespace
}  // namespace cvo::reports
