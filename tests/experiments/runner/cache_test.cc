// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/runner/result_file.h"
#include "experiments/runner/run_job.h"
#include "experiments/runner/run_sequence.h"
#include "tests/experiments/cache/frames.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/collected.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"
#include "variants/registry.h"

namespace cvo::cache_test {
namespace {

namespace fs = std::filesystem;
using test::NamesIn;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// Tests that runs with and without the front-end cache write the same bytes.

constexpr int kFrames = 5;

Sequence Tiny(const fs::path& folder) {
  test::WriteTinySequence(folder, kFrames);
  test::CutFile(folder / "image_1" / "000002.png");
  SequenceRequest request;
  request.folder = folder;
  request.type = "kitti-odometry";
  return OpenSequence(request);
}

class RunnerCache : public testing::Test {
 protected:
  RunnerCache() : sequence_(Tiny(temp_.path() / "tiny")) {}

  fs::path root() const { return temp_.path() / "cache"; }
  fs::path features() const { return root() / "frontend"; }
  JobCache Cache() {
    FileHashHooks hooks;
    hooks.notice = [this](const std::string& line) { notices_.push_back(line); };
    return {root(), 1'000'000'000, hooks};
  }
  RunRequest Request(const char* variant = "static", int threads = 1) const {
    RunRequest request{.sequence = sequence_, .variant = FindVariant(variant), .options = {}};
    request.threads = threads;
    request.options.orb.features = 300;
    return request;
  }
  std::string ResultOf(const RunRequest& request, const RunResult& run) const {
    return test::Collected(WriteResultFile, RunRecord{.sequence = sequence_,
                                                      .build = ThisBuild(),
                                                      .variant = std::string(request.variant.name),
                                                      .run = run});
  }
  std::string Plain(const RunRequest& request) const {
    return ResultOf(request, RunSequence(request).value());
  }
  static bool EndsWithStage(const RunResult& run, const char* stage) {
    return run.times_s.contains(stage) && !std::isnan(run.times_s.at(stage).back());
  }
  // Runs with the cache; `hit` becomes whether the features came from it.
  std::string Cached(RunRequest request, bool& hit) {
    const JobCache cache = Cache();
    cache.Serve(request);
    const RunResult run = RunSequence(request).value();
    hit = EndsWithStage(run, "load_features");
    EXPECT_NE(hit, EndsWithStage(run, "decode"));
    return ResultOf(request, run);
  }

  test::TempFolder temp_;
  Sequence sequence_;
  std::vector<std::string> notices_;
};

TEST_F(RunnerCache, WritesTheSameBytesForEveryVariantAndNumberOfThreads) {
  bool hit = true;
  EXPECT_EQ(Cached(Request(), hit), Plain(Request()));
  EXPECT_FALSE(hit);
  for (const char* variant : {"static", "2d", "full"}) {
    const std::string plain = Plain(Request(variant));
    for (const int threads : {1, 2, 4}) {
      EXPECT_EQ(Cached(Request(variant, threads), hit), plain) << variant << threads;
      EXPECT_TRUE(hit);
    }
  }
  EXPECT_THAT(NamesIn(features()), SizeIs(1));
  EXPECT_THAT(notices_, IsEmpty());
}

TEST_F(RunnerCache, ACacheHitReadsNoImage) {
  const JobCache cache = Cache();
  RunRequest request = Request();
  cache.Serve(request);
  const std::string plain = ResultOf(request, RunSequence(request).value());
  const std::string job = IdentifyJob(request);
  fs::rename(sequence_.folder / "image_0", sequence_.folder / "elsewhere");
  EXPECT_EQ(ResultOf(request, RunSequence(request).value()), plain);
  EXPECT_EQ(IdentifyJob(request), job);
}

TEST_F(RunnerCache, ExtractsAgainOnlyIfTheFeaturesWouldChange) {
  bool hit = true;
  (void)Cached(Request(), hit);
  RunRequest request = Request();
  request.options.window.spatial += 1;
  request.seed = 3;
  EXPECT_EQ(Cached(request, hit), Plain(request));
  EXPECT_TRUE(hit);
  request.options.orb.features += 1;
  EXPECT_EQ(Cached(request, hit), Plain(request));
  EXPECT_FALSE(hit);
  request.options.stereo.max_hamming -= 1;
  EXPECT_EQ(Cached(request, hit), Plain(request));
  EXPECT_FALSE(hit);
  test::CutFile(sequence_.images[4].left);
  EXPECT_EQ(Cached(Request(), hit), Plain(Request()));
  EXPECT_FALSE(hit);
}

TEST_F(RunnerCache, DamageCostsTimeOnce) {
  bool hit = true;
  const std::string plain = Cached(Request(), hit);
  const fs::path entry = features() / NamesIn(features()).at(0);
  const std::string whole = ReadFileBytes(entry);
  constexpr std::size_t kPlaces = 12;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    std::string damaged = whole;
    const std::size_t at = i * (whole.size() - 1) / (kPlaces - 1);
    damaged[at] = static_cast<char>(damaged[at] ^ 16);
    WriteFileBytes(entry, i % 3 == 2 ? whole.substr(0, at) : damaged);
    notices_.clear();
    const JobCache cache = Cache();
    RunRequest request = Request("static", 1 + static_cast<int>(i % 3));
    cache.Serve(request);
    EXPECT_EQ(ResultOf(request, RunSequence(request).value()), plain) << at;
    EXPECT_THAT(notices_, SizeIs(1)) << at;
    EXPECT_FALSE(fs::exists(entry)) << at;
    EXPECT_EQ(Cached(Request(), hit), plain);
    EXPECT_EQ(ReadFileBytes(entry), whole) << "damaged at " << at << ", not made again";
  }
}

TEST_F(RunnerCache, AnUnfinishedRunLeavesNoEntry) {
  const JobCache cache = Cache();
  RunRequest request = Request();
  cache.Serve(request);
  request.stop = [] { return true; };
  EXPECT_FALSE(RunSequence(request));
  EXPECT_THAT(NamesIn(features()), IsEmpty());
  request.stop = [] { return false; };
  request.strict = true;
  const std::string problem = ErrorMessage([&] { (void)RunSequence(request); });
  EXPECT_THAT(problem, HasSubstr("000002.png"));
  EXPECT_THAT(NamesIn(features()), IsEmpty());

  request.strict = false;
  (void)RunSequence(request);
  request.strict = true;  // a problem recorded in the cache is refused alike
  EXPECT_EQ(ErrorMessage([&] { (void)RunSequence(request); }), problem);
}

TEST_F(RunnerCache, ImagesChangedAfterHashingAreNotStored) {
  const JobCache cache = Cache();
  RunRequest request = Request();
  cache.Serve(request);
  test::CutFile(sequence_.images[4].left);
  const RunResult run = RunSequence(request).value();
  EXPECT_EQ(ResultOf(request, run), Plain(Request()));
  EXPECT_THAT(NamesIn(features()), IsEmpty());
}

}  // namespace
}  // namespace cvo::cache_test
