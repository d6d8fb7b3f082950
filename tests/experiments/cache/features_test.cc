// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Front-end output stored on disk reads back bit by bit, and damage is always detected.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "experiments/cache/front_end_cache.h"
#include "tests/experiments/cache/frames.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::features_test {
namespace {

namespace fs = std::filesystem;
using test::BytesOf;
using test::Load;
using test::NamesIn;
using test::SomeFrames;
using test::SomeKey;
using test::Store;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::size_t kFrames = 4;

class CacheFeatures : public testing::Test {
 protected:
  FrontEndCache Cache(std::uint64_t limit_bytes = 1'000'000) {
    return {folder(), limit_bytes, [this](const std::string& line) { notices_.push_back(line); }};
  }
  fs::path folder() const { return temp_.path() / "frontend"; }
  fs::path FileOf(const std::string& key) const { return folder() / (key + ".features"); }

  test::TempFolder temp_;
  std::vector<std::string> notices_;
  const std::vector<FrontEndFrame> frames_ = SomeFrames(kFrames);
  const std::string key_ = SomeKey('a');
};

TEST_F(CacheFeatures, ReadsBackEveryBit) {
  const FrontEndCache cache = Cache();
  EXPECT_EQ(Load(cache, key_, kFrames), "");
  Store(cache, key_, frames_);
  const FrontEndFrame loaded = cache.Find(key_, kFrames)->Frame(2);
  ASSERT_THAT(loaded.features, SizeIs(3));
  EXPECT_EQ(loaded.features[1].z_px, frames_[2].features[1].z_px);
  EXPECT_EQ(loaded.features[1].octave, 1);
  EXPECT_EQ(loaded.features[1].angle_rad, frames_[2].features[1].angle_rad);
  EXPECT_EQ(loaded.features[1].is_reserve, frames_[2].features[1].is_reserve);
  EXPECT_EQ(loaded.features[1].response, 1e-40F);
  EXPECT_EQ(loaded.features[1].disagreement_px, 0.25F);
  EXPECT_EQ(loaded.features[1].row_offset_px, -0.75F);
  EXPECT_EQ(loaded.features[1].descriptor, frames_[2].features[1].descriptor);
  const FrontEndFrame skipped = cache.Find(key_, kFrames)->Frame(1);
  EXPECT_THAT(skipped.features, IsEmpty());
  ASSERT_THAT(skipped.problems, SizeIs(1));
  EXPECT_EQ(skipped.problems[0].side, 1);
  EXPECT_EQ(skipped.problems[0].reason, frames_[1].problems[0].reason);
  EXPECT_EQ(Load(cache, key_, kFrames), BytesOf(frames_));
  EXPECT_THAT(notices_, IsEmpty());
}

TEST_F(CacheFeatures, AnUnfinishedRecordingLeavesNothing) {
  {
    FrontEndRecording recording = Cache().Record();
    recording.Add(frames_[0]);
    EXPECT_THAT(NamesIn(folder()), SizeIs(1));  // the temporary file
  }
  EXPECT_THAT(NamesIn(folder()), IsEmpty());
  Store(Cache(), "", frames_);
  EXPECT_THAT(NamesIn(folder()), IsEmpty());
}

TEST_F(CacheFeatures, AFlippedBitIsDetected) {
  const FrontEndCache cache = Cache();
  Store(cache, key_, frames_);
  const std::string whole = ReadFileBytes(FileOf(key_));
  constexpr std::size_t kStep = 7;  // coprime to 8, so all bit positions are hit
  for (std::size_t at = 0; at < whole.size(); at += kStep) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
    WriteFileBytes(FileOf(key_), damaged);
    notices_.clear();
    std::string loaded;
    const std::string problem = ErrorMessage([&] { loaded = Load(cache, key_, kFrames); });
    EXPECT_EQ(loaded, "") << at;
    EXPECT_NE(problem.empty(), notices_.empty()) << at;
    EXPECT_EQ(fs::exists(FileOf(key_)), notices_.empty()) << at;
  }
}

TEST_F(CacheFeatures, AWrongLengthIsDetected) {
  const FrontEndCache cache = Cache();
  Store(cache, key_, frames_);
  const std::string whole = ReadFileBytes(FileOf(key_));
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    WriteFileBytes(FileOf(key_), whole.substr(0, length));
    notices_.clear();
    EXPECT_EQ(Load(cache, key_, kFrames), "") << length;
    EXPECT_THAT(notices_, SizeIs(1)) << length;
    EXPECT_FALSE(fs::exists(FileOf(key_))) << length;
  }
  WriteFileBytes(FileOf(key_), whole + "x");
  EXPECT_EQ(Load(cache, key_, kFrames), "");
}

TEST_F(CacheFeatures, AFileTruncatedWhileReadIsAnError) {
  const FrontEndCache cache = Cache();
  Store(cache, key_, frames_);
  const std::optional<FeatureFile> file = cache.Find(key_, kFrames);
  fs::resize_file(FileOf(key_), 0);
  EXPECT_THAT(ErrorMessage([&] { (void)file->Frame(3); }), HasSubstr("0 bytes"));
}

TEST_F(CacheFeatures, AnotherVersionIsNotRead) {
  const FrontEndCache cache = Cache();
  Store(cache, key_, frames_);
  std::string bytes = ReadFileBytes(FileOf(key_));
  constexpr std::size_t kVersionAt = 8;
  constexpr std::size_t kChecked = 88;
  ++bytes[kVersionAt];
  bytes.replace(kChecked, 64, Sha256Hex(bytes.substr(0, kChecked)));
  WriteFileBytes(FileOf(key_), bytes);
  EXPECT_FALSE(cache.Find(key_, kFrames));
  ASSERT_THAT(notices_, SizeIs(1));
  EXPECT_THAT(notices_[0], HasSubstr(StrCat("version ", kFeatureFileVersion + 1)));
  EXPECT_FALSE(fs::exists(FileOf(key_)));
}

TEST_F(CacheFeatures, AnEntryWithTheWrongKeyOrFrameCountIsNotRead) {
  const FrontEndCache cache = Cache();
  Store(cache, key_, frames_);
  EXPECT_FALSE(cache.Find(key_, kFrames + 1));
  Store(cache, key_, frames_);
  fs::rename(FileOf(key_), FileOf(SomeKey('b')));
  EXPECT_FALSE(cache.Find(SomeKey('b'), kFrames));
  EXPECT_THAT(notices_, SizeIs(2));
}

TEST_F(CacheFeatures, TheKeyCoversAllInputs) {
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

}  // namespace
}  // namespace cvo::features_test
