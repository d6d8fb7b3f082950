// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Golden files of the current schema versions. When one no longer reads, or is written differently,
// the schema version must change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/json/json_record.h"
#include "core/files/text_file.h"
#include "core/record/metric_catalogue.h"
#include "core/record/run_summary.h"
#include "core/record/suite_runs.h"
#include "core/record/truth.h"
#include "reports/gate/baseline.h"
#include "reports/tables/table.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::reports {
namespace {

std::filesystem::path Golden(const char* name) {
  return std::filesystem::path(CVO_GOLDEN_FILES) / name;
}

// Expects the keys of the golden file in the same order, with the same values.
void ExpectWritten(const std::string& text, const char* name) {
  EXPECT_EQ(ParseJson(text, "written").dump(1), ReadJson(Golden(name)).dump(1));
}

TEST(GoldenFiles, ResultIsRead) {
  const RunSummary run = ReadRun(Golden("result.json"), {"object_causal_motion_r", "camera_ate"});
  EXPECT_EQ(run.seed, 18446744073709551615u);
  EXPECT_EQ(run.sequence.range(), (FrameSpan{10, 11}));
  ASSERT_EQ(run.metrics.size(), 2U);
  const Contract& motion = run.metrics[1].contract;
  EXPECT_EQ(motion.subject, Subject::kMovers);
  EXPECT_EQ(motion.travel_m, 0.2);
  EXPECT_EQ(motion.visible, (Visibility{VisibleBy::kMask, 400, 30}));
  EXPECT_EQ(motion.frames, (FrameSpan{10, 11}));
  ASSERT_TRUE(run.bodies);
  ASSERT_EQ(run.bodies->refined.size(), 1U);
  EXPECT_EQ(run.bodies->refined[0].ate_m, 0.05);
  EXPECT_FALSE(run.bodies->refined[0].predicted_ate_m);
}

TEST(ReadRun, RefusesAnotherSchemaInOneLine) {
  const test::TempFolder folder;
  Json result = ReadJson(Golden("result.json"));
  result["schema_version"] = 2;
  const std::string file = folder.Write("result.json", result.dump());
  EXPECT_EQ(ErrorMessage([&] { ReadRun(file, {}); }),
            file + ": found schema_version 2, expected 3");
}

TEST(ReadRun, RefusesAResultThatWasEdited) {
  RunSummary run = ReadRun(Golden("result.json"), AllMetricNames());
  const test::TempFolder folder;
  const auto read = [&](const char* pointer, const Json& value) {
    Json result = FileJson(run);
    EXPECT_TRUE(result.contains(Json::json_pointer(pointer))) << pointer;
    result[Json::json_pointer(pointer)] = value;
    const std::string file = folder.Write("result.json", result.dump());
    return ErrorMessage([&] { ReadRun(file, {}); });
  };
  run.checksum = ChecksumOf(run);
  EXPECT_THAT(read("/seed", run.seed), testing::HasSubstr("do not fit its checksum and job"));
  run.job = JobIdentity({IdentityOf(run.build), run.variant, run.options, run.sequence.content,
                         run.sequence.detections_hash, run.given, run.seed});
  run.checksum = ChecksumOf(run);
  EXPECT_EQ(read("/seed", run.seed), "");
  for (const auto& [pointer, value] : {std::pair<const char*, Json>{"/metrics/0/value", 0.125},
                                       {"/options", {{"a", 1}}},
                                       {"/sequence/content", "other"},
                                       {"/build/compiler", "other"},
                                       {"/seed", 3}}) {
    EXPECT_THAT(read(pointer, value), testing::HasSubstr("run its job again")) << pointer;
  }
}

TEST(ReadRun, RefusesImpossibleCounts) {
  const test::TempFolder folder;
  const auto expect_refused = [&](const char* pointer, int value, const char* said) {
    Json result = ReadJson(Golden("result.json"));
    ASSERT_TRUE(result.contains(Json::json_pointer(pointer))) << pointer;
    result[Json::json_pointer(pointer)] = value;
    const std::string file = folder.Write("result.json", result.dump());
    EXPECT_THAT(ErrorMessage([&] { ReadRun(file, {}); }), testing::HasSubstr(said));
  };
  for (const char* field : {"visible_frames", "estimated_frames", "id_switches", "fragments"}) {
    const std::string pointer = StrCat("/bodies/refined/0/", field);
    expect_refused(pointer.c_str(), -1, field);
  }
  expect_refused("/bodies/refined/0/estimated_frames", 1'000, "at most");
  expect_refused("/sequence/frames", -5, "sequence, field frames: found -5");
  expect_refused("/sequence/total_frames", -1, "total_frames");
  expect_refused("/sequence/first_frame", -1, "first_frame");
  expect_refused("/metrics/0/n", -3, "field n: found -3");
}

TEST(GoldenFiles, MetricsAndBodiesAreWrittenAsTheyAreRead) {
  const Json result = ReadJson(Golden("result.json"));
  for (const Json& metric : result["metrics"]) {
    EXPECT_EQ(ToJson(FromJson<MetricValue>(metric, "metric")).dump(1), metric.dump(1));
  }
  const Json& bodies = result["bodies"]["refined"];
  EXPECT_EQ(ToJson(FromJson<std::vector<BodyRow>>(bodies, "bodies")).dump(1), bodies.dump(1));
}

TEST(GoldenFiles, OthersAreWrittenAsTheyAreRead) {
  ExpectWritten(FileText(ReadRecord<TimingData>(Golden("timing.json"))), "timing.json");
  ExpectWritten(FileText(ReadRecord<TruthData>(Golden("truth.json"))), "truth.json");
  ExpectWritten(FileText(ReadBaseline(Golden("baseline.json"))), "baseline.json");
  ExpectWritten(TableJson(ReadRecord<Table>(Golden("table.json"))), "table.json");
}

TEST(GoldenFiles, PlanIsRead) {
  const SuitePlan plan = ReadPlan(Golden("plan.json"));
  ASSERT_EQ(plan.runs.size(), 1U);
  EXPECT_EQ(plan.runs[0].keys.at("orb.features"), "1000");
  EXPECT_EQ(plan.runs[0].keys.at("oracle"), "camera");
  EXPECT_EQ(plan.runs[0].job, "0123abcd");
}

}  // namespace
}  // namespace cvo::reports
