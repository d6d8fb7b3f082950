// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

#include "core/base/error.h"
#include "core/features/front_end.h"
#include "experiments/datasets/images.h"
#include "experiments/runner/frame_source.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_files.h"
#include "experiments/runner/run_job.h"
#include "tests/experiments/runner/tiny_sequence.h"
#include "tests/support/collected.h"
#include "tests/support/temp_folder.h"

namespace cvo::runner_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr int kFrames = 8;

// Moves one metre per frame in z, and in x to the sum of the feature coordinates, so that poses
// reveal which frame was given. Uses the pool as an estimator may.
class FakeOdometry : public Odometry {
 public:
  FakeOdometry(const OdometrySetup& setup, TaskPool& pool) : seed_(setup.seed), pool_(pool) {}

  FrameReport Process(const StereoFrame& frame, StageTimes& times) override {
    times["fake"] = 0.001;
    std::vector<double> sums(4, 0.0);
    pool_.ParallelFor(4, [&](int part) {
      for (const StereoFeature& feature : frame.features) {
        sums[static_cast<std::size_t>(part)] += feature.z_px.sum() / (part + 1.0);
      }
    });
    const double sum = sums[0] + sums[1] + sums[2] + sums[3];
    return Report(trajectory_.empty() ? FrameStatus::kFirst : FrameStatus::kTracked, sum,
                  static_cast<int>(frame.features.size()));
  }

  FrameReport Skip(std::int64_t) override { return Report(FrameStatus::kSkipped, 0.0, 0); }

  std::vector<RigidTransform> Trajectory() const override { return trajectory_; }
  std::vector<ClusterTrajectory> ClusterTrajectories() const override { return {}; }

 protected:
  FrameReport Report(FrameStatus status, double x, int features) {
    FrameReport report;
    report.status = status;
    report.features = features;
    const double z = static_cast<double>(trajectory_.size()) + 0.5 * static_cast<double>(seed_);
    const Eigen::Quaterniond none = Eigen::Quaterniond::Identity();
    report.world_from_camera = RigidTransform(none, Eigen::Vector3d(x, 0, z));
    trajectory_.push_back(RigidTransform(none, Eigen::Vector3d(x, 1, z)));
    return report;
  }

  std::vector<RigidTransform> trajectory_;

 private:
  std::uint64_t seed_;
  TaskPool& pool_;
};

class FailingOdometry : public FakeOdometry {
 public:
  using FakeOdometry::FakeOdometry;
  FrameReport Process(const StereoFrame& frame, StageTimes& times) override {
    if (trajectory_.size() == 3) throw Error("the fake has had enough");
    return FakeOdometry::Process(frame, times);
  }
};

class LosingOdometry : public FakeOdometry {
 public:
  using FakeOdometry::FakeOdometry;
  FrameReport Process(const StereoFrame& frame, StageTimes& times) override {
    FrameReport report = FakeOdometry::Process(frame, times);
    if (trajectory_.size() > 6) report.status = FrameStatus::kLost;
    return report;
  }
};

template <typename T>
std::unique_ptr<Odometry> Make(const OdometrySetup& setup, TaskPool& pool) {
  return std::make_unique<T>(setup, pool);
}

Options Defaults() { return {}; }

const VariantInfo kFake{"fake", "", &Defaults, &Make<FakeOdometry>};
const VariantInfo kFailing{"failing", "", &Defaults, &Make<FailingOdometry>};
const VariantInfo kLosing{"losing", "", &Defaults, &Make<LosingOdometry>};

Sequence Open(const std::filesystem::path& folder) {
  SequenceRequest request;
  request.folder = folder;
  request.type = "kitti-odometry";
  return OpenSequence(request);
}

class Runner : public testing::Test {
 protected:
  Runner() : sequence_((test::WriteTinySequence(path(), kFrames), Open(path()))) {}

  std::filesystem::path path() const { return folder_.path() / "tiny"; }
  std::filesystem::path Left(int frame) const {
    return sequence_.images[static_cast<std::size_t>(frame)].left;
  }
  std::filesystem::path Right(int frame) const {
    return sequence_.images[static_cast<std::size_t>(frame)].right;
  }
  RunRequest Request(const VariantInfo& variant = kFake) const {
    return {.sequence = sequence_, .variant = variant, .options = {}};
  }
  std::string ResultOf(const RunResult& run) const { return ResultFile(run); }

  test::TempFolder folder_;
  Sequence sequence_;
};

TEST_F(Runner, PerturbationsDropFramesAndChangePixelsAndIdentity) {
  const RunResult plain = RunSequence(Request()).value();
  EXPECT_EQ(ResultOf(plain).find("perturbation"), std::string::npos);
  sequence_.perturbation.drop_rate = 1.0;
  const RunResult dropped = RunSequence(Request()).value();
  EXPECT_EQ(dropped.frames[0].report.status, FrameStatus::kFirst);
  for (std::size_t i = 1; i < kFrames; ++i) {
    EXPECT_EQ(dropped.frames[i].report.status, FrameStatus::kSkipped);
    EXPECT_THAT(dropped.frames[i].problems.at(0).reason, HasSubstr("perturb.drop_rate"));
  }
  EXPECT_NE(dropped.content, plain.content);
  EXPECT_THAT(ResultOf(dropped), HasSubstr("\"drop_rate\""));
  sequence_.perturbation = {.blur_px = 3.0};
  const RunResult blurred = RunSequence(Request()).value();
  EXPECT_NE(blurred.frames[1].report.features, plain.frames[1].report.features);
}

TEST_F(Runner, GivesTheFramesInOrder) {
  std::vector<std::size_t> done;
  RunRequest request = Request();
  request.progress = [&done](std::size_t frames) { done.push_back(frames); };
  const RunResult run = RunSequence(request).value();
  EXPECT_EQ(run.status, RunStatus::kOk);
  ASSERT_THAT(run.frames, SizeIs(kFrames));
  EXPECT_THAT(done, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  for (int i = 0; i < kFrames; ++i) {
    const FrameRecord& frame = run.frames[static_cast<std::size_t>(i)];
    EXPECT_EQ(frame.frame, i);
    EXPECT_EQ(frame.timestamp_ns, 100'000'000LL * i);
    EXPECT_EQ(frame.report.world_from_camera.translation().z(), i);
    EXPECT_GT(frame.report.features, 20);
    EXPECT_EQ(frame.refined_world_from_camera.translation().y(), 1.0);
    for (const char* stage : {"decode", "extract", "match_stereo", "fake", "estimate", "frame"}) {
      EXPECT_GE(run.times_s.at(stage).at(static_cast<std::size_t>(i)), 0.0) << stage;
    }
  }
}

TEST_F(Runner, ResultsDoNotDependOnTheNumberOfThreads) {
  test::CutFile(Right(3));
  RunRequest request = Request();
  const std::string one = ResultOf(RunSequence(request).value());
  for (const int threads : {1, 2, 4, 9}) {
    request.threads = threads;
    EXPECT_EQ(ResultOf(RunSequence(request).value()), one) << threads;
  }
  request.seed = 1;
  EXPECT_NE(ResultOf(RunSequence(request).value()), one);
}

TEST_F(Runner, SkipsAFrameThatCannotBeDecodedAndReportsWhy) {
  test::CutFile(Left(0));
  test::CutFile(Right(5));
  std::filesystem::remove(Left(5));
  for (const int threads : {1, 3}) {
    RunRequest request = Request();
    request.threads = threads;
    const RunResult run = RunSequence(request).value();
    EXPECT_EQ(run.status, RunStatus::kOk);
    ASSERT_THAT(run.frames, SizeIs(kFrames));
    EXPECT_EQ(run.frames[0].report.status, FrameStatus::kSkipped);
    EXPECT_EQ(run.frames[5].report.status, FrameStatus::kSkipped);
    EXPECT_EQ(run.frames[6].report.status, FrameStatus::kTracked);
    ASSERT_THAT(run.frames[0].problems, SizeIs(1));
    EXPECT_EQ(run.frames[0].problems[0].image, "image_0/000000.png");
    EXPECT_THAT(run.frames[0].problems[0].reason, HasSubstr("expected"));
    EXPECT_THAT(run.frames[0].problems[0].reason, Not(HasSubstr(folder_.path().string())));
    ASSERT_THAT(run.frames[5].problems, SizeIs(2));
    EXPECT_EQ(run.frames[5].problems[1].image, "image_1/000005.png");
  }
}

TEST_F(Runner, EstimatorErrorsGiveAFailedResult) {
  const std::string content = RunSequence(Request())->content;
  RunRequest request = Request(kFailing);
  request.threads = 2;
  const RunResult run = RunSequence(request).value();
  EXPECT_EQ(run.status, RunStatus::kFailed);
  EXPECT_EQ(run.message, "frame 3: the fake has had enough");
  EXPECT_THAT(run.frames, SizeIs(3));
  EXPECT_EQ(run.content, content);
  EXPECT_TRUE(ScoreRun(run).metrics.empty());
  EXPECT_NO_THROW(ResultOf(run));
}

TEST_F(Runner, ReportsTheNumberOfLostFrames) {
  const RunResult run = RunSequence(Request(kLosing)).value();
  EXPECT_EQ(run.status, RunStatus::kLost);
  EXPECT_EQ(run.message, "2 of 8 frames lost, the first is frame 6");
}

TEST_F(Runner, StopsAfterTheCurrentFrame) {
  for (const int threads : {1, 2}) {
    std::size_t frames = 0;
    RunRequest request = Request();
    request.threads = threads;
    request.progress = [&frames](std::size_t done) { frames = done; };
    request.stop = [&frames] { return frames == 3; };
    EXPECT_FALSE(RunSequence(request).has_value());
    EXPECT_EQ(frames, 3U);
  }
}

TEST_F(Runner, ExtractsTheFeaturesOfTheFrontEnd) {
  Options options;
  options.stereo.right_features = 2.0;
  // Fewer than the tiny images have, so that the number in the right image matters.
  options.orb.features = 40;
  TaskPool pool(1);
  const std::vector<StereoFeature> features =
      FrameSource({sequence_, options, {}}, pool).Next().features;
  const cv::Mat left = LoadGrey(sequence_.images[0].left).grey;
  const cv::Mat right = LoadGrey(sequence_.images[0].right).grey;
  const std::vector<StereoFeature> expected =
      ExtractStereoFeatures(left, right, sequence_.camera, options.orb, options.stereo, pool);
  ASSERT_THAT(features, SizeIs(expected.size()));
  for (std::size_t i = 0; i < features.size(); ++i) EXPECT_EQ(features[i].z_px, expected[i].z_px);
  options.stereo.right_features = 1.0;
  EXPECT_NE(FrameSource({sequence_, options, {}}, pool).Next().features.size(), expected.size());
}

TEST_F(Runner, ExtractsAdditionalCornersInDetections) {
  Options options;
  options.orb.features = 60;
  options.orb.box_features = 50;
  ObjectBox box;
  box.frame = sequence_.first_frame;
  box.left_px = 60.0;
  box.top_px = 40.0;
  box.right_px = 100.0;
  box.bottom_px = 80.0;
  sequence_.detections = {box};
  TaskPool pool(1);
  const std::vector<StereoFeature> features =
      FrameSource({sequence_, options, {}}, pool).Next().features;
  const cv::Mat left = LoadGrey(sequence_.images[0].left).grey;
  const cv::Mat right = LoadGrey(sequence_.images[0].right).grey;
  const auto extract = [&](const std::vector<cv::Rect2d>& boxes) {
    return ExtractStereoFeatures(left, right, sequence_.camera, options.orb, options.stereo, pool,
                                 std::span(&boxes, 1));
  };
  const auto same = [](const std::vector<StereoFeature>& a, const std::vector<StereoFeature>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return x.z_px == y.z_px; });
  };
  EXPECT_TRUE(same(features, extract({{60.0, 40.0, 40.0, 40.0}})));
  EXPECT_FALSE(same(features, extract({})));
}

TEST_F(Runner, ScoresBothTrajectories) {
  const RunResult run = RunSequence(Request()).value();
  std::map<reports::PoseTime, int> counts;
  for (const Metric& metric : ScoreRun(run).metrics) {
    const bool causal = metric.contract.poses == reports::PoseTime::kCausal;
    ++counts[*metric.contract.poses];
    EXPECT_THAT(metric.name, testing::StartsWith(causal ? "camera_causal_" : "camera_"));
    EXPECT_EQ(metric.contract.truth, reports::TruthSource::kOfficial);
  }
  EXPECT_GT(counts[reports::PoseTime::kCausal], 0);
  constexpr int kDrifts = 12;  // maximum drift exists for refined poses only
  EXPECT_EQ(counts[reports::PoseTime::kRefined], counts[reports::PoseTime::kCausal] + kDrifts);
}

TEST_F(Runner, TheContentHashDependsOnBytesNotPaths) {
  const std::string content = RunSequence(Request())->content;
  const auto copy = folder_.path() / "copy" / "tiny";
  std::filesystem::create_directories(copy.parent_path());
  std::filesystem::copy(path(), copy, std::filesystem::copy_options::recursive);
  const Sequence copied = Open(copy);
  EXPECT_EQ(RunSequence({.sequence = copied, .variant = kFake, .options = {}})->content, content);

  test::CutFile(copied.images[7].right);
  EXPECT_NE(RunSequence({.sequence = copied, .variant = kFake, .options = {}})->content, content);
  sequence_.camera.baseline_m += 1e-9;
  EXPECT_NE(RunSequence(Request())->content, content);
}

}  // namespace
}  // namespace cvo::runner_test
