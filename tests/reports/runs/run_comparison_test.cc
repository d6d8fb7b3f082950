// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/run_comparison.h"

#include <gmock/gmock.h>

#include "tests/reports/results/result_files.h"
#include "tests/support/error_message.h"

namespace cvo::reports {
namespace {

using test::BodyOf;
using test::Json;
using testing::HasSubstr;

constexpr int kFrames = 36;

// Errors from `mean_m` upwards in steps of 1 mm, repeating every six frames.
std::vector<double> ErrorsAround(double mean_m) {
  std::vector<double> errors_m;
  for (int i = 0; i < kFrames; ++i) errors_m.push_back(mean_m + 0.001 * (i % 6));
  return errors_m;
}

class CompareRunsTest : public testing::Test {
 protected:
  std::filesystem::path Write(const std::string& name, const Json& result) const {
    folder_.Write(name + "/result.json", result.dump());
    return folder_.path() / name;
  }
  static Json RunOf(const std::string& variant, const std::vector<Json>& bodies,
                    const std::string& sequence = "room") {
    Json result = test::WithBodies(test::Result(sequence, kFrames), bodies);
    result["variant"] = variant;
    result["frames"] = Json::array();
    return result;
  }
  test::TempFolder folder_;
};

TEST_F(CompareRunsTest, ABodyIsPairedFrameByFrameInBlocks) {
  std::vector<double> late = ErrorsAround(0.05);
  for (int i = 0; i < 6; ++i) late[static_cast<std::size_t>(i)] = -1.0;  // not estimated there
  const RunComparison comparison =
      CompareRuns({Write("a", RunOf("static", {BodyOf(1, ErrorsAround(0.02))})),
                   Write("b", RunOf("full", {BodyOf(1, late)}))});
  ASSERT_EQ(comparison.by_frame.size(), 1U);
  const PairedComparison& body = comparison.by_frame[0];
  EXPECT_EQ(body.what, "body");
  EXPECT_EQ(body.run, "full");
  EXPECT_EQ(body.frames, 30U);
  EXPECT_EQ(BlockLength(30), 5U);
  EXPECT_EQ(body.difference.pairs, 6U);
  EXPECT_NEAR(body.difference.difference, 0.03, 1e-12);
  ASSERT_TRUE(body.difference.interval);
  EXPECT_GT(body.difference.interval->low, 0.0);
  EXPECT_THAT(body.difference.interval->meaning,
              HasSubstr("6 blocks of 5 consecutive frames of this sequence: says nothing"));
  EXPECT_EQ(body.verdict, "worse");
}

// The first run has a jump after the last frame of the second. Over their common frames the runs
// differ only in their world frame: aligned over these frames, neither has an error.
TEST_F(CompareRunsTest, CamerasAreAlignedOverTheFramesOfBoth) {
  const auto write = [&](const std::string& name, int frames, double aside_m) {
    Json result = RunOf(name, {});
    Json truth = {
        {"schema_version", 1}, {"kind", "truth"}, {"job", "a"}, {"camera", Json::array()}};
    for (int i = 0; i < frames; ++i) {
      const double jump_m = i < 12 ? 0.0 : 3.0;
      const double x = 0.1 * i * i;
      truth["camera"].push_back(Json::array({x, 0.2 * i, 0.0, 0.0, 0.0, 0.0, 1.0}));
      result["frames"].push_back(
          {{"frame", i},
           {"timestamp_ns", i + 1},
           {"status", i == 0 ? "first" : "tracked"},
           {"refined", Json::array({x + aside_m, 0.2 * i + jump_m, 0.0, 0.0, 0.0, 0.0, 1.0})}});
    }
    truth["bodies"] = Json::array();
    folder_.Write(name + "/truth.json", truth.dump());
    return Write(name, result);
  };
  const RunComparison comparison = CompareRuns({write("full", 24, 0.5), write("static", 12, 0.0)});
  ASSERT_EQ(comparison.by_frame.size(), 1U);
  const PairedComparison& camera = comparison.by_frame[0];
  EXPECT_EQ(camera.what, "camera");
  EXPECT_EQ(camera.metric, "camera_ate_mean");
  EXPECT_EQ(camera.frames, 12U);
  EXPECT_NEAR(camera.difference.value, 0.0, 1e-9);
  EXPECT_NEAR(camera.difference.reference_value, 0.0, 1e-9);
}

TEST_F(CompareRunsTest, FewBodiesAreUndecided) {
  std::vector<Json> before;
  std::vector<Json> after;
  for (int id = 1; id <= 3; ++id) {
    before.push_back(BodyOf(id, ErrorsAround(0.02)));
    after.push_back(BodyOf(id, ErrorsAround(0.01)));
  }
  const RunComparison comparison =
      CompareRuns({Write("a", RunOf("full", before)), Write("b", RunOf("full", after))});
  const auto ate = std::find_if(comparison.by_body.begin(), comparison.by_body.end(),
                                [](const auto& paired) { return paired.what == "object_ate"; });
  ASSERT_NE(ate, comparison.by_body.end());
  EXPECT_EQ(ate->verdict, "undecided (3 pairs, 6 needed)");
  EXPECT_LT(ate->difference.difference, 0.0);
  EXPECT_EQ(comparison.runs[1].name, (folder_.path() / "b").string()) << "two runs of one variant";
}

TEST_F(CompareRunsTest, OptionsAndDefinitionsThatDifferAreNamed) {
  Json other = RunOf("full", {});
  other["options"]["orb"]["features"] = 500;
  for (Json& metric : other["metrics"]) {
    if (metric["name"] == "camera_ate") metric["contract"]["alignment"] = "none";
  }
  const RunComparison comparison =
      CompareRuns({Write("a", RunOf("static", {})), Write("b", other)});
  EXPECT_EQ(comparison.runs[0].options.at("orb.features"), "2000");
  EXPECT_EQ(comparison.runs[1].options.at("orb.features"), "500");
  const auto metric = std::find_if(comparison.metrics.begin(), comparison.metrics.end(),
                                   [](const auto& entry) { return entry.name == "camera_ate"; });
  ASSERT_NE(metric, comparison.metrics.end());
  EXPECT_EQ(metric->differing, "alignment");
}

TEST_F(CompareRunsTest, RunsOfOtherSequencesAreRefused) {
  const auto room = Write("a", RunOf("full", {}));
  const auto street = Write("b", RunOf("full", {}, "street"));
  EXPECT_THAT(ErrorMessage([&] {
                CompareRuns({room, street});
              }),
              HasSubstr("found a run of street, expected one of room, as "));
}

}  // namespace
}  // namespace cvo::reports
