// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/files/text_file.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_job.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/collected.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"
#include "variants/registry.h"

namespace cvo::cache_test {
namespace {

namespace fs = std::filesystem;
using test::NamesIn;
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
  FrontEndCache Cache() {
    return {features(), 1'000'000'000,
            [this](const std::string& line) { notices_.push_back(line); }};
  }
  static void Serve(const FrontEndCache& cache, RunRequest& request) {
    request.images = HashImages(request.sequence);
    request.cache = &cache;
  }
  RunRequest Request(const char* variant = "static", int threads = 1) const {
    RunRequest request{.sequence = sequence_, .variant = FindVariant(variant), .options = {}};
    request.threads = threads;
    request.options.orb.features = 300;
    return request;
  }
  static std::string ResultOf(const RunResult& run) { return ResultFile(run); }
  static std::string ResultOf(const RunRequest& request) {
    return ResultOf(RunSequence(request).value());
  }
  static bool EndsWithStage(const RunResult& run, const char* stage) {
    return run.times_s.contains(stage) && !std::isnan(run.times_s.at(stage).back());
  }
  // Runs with the cache; `hit` becomes whether the features came from it.
  std::string Cached(RunRequest request, bool& hit) {
    const FrontEndCache cache = Cache();
    Serve(cache, request);
    const RunResult run = RunSequence(request).value();
    hit = EndsWithStage(run, "load_features");
    EXPECT_NE(hit, EndsWithStage(run, "decode"));
    return ResultOf(run);
  }

  test::TempFolder temp_;
  Sequence sequence_;
  std::vector<std::string> notices_;
};

TEST_F(RunnerCache, WritesTheSameBytesForEveryVariantAndNumberOfThreads) {
  bool hit = true;
  EXPECT_EQ(Cached(Request(), hit), ResultOf(Request()));
  EXPECT_FALSE(hit);
  for (const char* variant : {"static", "2d", "full"}) {
    const std::string plain = ResultOf(Request(variant));
    for (const int threads : {1, 2, 4}) {
      EXPECT_EQ(Cached(Request(variant, threads), hit), plain) << variant << threads;
      EXPECT_TRUE(hit);
    }
  }
  EXPECT_THAT(NamesIn(features()), SizeIs(1));
  EXPECT_THAT(notices_, IsEmpty());
}

TEST_F(RunnerCache, ExtractsAgainOnlyIfTheFeaturesWouldChange) {
  bool hit = true;
  (void)Cached(Request(), hit);
  RunRequest request = Request();
  request.options.window.spatial += 1;
  request.seed = 3;
  EXPECT_EQ(Cached(request, hit), ResultOf(request));
  EXPECT_TRUE(hit);
  request.options.orb.features += 1;
  EXPECT_EQ(Cached(request, hit), ResultOf(request));
  EXPECT_FALSE(hit);
  request.options.stereo.max_hamming -= 1;
  EXPECT_EQ(Cached(request, hit), ResultOf(request));
  EXPECT_FALSE(hit);
  test::CutFile(sequence_.images[4].left);
  EXPECT_EQ(Cached(Request(), hit), ResultOf(Request()));
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
    const FrontEndCache cache = Cache();
    RunRequest request = Request("static", 1 + static_cast<int>(i % 3));
    Serve(cache, request);
    EXPECT_EQ(ResultOf(request), plain) << at;
    EXPECT_THAT(notices_, SizeIs(1)) << at;
    EXPECT_FALSE(fs::exists(entry)) << at;
    EXPECT_EQ(Cached(Request(), hit), plain);
    EXPECT_EQ(ReadFileBytes(entry), whole) << "damaged at " << at << ", not made again";
  }
}

TEST_F(RunnerCache, AnUnfinishedRunLeavesNoEntry) {
  const FrontEndCache cache = Cache();
  RunRequest request = Request();
  Serve(cache, request);
  request.stop = [] { return true; };
  EXPECT_FALSE(RunSequence(request));
  EXPECT_THAT(NamesIn(features()), IsEmpty());
}

TEST_F(RunnerCache, ImagesChangedAfterHashingAreNotStored) {
  const FrontEndCache cache = Cache();
  RunRequest request = Request();
  Serve(cache, request);
  test::CutFile(sequence_.images[4].left);
  const RunResult run = RunSequence(request).value();
  EXPECT_EQ(ResultOf(run), ResultOf(Request()));
  EXPECT_THAT(NamesIn(features()), IsEmpty());
}

}  // namespace
}  // namespace cvo::cache_test
