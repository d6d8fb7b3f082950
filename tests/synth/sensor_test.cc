// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "synth/sensor/sensor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <opencv2/core.hpp>

#include "core/base/rng.h"
#include "synth/detector/detector.h"
#include "synth/truth/truth.h"
#include "synth/write/dataset.h"
#include "tests/support/error_message.h"

namespace cvo::synth {
namespace {

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
};

Moments MomentsOf(const cv::Mat& image) {
  cv::Scalar mean, std;
  cv::meanStdDev(image, mean, std);
  return {mean[0], std[0] * std[0]};
}

cv::Mat Flat(int grey) { return {480, 640, CV_8UC1, cv::Scalar(grey)}; }

SensorOptions AllOff() { return NoiselessSensor({}); }

bool Same(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF) == 0.0; }

constexpr double kRounding = 1.0 / 12.0;  // variance due to rounding to integers

TEST(ApplySensor, WithoutEffectsNothingChanges) {
  const cv::Mat clean = Flat(77);
  EXPECT_TRUE(HasNoEffect(AllOff()));
  EXPECT_TRUE(Same(ApplySensor(clean, AllOff(), 1, 1, 5), clean));
  EXPECT_FALSE(HasNoEffect(SensorOptions()));
}

TEST(ApplySensor, ReadNoiseHasItsVariance) {
  SensorOptions options = AllOff();
  options.read_noise = 3.0;
  const Moments moments = MomentsOf(ApplySensor(Flat(100), options, 0, 0, 0));
  EXPECT_NEAR(moments.mean, 100.0, 0.03);
  EXPECT_NEAR(moments.variance, 9.0 + kRounding, 0.1);
}

// Grey level g corresponds to g / 255 of the full well. The variance in electrons equals their
// number.
TEST(ApplySensor, ShotNoiseVarianceIsProportionalToSignal) {
  SensorOptions options = AllOff();
  options.full_well = 2000.0;
  for (const int grey : {20, 80, 160}) {
    const Moments moments = MomentsOf(ApplySensor(Flat(grey), options, 0, 0, 0));
    EXPECT_NEAR(moments.mean, grey, 0.05);
    EXPECT_NEAR(moments.variance / (grey * 255.0 / 2000.0 + kRounding), 1.0, 0.02) << grey;
  }
}

TEST(ApplySensor, AppliesGainExposureAndBlackLevel) {
  SensorOptions options = AllOff();
  options.gain = 1.5;
  options.exposure_difference = 0.1;
  options.black_level = 4.0;
  EXPECT_TRUE(Same(ApplySensor(Flat(60), options, 0, 0, 0), Flat(94)));
  EXPECT_TRUE(Same(ApplySensor(Flat(60), options, 0, 1, 0), Flat(103)));
}

TEST(ApplySensor, VignettingDarkensTheCorners) {
  SensorOptions options = AllOff();
  options.vignetting = 0.2;
  const cv::Mat image = ApplySensor(Flat(200), options, 0, 0, 0);
  EXPECT_EQ(image.at<unsigned char>(0, 0), 160);
  EXPECT_EQ(image.at<unsigned char>(479, 639), 160);
  EXPECT_EQ(image.at<unsigned char>(240, 320), 200);
  EXPECT_GT(image.at<unsigned char>(240, 0), 160);
  EXPECT_LT(image.at<unsigned char>(240, 0), 200);
}

TEST(ApplySensor, NoiseDependsOnSeedCameraAndFrame) {
  const SensorOptions options;
  const cv::Mat clean = Flat(120);
  const cv::Mat image = ApplySensor(clean, options, 0, 0, 3);
  EXPECT_TRUE(Same(image, ApplySensor(clean, options, 0, 0, 3)));
  EXPECT_FALSE(Same(image, ApplySensor(clean, options, 1, 0, 3)));
  EXPECT_FALSE(Same(image, ApplySensor(clean, options, 0, 1, 3)));
  EXPECT_FALSE(Same(image, ApplySensor(clean, options, 0, 0, 4)));
}

// Two separate blocks in full view, by default for 300 frames, at 10 Hz.
struct Stage {
  explicit Stage(double distance_px = 200.0, int frame_count = 300) {
    for (int i = 0; i < frame_count; ++i) {
      FrameTruth& frame = frames.emplace_back();
      frame.frame = i;
      frame.time_s = 0.1 * i;
      for (int id = 1; id <= 2; ++id) {
        BodyTruth& body = frame.bodies.emplace_back();
        body.id = id;
        body.visible_px = body.alone_px = 8000;
        body.visible_fraction = 1.0;
        const double left = 150.0 + distance_px * (id - 1);
        body.visible_box = PixelBox{left, 200.0, left + 100.0, 280.0};
      }
    }
  }
  DetectorInput Input() const { return {640, 480, {"Block", "Block"}, frames}; }
  std::vector<Detection> Run(const DetectorOptions& options, std::uint64_t seed = 0) const {
    return Detect(Input(), options, seed);
  }

  std::vector<FrameTruth> frames;
};

double Overlap(const PixelBox& a, const PixelBox& b) {
  const double both = IntersectionArea_px2(a, b);
  return both / (Area_px2(a) + Area_px2(b) - both);
}

struct Quality {
  double recall = 0.0;
  double overlap = 0.0;
  double false_positives = 0.0;
};

Quality Measure(const Stage& stage, const std::string& level) {
  Quality quality;
  int found = 0;
  for (const Detection& detection : stage.Run(DetectorLevel(level))) {
    if (detection.body == 0) {
      quality.false_positives += 1.0;
      continue;
    }
    ++found;
    const auto frame = static_cast<std::size_t>(detection.frame);
    quality.overlap += Overlap(
        detection.box,
        *stage.frames[frame].bodies[static_cast<std::size_t>(detection.body - 1)].visible_box);
  }
  quality.overlap /= found;
  quality.recall = found / (2.0 * static_cast<double>(stage.frames.size()));
  return quality;
}

TEST(Detect, OracleGivesTheVisibleBoxes) {
  const Stage stage;
  const std::vector<Detection> detections = stage.Run(DetectorLevel("oracle"));
  ASSERT_EQ(detections.size(), 600U);
  for (const Detection& detection : detections) {
    const auto frame = static_cast<std::size_t>(detection.frame);
    const auto body = static_cast<std::size_t>(detection.body - 1);
    const PixelBox& truth = *stage.frames[frame].bodies[body].visible_box;
    EXPECT_EQ(detection.box.left, truth.left);
    EXPECT_EQ(detection.box.top, truth.top);
    EXPECT_EQ(detection.box.right, truth.right);
    EXPECT_EQ(detection.box.bottom, truth.bottom);
    EXPECT_EQ(detection.score, 1.0);
  }
}

TEST(Detect, LevelsAreInOrder) {
  const Stage stage;
  const Quality oracle = Measure(stage, "oracle");
  const Quality good = Measure(stage, "good");
  const Quality poor = Measure(stage, "poor");
  EXPECT_GT(oracle.recall, good.recall);
  EXPECT_GT(good.recall, poor.recall + 0.05);
  EXPECT_GT(oracle.overlap, good.overlap);
  EXPECT_GT(good.overlap, poor.overlap + 0.05);
  EXPECT_EQ(oracle.false_positives, 0.0);
  EXPECT_GT(good.false_positives, 0.0);
  EXPECT_GT(poor.false_positives, 2.0 * good.false_positives);
}

TEST(Detect, SameSeedSameBoxes) {
  const Stage stage;
  const std::string first = FormatDetections(stage.Run({}, 5));
  EXPECT_EQ(first, FormatDetections(stage.Run({}, 5)));
  EXPECT_NE(first, FormatDetections(stage.Run({}, 6)));
}

DetectorOptions OnlyJitter() {
  DetectorOptions options = DetectorLevel("oracle");
  options.jitter_width = 0.1;
  options.jitter_slow = 1.0;
  options.jitter_time_s = 0.5;
  return options;
}

// Standard deviation of the left edge, and its correlation from one frame to the next.
TEST(Detect, JitterHasItsSizeAndCorrelation) {
  const Stage stage(200.0, 6000);
  double variance = 0.0, product = 0.0;
  std::map<int, double> last;
  for (const Detection& detection : stage.Run(OnlyJitter())) {
    const double error = detection.box.left - (150.0 + 200.0 * (detection.body - 1));
    variance += error * error;
    if (last.contains(detection.body)) product += error * last[detection.body];
    last[detection.body] = error;
  }
  EXPECT_NEAR(std::sqrt(variance / 12000.0), 10.0, 0.8);
  EXPECT_NEAR(product / variance, std::exp(-0.1 / 0.5), 0.02);
}

TEST(Detect, BurstsHaveTheirRateAndDuration) {
  const Stage stage(200.0, 6000);
  DetectorOptions options = DetectorLevel("oracle");
  options.burst_rate_hz = 0.5;
  options.burst_s = 1.0;
  int misses = 12000, runs = 0;
  std::map<int, int> last = {{1, -1}, {2, -1}};
  for (const Detection& detection : stage.Run(options)) {
    --misses;
    if (detection.frame > last[detection.body] + 1) ++runs;
    last[detection.body] = detection.frame;
  }
  EXPECT_NEAR(misses / 12000.0, 1.0 / 3.0, 0.05);
  EXPECT_NEAR(static_cast<double>(misses) / runs, 10.5, 1.5);
}

TEST(Detect, SmallAndHiddenBodiesAreMissed) {
  Stage stage;
  for (FrameTruth& frame : stage.frames) {
    frame.bodies[0].visible_box = PixelBox{150.0, 200.0, 158.0, 208.0};
    frame.bodies[1].visible_fraction = 0.1;
  }
  DetectorOptions options = DetectorLevel("oracle");
  options.miss_size_px = 14.0;
  options.miss_visible = 0.2;
  int found[3] = {0, 0, 0};
  for (const Detection& detection : stage.Run(options)) ++found[detection.body];
  EXPECT_NEAR(found[1], 300.0 / (1.0 + std::pow(14.0 / 9.0, 4)), 25.0);
  EXPECT_NEAR(found[2], 300.0 / (1.0 + std::pow(2.0, 4)), 18.0);
}

TEST(Detect, OverlappingBoxesAreMerged) {
  DetectorOptions options = DetectorLevel("oracle");
  options.merge_rate = 1.0;
  const std::vector<Detection> merged = Stage(30.0).Run(options);
  ASSERT_EQ(merged.size(), 300U);
  EXPECT_EQ(merged[0].box.left, 150.0);
  EXPECT_EQ(merged[0].box.right, 280.0);
  EXPECT_EQ(Stage(90.0).Run(options).size(), 600U);
}

TEST(Detect, FalsePositivesHaveTheirRateAndPersist) {
  const Stage stage(200.0, 3000);
  DetectorOptions options = DetectorLevel("oracle");
  options.false_positives = 0.5;
  options.false_positive_s = 0.4;
  std::map<int, std::vector<double>> lefts;
  int count = 0;
  for (const Detection& detection : stage.Run(options)) {
    if (detection.body != 0) continue;
    ++count;
    lefts[detection.frame].push_back(detection.box.left);
  }
  EXPECT_NEAR(count / 3000.0, 0.5, 0.08);
  int stayed = 0;
  for (const auto& [frame, here] : lefts) {
    for (const double left : here) {
      const auto next = lefts.find(frame + 1);
      if (next == lefts.end()) continue;
      stayed += std::count(next->second.begin(), next->second.end(), left) > 0 ? 1 : 0;
    }
  }
  EXPECT_NEAR(static_cast<double>(stayed) / count, std::exp(-0.1 / 0.4), 0.05);
}

TEST(FormatDetections, HasEighteenColumns) {
  EXPECT_EQ(FormatDetections({{3, 1, "Ball", {1.0, 2.25, 30.5, 40.0}, 0.75}}),
            "3 -1 Ball -1 -1 -10 1.00 2.25 30.50 40.00 -1 -1 -1 -1000 -1000 -1000 -10 0.7500\n");
}

TEST(ReadDetectors, AddsCustomOnlyIfTheSceneChangesValues) {
  EXPECT_EQ(ReadDetectors(Json::object(), "x.json", {}).size(), 3U);
  EXPECT_EQ(ReadDetectors({{"level", "poor"}}, "x.json", {}).size(), 3U);
  const auto detectors =
      ReadDetectors({{"level", "poor"}, {"miss_rate", 0.4}}, "x.json", {"custom"});
  ASSERT_EQ(detectors.size(), 1U);
  EXPECT_EQ(detectors[0].name, "custom");
  EXPECT_EQ(detectors[0].options.miss_rate, 0.4);
  EXPECT_EQ(detectors[0].options.jitter_width, DetectorLevel("poor").jitter_width);
}

TEST(ReadDetectors, WrongSettingsAreReported) {
  const auto message = [](const Json& section, const std::vector<std::string>& chosen) {
    return ErrorMessage([&] { ReadDetectors(section, "x.json", chosen); });
  };
  EXPECT_EQ(message({{"level", "gud"}}, {}),
            "x.json: detector.level: found \"gud\", expected \"oracle\", \"good\" or \"poor\"");
  EXPECT_THAT(message({{"mis_rate", 0.1}}, {}), testing::HasSubstr("x.json: detector"));
  EXPECT_THAT(message({{"miss_rate", 2}}, {}), testing::HasSubstr("miss_rate"));
  EXPECT_THAT(message(Json::object(), {"custom"}), testing::HasSubstr("\"custom\""));
  EXPECT_THAT(message(Json::object(), {"god"}), testing::HasSubstr("did you mean good"));
}

TEST(ReadSensor, OverridesDefaults) {
  const SensorOptions options = ReadSensor({{"read_noise", 2}}, "x.json");
  EXPECT_EQ(options.read_noise, 2.0);
  EXPECT_EQ(options.vignetting, SensorOptions().vignetting);
  EXPECT_THAT(ErrorMessage([] {
                ReadSensor({{"reed_noise", 2}}, "x.json");
              }),
              testing::HasSubstr("reed_noise"));
}

}  // namespace
}  // namespace cvo::synth
