// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/shipped_trajectories.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/jobs/job_status.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/suite/cell_input.h"
#include "experiments/suite/shipped/trajectory_texts.h"
#include "synth/family/generate.h"
#include "synth/scene/shipped_scenes.h"
#include "tests/experiments/suite/examples.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo {
namespace {

using test::Parse;
using test::SmallSuite;
using testing::HasSubstr;
using testing::StartsWith;

// A suite on a shipped scene, or on a file of the same name, with the trajectory that is shipped
// for it.
Suite SuiteWithPeers(const std::string& scene) {
  Json json = SmallSuite();
  json["sequences"] = Json::array({{{"scene", scene}}});
  json["variants"] = Json::array();
  json["systems"] = Json::array({{{"name", "ORB-SLAM2"}}});
  return Parse(json);
}

TEST(ShippedTrajectories, AreFilesOfTheUnchangedScene) {
  const test::TempFolder folder;
  const Suite suite = SuiteWithPeers("indoor_1");
  const SystemFiles files = SystemFilesOf(suite, ExpandSuite(suite).at(0), "", folder.path());
  EXPECT_EQ(files.name, "ORB-SLAM2");
  EXPECT_EQ(ReadTumTrajectory(files.camera).size(), 250u);
  EXPECT_EQ(SuiteToJson(suite)["systems"], Json::array({{{"name", "ORB-SLAM2"}}}));
}

// When a scene is edited, its trajectories must be removed or computed again.
TEST(ShippedTrajectories, NoneIsStale) {
  const test::TempFolder folder;
  for (const ShippedTrajectory& shipped : ShippedTrajectories()) {
    SuiteSequence sequence;
    sequence.scene = sequence.name = shipped.scene;
    const auto files = ShippedSystemFiles(std::string(shipped.system), sequence, folder.path());
    const std::size_t frames = ReadTumTrajectory(files.camera).size();
    EXPECT_EQ(static_cast<int>(frames), synth::LoadScene(sequence.scene, {}).parts().frames)
        << shipped.scene;
  }
}

TEST(ShippedTrajectories, OfOtherImagesAreStale) {
  const test::TempFolder folder;
  const auto message = [&](const Suite& suite) {
    return ErrorMessage([&] { SystemFilesOf(suite, ExpandSuite(suite).at(0), "", folder.path()); });
  };
  for (const synth::ShippedScene& shipped : synth::ShippedScenes()) {
    if (shipped.name == "indoor_1") folder.Write("indoor_1.json", shipped.text + "\n");
  }
  EXPECT_THAT(message(SuiteWithPeers((folder.path() / "indoor_1.json").string())),
              StartsWith("stale: ORB-SLAM2 on indoor_1 ran on the scene file"));
  Suite suite = SuiteWithPeers("indoor_1");
  suite.sequences[0].frames = "0:5";
  EXPECT_THAT(message(suite), HasSubstr("all frames, not 0:5"));
  suite.sequences[0].frames = "";
  suite.sequences[0].perturb = {{"blur_px", 1}};
  EXPECT_THAT(message(suite), StartsWith("stale: "));
}

TEST(ShippedTrajectories, ASystemWithoutFilesMustHaveSome) {
  EXPECT_THAT(ErrorMessage([] { SuiteWithPeers("tiny"); }),
              HasSubstr("systems.0.files: found none, expected a file for each sequence; those "
                        "that come with the program: ORB-SLAM2 on indoor_1"));
}

TEST(ShippedTrajectories, AStaleTrajectoryIsNoFailedJob) {
  PlannedJob job;
  job.cell.sequence.scene = "indoor_1";
  job.folder = "/rendered";
  job.missing = std::string(kStale) + "of another scene";
  EXPECT_EQ(StatusOf({"/none"}, job).state, JobStatus::State::kNoSequence);
}

}  // namespace
}  // namespace cvo
