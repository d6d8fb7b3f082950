// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Suites whose boxes are found by a network before the runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/json/json.h"
#include "tests/experiments/cli/process.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/experiments/yolo/tiny_network.h"
#include "tests/support/real_data.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;
using test::ProcessResult;
using testing::HasSubstr;
using testing::Not;

constexpr char kTinyNetwork[] = R"({"model": "tiny.cfg", "names": "two.names", "min_score": 0.3})";

class DetectorSuite : public testing::Test {
 protected:
  ProcessResult Run(const std::string& sequences, const std::string& variants,
                    const fs::path& data) const {
    const fs::path suite = folder_.Write(
        "suite.json", StrCat(R"({"name": "found", "sequences": [)", sequences, R"(], "variants": )",
                             variants, R"(, "seeds": 1, "table": {"rows": ["variant", )",
                             R"("detections"], "metrics": ["camera_ate"]}})"));
    return test::RunProgram(
        {"experiment", "run", suite.string(), "-o", (folder_.path() / "out").string(), "-j", "1"},
        {.environment = {StrCat("CLUSTERVO_CACHE=", (folder_.path() / "cache").string()),
                         StrCat("CLUSTERVO_DATA=", data.string())}});
  }
  std::vector<fs::path> Boxes() const {
    std::vector<fs::path> files;
    for (const auto& file : fs::directory_iterator(folder_.path() / "cache" / "detections")) {
      if (file.path().extension() == ".txt") files.push_back(file.path());
    }
    return files;
  }
  Json Jobs() const { return ReadJson(folder_.path() / "out" / "plan.json")["jobs"]; }

  test::TempFolder folder_;
};

// The network runs once for all jobs, and its boxes are kept. Other settings give other boxes.
TEST_F(DetectorSuite, BoxesAreFoundOnceAndKept) {
  test::WriteTinySequence(folder_.path() / "wall", 4);
  test::WriteTinyNetwork(folder_);
  folder_.Write("two.names", "person\ncar\n");
  const std::string sequence = StrCat(R"({"folder": "wall", "detections": )", kTinyNetwork, "}");
  const ProcessResult run = Run(sequence, R"(["static"])", folder_.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("finding boxes in 1 sequence\n"));
  ASSERT_EQ(Boxes().size(), 1U);
  const std::string rows = test::ReadFile(Boxes()[0]);
  EXPECT_THAT(rows, testing::StartsWith("0 -1 Car -1 -1 -10 "));
  EXPECT_EQ(test::LineCount(rows), 4U);
  EXPECT_EQ(Jobs()[0]["detections"], "tiny");

  const ProcessResult more = Run(sequence, R"(["static", "full"])", folder_.path());
  EXPECT_THAT(more.err, Not(HasSubstr("finding boxes")));
  EXPECT_EQ(more.out, "found: 2 jobs: 2 done\n") << more.err;
  const Json result =
      ReadJson(folder_.path() / "out" / "jobs" / std::string(Jobs()[1]["job"]) / "result.json");
  EXPECT_EQ(result["detection_counts"]["given"], 4);

  // Boxes that do not match their checksum, or have none, are not used.
  const fs::path checksum = Boxes()[0].string() + ".sha256";
  WriteFileBytes(Boxes()[0], rows.substr(0, rows.find('\n') + 1));
  const ProcessResult damaged = Run(sequence, R"(["static"])", folder_.path());
  EXPECT_THAT(damaged.err, HasSubstr("cached boxes are damaged and will be found again"));
  EXPECT_EQ(test::ReadFile(Boxes()[0]), rows);
  fs::remove(checksum);
  EXPECT_THAT(Run(sequence, R"(["static"])", folder_.path()).err, HasSubstr("finding boxes in 1"));
  EXPECT_TRUE(fs::exists(checksum));

  std::string stricter = sequence;
  stricter.replace(stricter.find("0.3"), 3, "0.99");
  EXPECT_EQ(Run(stricter, R"(["static"])", folder_.path()).exit_code, 0);
  EXPECT_EQ(Boxes().size(), 2U);
}

TEST_F(DetectorSuite, ReportsMissingAndInvalidNetworks) {
  test::WriteTinySequence(folder_.path() / "wall", 4);
  test::WriteTinyNetwork(folder_);
  const std::string sequence = StrCat(R"({"folder": "wall", "detections": )", kTinyNetwork, "}");
  const std::string both = sequence + R"(, {"folder": "wall"})";
  // A missing network is missing input, not a failure; an invalid one is a failure.
  const ProcessResult missing = Run(both, R"(["static"])", folder_.path());
  EXPECT_EQ(missing.exit_code, 0);
  EXPECT_THAT(missing.out, HasSubstr("missing input: wall: no file two.names below"));
  folder_.Write("two.names", "person\n");
  const ProcessResult wrong = Run(both, R"(["static"])", folder_.path());
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_THAT(wrong.out, HasSubstr("its boxes were not found"));
  EXPECT_THAT(wrong.out, HasSubstr("found 2 classes, expected 1, as many as names"));
  test::ExpectError(Run(R"({"folder": "wall", "detections": {"model": "tiny.cfg"}})",
                        R"(["static"])", folder_.path()),
                    "sequences.0.detections.names");
}

TEST_F(DetectorSuite, RunsARealNetworkOnARealDrive) {
  const auto data = test::RealData();
  const fs::path network = "detectors/yolo-fastest-1.1-xl";
  if (!data || !fs::exists(*data / network)) GTEST_SKIP() << "CLUSTERVO_DATA has no detectors";
  const ProcessResult run = Run(
      StrCat(R"({"folder": "2011_09_26_drive_0013_sync", "frames": "10:13", "detections": {)",
             R"("model": ")", (network / "yolo-fastest-1.1-xl.cfg").string(), R"(", "names": ")",
             (network / "coco.names").string(), R"(", "input": "960x320"}})"),
      R"(["full"])", *data);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  ASSERT_EQ(Boxes().size(), 1U);
  EXPECT_THAT(test::ReadFile(Boxes()[0]), testing::StartsWith("10 -1 Car "));
}

}  // namespace
}  // namespace cvo
