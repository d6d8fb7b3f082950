// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0

#include "experiments/metrics/boxes/average_precision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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

// All cars are found, with distinct, equal or no scores. From 41 labels on, the devkit's thresholds
// fill every slot.
TEST(AveragePrecision, IsOneIfAllAreFound) {
  const std::array<std::function<ObjectBox(int)>, 3> detections = {
      [](int i) { return Scored(Box("Car", 0), 1.0 - 0.01 * i); },
      [](int) { return Scored(Box("Car", 0), 0.3); }, [](int) { return Box("Car", 0); }};
  for (const auto& detection : detections) {
    for (const int count : {1, 2, 10, 39, 40, 41, 42, 50, 61, 200}) {
      std::vector<ApFrame> frames;
      for (int i = 0; i < count; ++i) frames.push_back({{Box("Car", 0)}, {detection(i)}});
      for (const AveragePrecision& level : EvaluateAp(frames, {})) {
        EXPECT_EQ(level.ap11, 1.0) << count;  // not above 1, as a sum of rounded terms would be
        EXPECT_DOUBLE_EQ(level.ap40, 1.0) << count;
        EXPECT_EQ(level.valid_labels, count);
      }
    }
  }
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

// In bird's-eye view, DontCare regions, which have no 3D box, excuse nothing.
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

// Twenty of forty cars are found, and a false positive ranks 16th. Up to recall 1/2, each slot has
// the highest precision at its own threshold or a later one.
TEST(AveragePrecision, PrecisionFallsWithRecall) {
  std::vector<ApFrame> frames(40, kMissed);
  for (int i = 0; i < 20; ++i) {
    frames[static_cast<std::size_t>(i)].detections = {Scored(Box("Car", 0), 1.0 - 0.01 * i)};
  }
  frames[30].detections = {Scored(Box("Car", 500), 0.855)};  // ranks 16th
  const AveragePrecision ap = Moderate(frames);
  EXPECT_DOUBLE_EQ(ap.precision[15], 1.0);
  EXPECT_DOUBLE_EQ(ap.precision[16], 20.0 / 21.0);
  EXPECT_DOUBLE_EQ(ap.precision[20], 20.0 / 21.0);
  EXPECT_DOUBLE_EQ(ap.precision[21], 0.0);
  EXPECT_NEAR(ap.ap40, (15.0 + 5.0 * 20.0 / 21.0) / 40.0, 1e-12);
  EXPECT_NEAR(ap.ap11, (4.0 + 2 * 20.0 / 21.0) / 11.0, 1e-12);
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
  EXPECT_EQ(Moderate({frame, kFound}).precision[21], 0.0);
  frame.detections = {Scored(Box("Car", 500, 50, 26.0), 0.92)};
  EXPECT_EQ(Moderate({frame, kFound}).precision[0], 0.5) << "false, and not small";
}

}  // namespace
}  // namespace cvo::average_precision_test

namespace cvo::box_overlap_test {
namespace {

constexpr double kPi = 3.14159265358979323846;

ObjectBox ImageBox(double left, double top, double right, double bottom) {
  ObjectBox box;
  box.left_px = left;
  box.top_px = top;
  box.right_px = right;
  box.bottom_px = bottom;
  return box;
}

ObjectBox Solid(double x, double y, double z, double heading, double length = 4.0,
                double width = 2.0, double height = 1.5) {
  ObjectBox box;
  box.box3d = ObjectBox::Box3d{height, width, length, {x, y, z}, heading};
  return box;
}

TEST(BoxOverlap, InTheImage) {
  const ObjectBox a = ImageBox(0, 0, 10, 10);
  const ObjectBox b = ImageBox(5, 0, 15, 10);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion(BoxSpace::kImage, a, b), 50.0 / 150.0);
  EXPECT_DOUBLE_EQ(ShareInside(ImageBox(0, 0, 10, 10), ImageBox(5, 5, 100, 100)), 0.25);
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kImage, a, ImageBox(10, 0, 20, 10)), 0.0);
  EXPECT_EQ(ShareInside(ImageBox(3, 3, 3, 3), a), 0.0);
}

// At heading 0 the length lies along x.
TEST(BoxOverlap, LengthIsAlongTheHeading) {
  const ObjectBox a = Solid(0, 0, 10, 0.0);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(2, 0, 10, 0.0)), 1.0 / 3.0,
              1e-12);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(0, 0, 11, 0.0)), 1.0 / 3.0,
              1e-12);
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(0, 0, 12.5, 0.0)), 0.0);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(0, 0, 10, kPi / 2)), 4.0 / 12.0,
              1e-12);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kBirdsEye, a, Solid(0, 0, 10, kPi)), 1.0, 1e-12);
}

// A box extends upwards from the centre of its bottom face; y points down.
TEST(BoxOverlap, HeightExtendsUpwardsFromTheBottom) {
  const ObjectBox a = Solid(0, 0, 10, 0.7);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kVolume, a, Solid(0, -0.75, 10, 0.7)), 1.0 / 3.0,
              1e-12);
  const ObjectBox taller = Solid(0, 0, 10, 0.7, 4.0, 2.0, 3.0);
  EXPECT_NEAR(IntersectionOverUnion(BoxSpace::kVolume, a, taller), 0.5, 1e-12);
  EXPECT_EQ(IntersectionOverUnion(BoxSpace::kVolume, a, Solid(0, -1.5, 10, 0.7)), 0.0);
}

}  // namespace
}  // namespace cvo::box_overlap_test
