// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Front-end output on disk: it reads back bit by bit, damage is detected, and the folder has a size
// limit, may be used by several processes, and may fail.
#include "experiments/runner/front_end_cache.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::front_end_cache_test {
namespace {

namespace fs = std::filesystem;
using test::NamesIn;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::size_t kFrames = 4;

// Returns frames with a few features each. Frame 1 has a problem instead of features.
std::vector<FrontEndFrame> SomeFrames(int count) {
  std::vector<FrontEndFrame> frames;
  for (int i = 0; i < count; ++i) {
    FrontEndFrame frame;
    if (i == 1) frame.problems = {{1, "found nothing, expected a whole PNG image"}};
    for (int k = 0; k < 3 && i != 1; ++k) {
      StereoFeature feature;
      feature.z_px = {i + 1.0 / 3.0, k - 0.0, -1e-300 * i};
      feature.octave = k;
      feature.angle_rad = 0.1F * static_cast<float>(i);
      feature.response = 1e-40F;  // denormal
      feature.disagreement_px = 0.25F;
      feature.row_offset_px = -0.75F;
      feature.is_reserve = i % 2 == 1;
      feature.descriptor = {~0ULL, 0x0123456789abcdefULL, static_cast<std::uint64_t>(i), 0};
      feature.patch.corner_u = -0.25F;
      feature.patch.corner_v = 0.125F;
      feature.patch.pixels.fill(static_cast<std::uint8_t>(200 + k));
      frame.features.push_back(feature);
    }
    frames.push_back(frame);
  }
  return frames;
}

std::string BytesOf(const std::vector<FrontEndFrame>& frames) {
  std::string bytes;
  for (const FrontEndFrame& frame : frames) bytes += EncodeFrame(frame);
  return bytes;
}

std::string SomeKey(char digit) { return std::string(64, digit); }

void Store(const FrontEndCache& cache, const std::string& key,
           const std::vector<FrontEndFrame>& frames) {
  FeatureRecording recording = cache.Record(key);
  for (const FrontEndFrame& frame : frames) recording.Add(frame);
  recording.Finish();
}

// Returns all frames of an entry as bytes, or "" if there is no such entry. Throws Error if one is
// damaged.
std::string Load(const FrontEndCache& cache, const std::string& key, std::size_t frames) {
  std::optional<FeatureFile> file = cache.Find(key);
  if (!file) return "";
  std::vector<FrontEndFrame> loaded;
  for (std::size_t i = 0; i < frames; ++i) loaded.push_back(file->Next());
  return BytesOf(loaded);
}

class FrontEndCacheTest : public testing::Test {
 protected:
  FrontEndCache Cache(const fs::path& folder, std::uint64_t limit_bytes = 1'000'000) {
    return {folder, limit_bytes, [this](const std::string& line) { notices_.push_back(line); }};
  }
  FrontEndCache Cache(std::uint64_t limit_bytes = 1'000'000) {
    return Cache(temp_.path(), limit_bytes);
  }
  fs::path FileOf(const std::string& key) const { return temp_.path() / (key + ".features"); }

  // Sets the last use of a file to `seconds` ago.
  static void Age(const fs::path& file, time_t seconds) {
    timespec times[2] = {{0, UTIME_OMIT}, {::time(nullptr) - seconds, 0}};
    ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
  }

  test::TempFolder temp_;
  std::vector<std::string> notices_;
  const std::vector<FrontEndFrame> frames_ = SomeFrames(kFrames);
  const std::string key_ = SomeKey('a');
};

TEST_F(FrontEndCacheTest, ReadsBackEveryBit) {
  const FrontEndCache cache = Cache();
  EXPECT_EQ(Load(cache, key_, kFrames), "");
  Store(cache, key_, frames_);
  FeatureFile file = cache.Find(key_).value();
  (void)file.Next();
  const FrontEndFrame skipped = file.Next();
  const FrontEndFrame loaded = file.Next();
  ASSERT_THAT(loaded.features, SizeIs(3));
  EXPECT_EQ(loaded.features[1].z_px, frames_[2].features[1].z_px);
  EXPECT_EQ(loaded.features[1].octave, 1);
  EXPECT_EQ(loaded.features[1].angle_rad, frames_[2].features[1].angle_rad);
  EXPECT_EQ(loaded.features[1].is_reserve, frames_[2].features[1].is_reserve);
  EXPECT_EQ(loaded.features[1].response, 1e-40F);
  EXPECT_EQ(loaded.features[1].disagreement_px, 0.25F);
  EXPECT_EQ(loaded.features[1].row_offset_px, -0.75F);
  EXPECT_EQ(loaded.features[1].descriptor, frames_[2].features[1].descriptor);
  EXPECT_THAT(skipped.features, IsEmpty());
  ASSERT_THAT(skipped.problems, SizeIs(1));
  EXPECT_EQ(skipped.problems[0].side, 1);
  EXPECT_EQ(skipped.problems[0].reason, frames_[1].problems[0].reason);
  EXPECT_EQ(Load(cache, key_, kFrames), BytesOf(frames_));
  EXPECT_THAT(notices_, IsEmpty());
}

TEST_F(FrontEndCacheTest, DamageIsDetected) {
  const FrontEndCache cache = Cache();
  Store(cache, key_, frames_);
  const std::string whole = ReadFileBytes(FileOf(key_));
  constexpr std::size_t kStep = 7;  // coprime to 8, so all bit positions are hit
  for (std::size_t at = 0; at < whole.size(); at += kStep) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
    for (const std::string& bytes : {damaged, whole.substr(0, at)}) {
      WriteFileBytes(FileOf(key_), bytes);
      EXPECT_THAT(ErrorMessage([&] { (void)Load(cache, key_, kFrames); }),
                  HasSubstr(FileOf(key_).string()))
          << at;
    }
  }
  WriteFileBytes(FileOf(key_), whole);
  EXPECT_EQ(Load(cache, key_, kFrames), BytesOf(frames_));
}

TEST_F(FrontEndCacheTest, TheKeyCoversAllInputs) {
  const std::vector<ImageHashes> images = {{"1", "2"}, {"3", "4"}};
  FrontEndSettings settings = {"build", {}, {}, {}};
  const std::string key = FrontEndKey(settings, images);
  EXPECT_EQ(FrontEndKey(settings, images), key);
  EXPECT_NE(FrontEndKey(settings, {{"1", "2"}, {"4", "3"}}), key);
  EXPECT_NE(FrontEndKey(settings, {{"1", "2"}}), key);
  EXPECT_EQ(FrontEndKey(settings, {{"1", "2"}, {"3", ""}}), "");
  std::vector<FrontEndSettings> others(7, settings);
  others[0].build = "other";
  others[1].camera.right_shift_px = 1e-9;
  others[2].camera.height_px = 1;
  others[3].orb.features += 1;
  others[4].stereo.max_sigma_medians += 1e-9;
  others[5].boxes = {{{10.0, 20.0, 30.0, 40.0}}, {}};
  others[6].perturbation.blur_px = 1.0;
  for (const FrontEndSettings& other : others) EXPECT_NE(FrontEndKey(other, images), key);
  // The random choices of a perturbation depend on the number of the frame.
  FrontEndSettings later = others[6];
  later.first_frame = 7;
  EXPECT_NE(FrontEndKey(later, images), FrontEndKey(others[6], images));
  settings.first_frame = 7;
  EXPECT_EQ(FrontEndKey(settings, images), key);
}

TEST_F(FrontEndCacheTest, LeastRecentlyUsedIsRemovedFirst) {
  Store(Cache(), SomeKey('a'), frames_);
  Store(Cache(), SomeKey('b'), frames_);
  Store(Cache(), SomeKey('c'), frames_);
  const std::uint64_t size_bytes = fs::file_size(FileOf(SomeKey('a')));
  Age(FileOf(SomeKey('a')), 300);
  Age(FileOf(SomeKey('b')), 200);
  Age(FileOf(SomeKey('c')), 100);
  EXPECT_TRUE(Cache().Find(SomeKey('a')));  // marks it as just used
  Store(Cache(3 * size_bytes), SomeKey('d'), frames_);
  EXPECT_THAT(NamesIn(temp_.path()),
              ElementsAre(SomeKey('a') + ".features", SomeKey('c') + ".features",
                          SomeKey('d') + ".features"));
  Store(Cache(size_bytes), SomeKey('e'), frames_);
  EXPECT_THAT(NamesIn(temp_.path()), ElementsAre(SomeKey('e') + ".features"));
  EXPECT_THAT(notices_, IsEmpty());
}

TEST_F(FrontEndCacheTest, AnEntryAboveTheLimitIsNotStored) {
  Store(Cache(), SomeKey('a'), frames_);
  const std::uint64_t size_bytes = fs::file_size(FileOf(SomeKey('a')));
  Store(Cache(size_bytes), SomeKey('b'), SomeFrames(40));
  EXPECT_THAT(NamesIn(temp_.path()), SizeIs(1));
  ASSERT_THAT(notices_, SizeIs(1));
  EXPECT_THAT(notices_[0], HasSubstr(StrCat("more than the ", size_bytes, " bytes")));
  Store(Cache(0), SomeKey('b'), frames_);  // disabled on request: no notice
  EXPECT_THAT(notices_, SizeIs(1));
}

TEST(CacheLimit, ReadsSizes) {
  const auto limit = [](const char* text) {
    ::setenv("CLUSTERVO_CACHE_SIZE", text, 1);
    return CacheLimit();
  };
  EXPECT_EQ(limit("0"), 0U);
  EXPECT_EQ(limit("12"), 12U);
  EXPECT_EQ(limit("1.5K"), 1500U);
  EXPECT_EQ(limit("3M"), 3'000'000U);
  EXPECT_EQ(limit(""), 20'000'000'000U);
  for (const char* bad : {"G", "-1", "20g", "1e30", "20 G", "nan", "much"}) {
    EXPECT_THAT(ErrorMessage([&] { (void)limit(bad); }), HasSubstr("CLUSTERVO_CACHE_SIZE")) << bad;
  }
  ASSERT_EQ(::unsetenv("CLUSTERVO_CACHE_SIZE"), 0);
  EXPECT_EQ(CacheLimit(), 20'000'000'000U);
}

}  // namespace
}  // namespace cvo::front_end_cache_test
