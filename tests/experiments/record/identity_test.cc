// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/record/build_identity.h"
#include "experiments/record/job_identity.h"

namespace cvo {
namespace {

using testing::MatchesRegex;

const std::string kDifferentText = "another";

BuildIdentity SomeBuild() {
  BuildIdentity build = ThisBuild();
  build.cpu_level = "avx2";
  return build;
}

Job SomeJob() {
  return {"build",        "static", {{"window", {{"spatial", 5}}}}, "content", "detections",
          Json::object(), 0};
}

TEST(BuildIdentity, IsComplete) {
  const BuildIdentity build = ThisBuild();
  EXPECT_THAT(build.estimator_sources, MatchesRegex("[0-9a-f]{64}"));
  EXPECT_THAT(build.evaluation_sources, MatchesRegex("[0-9a-f]{64}"));
  EXPECT_NE(build.estimator_sources, build.evaluation_sources);
  for (const std::string& field : {build.version, build.compiler, build.build_type, build.flags,
                                   build.libraries.opencv, build.libraries.eigen, build.commit}) {
    EXPECT_FALSE(field.empty());
  }
}

TEST(BuildIdentity, IgnoresTheCommit) {
  BuildIdentity build = SomeBuild();
  const std::string hash = IdentityOf(build);
  build.commit = kDifferentText;
  EXPECT_EQ(IdentityOf(build), hash);
  build.flags += " -O0";
  EXPECT_NE(IdentityOf(build), hash);
}

TEST(BuildIdentity, DependsOnTheProcessorLevel) {
  BuildIdentity build = SomeBuild();
  const std::string hash = IdentityOf(build);
  build.cpu_level = "plain x86-64";
  EXPECT_NE(IdentityOf(build), hash);
}

TEST(JobIdentity, IsStable) {
  // A change here orphans every recorded result: raise the schema version with it.
  EXPECT_EQ(JobIdentity(SomeJob()),
            "008286c28f35a451d8bde869aa12d17c46b5377dde9bfde844ee073fe632d195");
}

TEST(JobIdentity, DependsOnEveryPart) {
  const std::string identity = JobIdentity(SomeJob());
  EXPECT_EQ(JobIdentity(SomeJob()), identity);
  for (const auto& change :
       std::vector<void (*)(Job&)>{[](Job& job) { job.build = kDifferentText; },
                                   [](Job& job) { job.variant = kDifferentText; },
                                   [](Job& job) { job.options["window"]["spatial"] = 6; },
                                   [](Job& job) { job.content = kDifferentText; },
                                   [](Job& job) { job.detections = kDifferentText; },
                                   [](Job& job) { job.given["oracle"] = kDifferentText; },
                                   [](Job& job) { job.seed = 1; }}) {
    Job job = SomeJob();
    change(job);
    EXPECT_NE(JobIdentity(job), identity);
  }
}

TEST(DetectionsHash, DependsOnWhatTheEstimatorIsGiven) {
  Sequence sequence;
  const std::string none = DetectionsHash(sequence);
  ObjectBox box;
  box.type = "Car";
  box.score = 0.5;
  sequence.detections = {box};
  const std::string one = DetectionsHash(sequence);
  EXPECT_NE(one, none);
  sequence.detections[0].track = 7;  // never shown to the estimator
  EXPECT_EQ(DetectionsHash(sequence), one);
  sequence.detections[0].left_px = 1.0;
  EXPECT_NE(DetectionsHash(sequence), one);
  sequence.detections[0].left_px = 0.0;
  sequence.detections_offset_m = 0.06;
  EXPECT_NE(DetectionsHash(sequence), one);
}

}  // namespace
}  // namespace cvo
