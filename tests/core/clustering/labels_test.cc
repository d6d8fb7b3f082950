// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/clustering/label_confidence.h"
#include "core/clustering/label_matching.h"
#include "tests/support/error_message.h"

namespace cvo {
namespace {

constexpr ClusterId kNone{};

// A group of nodes with the same label and the same previous cluster.
struct Group {
  int count;
  int label;
  ClusterId previous;
};

// Labels: static scene, cluster 5, two new boxes, outliers.
std::vector<ClusterId> Match(std::initializer_list<Group> groups) {
  const LabelIdentity labels[] = {{LabelKind::kStatic, kStaticScene},
                                  {LabelKind::kCluster, ClusterId{5}},
                                  {LabelKind::kNewBox, kNone},
                                  {LabelKind::kNewBox, kNone},
                                  {LabelKind::kOutlier, kNone}};
  std::vector<int> label_of_node;
  std::vector<ClusterId> previous_of_node;
  for (const Group& group : groups) {
    label_of_node.insert(label_of_node.end(), group.count, group.label);
    previous_of_node.insert(previous_of_node.end(), group.count, group.previous);
  }
  return MatchLabels(labels, {label_of_node, previous_of_node}, {});
}

std::vector<ClusterId> Expect(ClusterId first_box, ClusterId second_box) {
  return {kStaticScene, ClusterId{5}, first_box, second_box, kNone};
}

TEST(MatchLabels, NewBoxContinuesTheClusterOfItsNodes) {
  EXPECT_EQ(Match({{10, 2, ClusterId{7}}, {5, 2, kNone}, {3, 0, ClusterId{7}}}),
            Expect(ClusterId{7}, kNone));
}

TEST(MatchLabels, RequiresThreeTenthsOfTheUnion) {
  // 3 nodes are shared, of a union of 3 + 5 + 2 and then of 3 + 5 + 3. Nodes without a cluster
  // count in the union.
  EXPECT_EQ(Match({{3, 3, ClusterId{7}}, {5, 3, kNone}, {2, 4, ClusterId{7}}}),
            Expect(kNone, ClusterId{7}));
  EXPECT_EQ(Match({{3, 3, ClusterId{7}}, {5, 3, kNone}, {3, 4, ClusterId{7}}}),
            Expect(kNone, kNone));
}

// Independently, both boxes would take cluster 7. Assigning 8 and 7 shares more nodes in total than
// assigning 7 and none.
TEST(MatchLabels, MatchesBoxesJointly) {
  EXPECT_EQ(Match({{9, 2, ClusterId{7}}, {8, 2, ClusterId{8}}, {8, 3, ClusterId{7}}}),
            Expect(ClusterId{8}, ClusterId{7}));
}

TEST(MatchLabels, OneClusterIsContinuedByOneBox) {
  EXPECT_EQ(Match({{10, 2, ClusterId{7}}, {9, 3, ClusterId{7}}}), Expect(ClusterId{7}, kNone));
  EXPECT_EQ(Match({{10, 2, ClusterId{7}}, {10, 3, ClusterId{7}}}), Expect(ClusterId{7}, kNone));
}

TEST(MatchLabels, BoxWithoutClusteredNodesStaysNew) {
  EXPECT_EQ(Match({{10, 2, kNone}, {10, 0, ClusterId{7}}}), Expect(kNone, kNone));
}

TEST(MatchLabels, NothingToMatch) {
  EXPECT_EQ(Match({}), Expect(kNone, kNone));
  EXPECT_TRUE(MatchLabels({}, {}, {}).empty());
}

TEST(MatchLabels, ANewBoxMayTakeTheClusterOfALabel) {
  EXPECT_EQ(Match({{10, 2, ClusterId{5}}, {2, 1, ClusterId{5}}}),
            (std::vector<ClusterId>{kStaticScene, kNone, ClusterId{5}, kNone, kNone}));
}

TEST(MatchLabels, ALabelWithoutAMatchKeepsItsClusterIfNoOtherTookIt) {
  EXPECT_EQ(Match({{10, 2, ClusterId{7}}, {3, 0, ClusterId{5}}}), Expect(ClusterId{7}, kNone));
}

TEST(MatchLabels, StaticSceneIsNeverTaken) {
  EXPECT_EQ(Match({{10, 2, kStaticScene}, {10, 1, kStaticScene}}), Expect(kNone, kNone));
}

TEST(MatchLabels, RefusesInvalidLabels) {
  EXPECT_NE(ErrorMessage([] { Match({{1, 5, kNone}}); }), "");
  EXPECT_NE(ErrorMessage([] { Match({{1, -1, kNone}}); }), "");
  const LabelIdentity label{};
  const int of_node = 0;
  EXPECT_NE(ErrorMessage([&] { MatchLabels({&label, 1}, {{&of_node, 1}, {}}, {}); }), "");
}

constexpr ClusterId kCar{3};

template <typename Policy>
LabelOutcome Repeat(int times, ClusterId inferred, LabelState& state) {
  LabelOutcome outcome = LabelOutcome::kKept;
  for (int i = 0; i < times; ++i) outcome = Policy::Update(inferred, state);
  return outcome;
}

TEST(CountLabels, YieldsAfterAsManyFramesAsItHeld) {
  LabelState state{kStaticScene, 1};
  EXPECT_EQ(Repeat<CountLabels>(200, kStaticScene, state), LabelOutcome::kKept);
  EXPECT_EQ(Repeat<CountLabels>(200, kCar, state), LabelOutcome::kKept);
  EXPECT_EQ(Repeat<CountLabels>(1, kCar, state), LabelOutcome::kChanged);
}

TEST(TakeLabelsAtOnce, HasNoMemory) {
  LabelState state{kStaticScene, 1};
  EXPECT_EQ(Repeat<TakeLabelsAtOnce>(200, kStaticScene, state), LabelOutcome::kKept);
  EXPECT_EQ(Repeat<TakeLabelsAtOnce>(1, kCar, state), LabelOutcome::kChanged);
  EXPECT_EQ(state.cluster, kCar);
  EXPECT_EQ(state.confidence, 1);
  EXPECT_EQ(Repeat<TakeLabelsAtOnce>(1, kNone, state), LabelOutcome::kRemove);
}

TEST(CountLabels, OutliersLowerConfidenceUntilTheLandmarkIsRemoved) {
  LabelState state{kCar, 3};
  EXPECT_EQ(Repeat<CountLabels>(2, kNone, state), LabelOutcome::kKept);
  EXPECT_EQ(state.cluster, kCar);
  EXPECT_EQ(state.confidence, 1);
  EXPECT_EQ(Repeat<CountLabels>(1, kNone, state), LabelOutcome::kRemove);
  EXPECT_EQ(state.cluster, kCar);
}

TEST(CountLabels, NewLandmarkTakesItsFirstLabel) {
  LabelState state;
  EXPECT_EQ(Repeat<CountLabels>(1, kCar, state), LabelOutcome::kChanged);
  EXPECT_EQ(state.cluster, kCar);
  state = {};
  EXPECT_EQ(Repeat<CountLabels>(1, kNone, state), LabelOutcome::kRemove);
}

}  // namespace
}  // namespace cvo
