// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/metrics/boxes/average_precision.h"

#include <gtest/gtest.h>

namespace cvo::average_precision_test {
namespace {

// A fully visible, untruncated box at the top edge of the image.
ObjectBox Box(const std::string& type, double left_px, double width_px = 50.0,
              double height_px = 50.0) {
  ObjectBox box;
  box.type = type;
  box.truncation = 0.0;
  box.occlusion = 0;
  box.left_px = left_px;
  box.right_px = left_px + width_px;
  box.bottom_px = height_px;
  return box;
}

ObjectBox Scored(ObjectBox box, double score) {
  box.score = score;
  return box;
}

AveragePrecision Moderate(const std::vector<ApFrame>& frames, const ApProtocol& protocol = {}) {
  return EvaluateAp(frames, protocol)[1];
}

// A frame with a detected car, and one with a missed car.
const ApFrame kFound = {{Box("Car", 0)}, {Scored(Box("Car", 0), 0.9)}};
const ApFrame kMissed = {{Box("Car", 0)}, {}};

// All cars are found, with distinct scores; 41 or more true positives fill every slot.
TEST(AveragePrecision, IsOneIfAllAreFound) {
  std::vector<ApFrame> frames;
  for (int i = 0; i < 50; ++i) {
    frames.push_back({{Box("Car", 0)}, {Scored(Box("Car", 0), 1.0 - 0.01 * i)}});
  }
  for (const AveragePrecision& level : EvaluateAp(frames, {})) {
    EXPECT_EQ(level.ap11, 1.0);  // not above 1, as a sum of rounded terms would be
    EXPECT_DOUBLE_EQ(level.ap40, 1.0);
    EXPECT_EQ(level.valid_labels, 50);
  }
}

// The known artefact of 11-point AP: a single true positive scores 1/11, but 0 with 40 points.
TEST(AveragePrecision, ASingleTruePositiveFillsOnlyTheFirstSlot) {
  std::vector<ApFrame> frames(100, kMissed);
  frames[3] = kFound;
  const AveragePrecision ap = Moderate(frames);
  EXPECT_DOUBLE_EQ(ap.ap11, 1.0 / 11.0);
  EXPECT_DOUBLE_EQ(ap.ap40, 0.0);
}

// Half of 80 cars are found, and every second detection by score is false: the precision is 1/2 up
// to recall 1/2.
TEST(AveragePrecision, FalseDetectionsHalveThePrecision) {
  std::vector<ApFrame> frames(80, kMissed);
  for (int i = 0; i < 40; ++i) {
    const double score = 1.0 - 0.01 * i;
    frames[static_cast<std::size_t>(i)].detections = {Scored(Box("Car", 500), score),
                                                      Scored(Box("Car", 0), score)};
  }
  const AveragePrecision ap = Moderate(frames);
  EXPECT_DOUBLE_EQ(ap.precision[0], 0.5);
  EXPECT_DOUBLE_EQ(ap.ap40, 0.25);
}

TEST(AveragePrecision, LabelsBeyondTheLevelAreIgnored) {
  ObjectBox small = Box("Car", 0, 50.0, 30.0);
  ObjectBox hidden = Box("Car", 100);
  hidden.occlusion = 2;
  ObjectBox cut = Box("Car", 200);
  cut.truncation = 0.4;
  const std::vector<ApFrame> frames = {{{small, hidden, cut, Box("Car", 300)}, {}}};
  const auto levels = EvaluateAp(frames, {});
  EXPECT_EQ(levels[0].valid_labels, 1);
  EXPECT_EQ(levels[1].valid_labels, 2);
  EXPECT_EQ(levels[2].valid_labels, 4);
  ApProtocol truncated;
  truncated.truncation = TruncationRule::kIgnored;
  EXPECT_EQ(EvaluateAp(frames, truncated)[1].valid_labels, 3);
}

// A label of exactly the minimum height is valid; the height of a detection is first truncated to
// whole pixels.
TEST(AveragePrecision, HeightLimits) {
  EXPECT_EQ(Moderate({{{Box("Car", 0, 50, 25.0)}, {}}}).valid_labels, 1);
  EXPECT_EQ(Moderate({{{Box("Car", 0, 50, 24.99)}, {}}}).valid_labels, 0);
  const auto precision_beside = [](double height_px) {
    ApFrame frame = kFound;
    frame.detections.push_back(Scored(Box("Car", 500, 50, height_px), 0.95));
    return Moderate({frame}).precision[0];
  };
  EXPECT_EQ(precision_beside(24.99), 1.0);
  EXPECT_EQ(precision_beside(25.0), 0.5);
}

TEST(AveragePrecision, NeighboursAndOtherClasses) {
  const auto precision_beside = [](const ObjectBox& label, const ObjectBox& detection) {
    ApFrame frame = kFound;
    frame.labels.push_back(label);
    frame.detections.push_back(Scored(detection, 0.95));
    return Moderate({frame}).precision[0];
  };
  EXPECT_EQ(precision_beside(Box("Van", 500), Box("Car", 500)), 1.0);
  EXPECT_EQ(precision_beside(Box("Truck", 500), Box("Car", 500)), 0.5);
  EXPECT_EQ(precision_beside(Box("Truck", 500), Box("Truck", 500)), 1.0);
  ApProtocol walkers;
  walkers.category = "Pedestrian";
  const ApFrame sitting = {{Box("Pedestrian", 0), Box("Person", 500), Box("Person_sitting", 900)},
                           {Scored(Box("Pedestrian", 0), 0.9), Scored(Box("Pedestrian", 500), 1.0),
                            Scored(Box("Pedestrian", 900), 1.0)}};
  EXPECT_EQ(Moderate({sitting}, walkers).precision[0], 1.0);
}

TEST(AveragePrecision, DontCareRegionsForgiveDetectionsInside) {
  ApFrame frame = kFound;
  frame.labels.push_back(Box("DontCare", 480, 200));
  frame.detections.push_back(Scored(Box("Car", 500), 0.95));
  EXPECT_EQ(Moderate({frame}).precision[0], 1.0);
  frame.detections.back() = Scored(Box("Car", 650), 0.95);  // 60 % inside
  EXPECT_EQ(Moderate({frame}).precision[0], 0.5);
}

// In bird's-eye view, DontCare regions apply by their image boxes, and only if the protocol asks
// for it.
TEST(AveragePrecision, DontCareInBirdsEyeView) {
  const ObjectBox::Box3d near = {1.5, 1.6, 3.9, {0, 0, 10}, 0};
  const ObjectBox::Box3d far = {1.5, 1.6, 3.9, {0, 0, 40}, 0};
  ApFrame frame = kFound;
  frame.labels[0].box3d = near;
  frame.detections[0].box3d = near;
  frame.labels.push_back(Box("DontCare", 480, 200));
  frame.detections.push_back(Scored(Box("Car", 500), 0.95));
  frame.detections.back().box3d = far;
  ApProtocol protocol;
  protocol.space = BoxSpace::kBirdsEye;
  EXPECT_EQ(Moderate({frame}, protocol).precision[0], 0.5);
  protocol.dont_care = DontCareRule::kAll;
  EXPECT_EQ(Moderate({frame}, protocol).precision[0], 1.0);
}

// The score of a true positive is that of the highest-scoring box on its label. At a threshold, the
// label takes the box of largest overlap, and an ignored box only if there is no other.
TEST(AveragePrecision, WhichDetectionALabelTakes) {
  ApFrame frame = {{Box("Car", 0)},
                   {Scored(Box("Car", 5), 0.9), Scored(Box("Car", 0), 0.5),
                    Scored(Box("Truck", 0, 50, 24.0), 1.0)}};
  const AveragePrecision ap = Moderate({frame});
  EXPECT_EQ(ap.precision[0], 1.0);  // at score 0.9: one car, and the truck is ignored
  frame.labels[0] = Box("Car", 0, 50, 26.0);
  frame.detections = {Scored(Box("Truck", 0, 50, 24.5), 1.0), Scored(Box("Car", 0, 50, 26.0), 0.5)};
  // The small box ranks first and takes the label without leaving a score: there is no threshold,
  // and nothing is found.
  EXPECT_EQ(Moderate({frame}).precision[0], 0.0);
}

TEST(AveragePrecision, OverlapMustExceedTheLimit) {
  ApProtocol protocol;
  protocol.least_overlap = 0.5;
  ApFrame frame = {{Box("Car", 0, 100)}, {Scored(Box("Car", 0, 50), 1.0)}};
  EXPECT_EQ(Moderate({frame}, protocol).precision[0], 0.0);
  protocol.least_overlap = 0.499;
  EXPECT_EQ(Moderate({frame}, protocol).precision[0], 1.0);
}

TEST(AveragePrecision, NothingAtAll) {
  EXPECT_EQ(Moderate({}).ap40, 0.0);
  EXPECT_EQ(Moderate({{{}, {Scored(Box("Car", 0), 1.0)}}}).ap11, 0.0);
}

TEST(AveragePrecision, LimitsOfTheDifficultyLevels) {
  const auto valid = [](int occlusion, double truncation, double height_px) {
    ObjectBox label = Box("Car", 0, 50.0, height_px);
    label.occlusion = occlusion;
    label.truncation = truncation;
    std::array<int, 3> labels{};
    const auto levels = EvaluateAp({{{label}, {}}}, {});
    for (std::size_t k = 0; k < 3; ++k) labels[k] = levels[k].valid_labels;
    return labels;
  };
  using Levels = std::array<int, 3>;
  EXPECT_EQ(valid(0, 0.15, 40.0), (Levels{1, 1, 1}));
  EXPECT_EQ(valid(0, 0.16, 40.0), (Levels{0, 1, 1}));
  EXPECT_EQ(valid(0, 0.30, 40.0), (Levels{0, 1, 1}));
  EXPECT_EQ(valid(0, 0.31, 40.0), (Levels{0, 0, 1}));
  EXPECT_EQ(valid(0, 0.50, 40.0), (Levels{0, 0, 1}));
  EXPECT_EQ(valid(0, 0.51, 40.0), (Levels{0, 0, 0}));
  EXPECT_EQ(valid(0, 0.0, 39.9), (Levels{0, 1, 1}));
  EXPECT_EQ(valid(0, 0.0, 25.0), (Levels{0, 1, 1}));
  EXPECT_EQ(valid(0, 0.0, 24.9), (Levels{0, 0, 0}));
  EXPECT_EQ(valid(1, 0.0, 40.0), (Levels{0, 1, 1}));
  EXPECT_EQ(valid(2, 0.0, 40.0), (Levels{0, 0, 1}));
  EXPECT_EQ(valid(3, 0.0, 40.0), (Levels{0, 0, 0}));
}

// Two overlapping cars, with one box on the first and a higher-scoring one between them. At the
// lower threshold, which a car in another frame sets, each car has a box.
TEST(AveragePrecision, ALabelTakesTheBoxOfLargestOverlap) {
  const ApFrame both = {{Box("Car", 0), Box("Car", 10)},
                        {Scored(Box("Car", 5), 0.9), Scored(Box("Car", 0), 0.5)}};
  const ApFrame other = {{Box("Car", 0)}, {Scored(Box("Car", 0), 0.4)}};
  const AveragePrecision ap = Moderate({both, other});
  EXPECT_EQ(ap.precision[1], 1.0);
  EXPECT_DOUBLE_EQ(ap.ap40, 1.0 / 40.0);
}

// Twenty of forty cars are found, and a false positive ranks 16th. Up to recall 1/2, each slot has
// the highest precision at its own threshold or a later one.
TEST(AveragePrecision, PrecisionFallsWithRecall) {
  std::vector<ApFrame> frames(40, kMissed);
  for (int i = 0; i < 20; ++i) {
    frames[static_cast<std::size_t>(i)].detections = {Scored(Box("Car", 0), 1.0 - 0.01 * i)};
  }
  frames[30].detections = {Scored(Box("Car", 500), 0.855)};  // ranks 16th
  const AveragePrecision ap = Moderate(frames);
  EXPECT_DOUBLE_EQ(ap.precision[14], 1.0);
  EXPECT_DOUBLE_EQ(ap.precision[15], 20.0 / 21.0);
  EXPECT_DOUBLE_EQ(ap.precision[19], 20.0 / 21.0);
  EXPECT_DOUBLE_EQ(ap.precision[20], 0.0);
  EXPECT_NEAR(ap.ap40, (14.0 + 5.0 * 20.0 / 21.0) / 40.0, 1e-12);
  EXPECT_NEAR(ap.ap11, (4.0 + 20.0 / 21.0) / 11.0, 1e-12);
}

// With more true positives than slots, thresholds are those whose recall is nearest to the slot's.
TEST(AveragePrecision, SlotsAreSpreadOverTheRecall) {
  std::vector<ApFrame> frames(200, kMissed);
  for (int i = 0; i < 100; ++i) {
    frames[static_cast<std::size_t>(i)].detections = {Scored(Box("Car", 0), 1.0 - 0.001 * i)};
  }
  frames[150].detections = {Scored(Box("Car", 500), 0.9505)};  // ranks after the first 50
  AveragePrecision ap = Moderate(frames);
  EXPECT_DOUBLE_EQ(ap.precision[0], 1.0);
  EXPECT_DOUBLE_EQ(ap.precision[10], 1.0) << "recall 1/4: 50 of 200";
  EXPECT_NEAR(ap.precision[11], 100.0 / 101.0, 1e-12);
  EXPECT_NEAR(ap.precision[20], 100.0 / 101.0, 1e-12);
  EXPECT_DOUBLE_EQ(ap.precision[21], 0.0);
  frames[150].detections = {Scored(Box("Car", 500), 0.9515)};  // ranks after the first 49
  ap = Moderate(frames);
  EXPECT_DOUBLE_EQ(ap.precision[9], 1.0);
  EXPECT_NEAR(ap.precision[10], 100.0 / 101.0, 1e-12) << "not one before the 50th";
}

// A small box is neither a true nor a false positive, and a car takes it only if it has no other.
// The car in the other frame sets the threshold.
TEST(AveragePrecision, IgnoredBoxesAreTakenLast) {
  const ObjectBox small = Scored(Box("Car", 0, 50, 24.5), 0.95);
  ApFrame frame = {{Box("Car", 0, 50, 26.0)}, {small, Scored(Box("Car", 0, 50, 26.0), 0.92)}};
  EXPECT_EQ(Moderate({frame, kFound}).precision[0], 1.0);
  frame.detections = {small};
  EXPECT_EQ(Moderate({frame, kFound}).precision[0], 1.0);
  EXPECT_EQ(Moderate({frame, kFound}).precision[1], 0.0);
  frame.detections = {Scored(Box("Car", 500, 50, 26.0), 0.92)};
  EXPECT_EQ(Moderate({frame, kFound}).precision[0], 0.5) << "false, and not small";
}

TEST(AveragePrecision, BoxesWithoutAScoreRankFirst) {
  const ApFrame frame = {{Box("Car", 0)}, {Box("Car", 0), Scored(Box("Car", 500), 0.99)}};
  EXPECT_EQ(Moderate({frame}).precision[0], 1.0);
  const ApFrame equal = {{Box("Car", 0)}, {Box("Car", 0), Scored(Box("Car", 500), 1.0)}};
  EXPECT_EQ(Moderate({equal}).precision[0], 0.5);
}

}  // namespace
}  // namespace cvo::average_precision_test
