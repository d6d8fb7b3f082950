// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/experiments/datasets/layouts/written_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/files/text/number.h"
#include "core/files/text_file.h"
#include "experiments/datasets/body_truth.h"
#include "experiments/datasets/formats/scene_truth.h"
#include "experiments/datasets/images.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/runner/run_job.h"
#include "tests/experiments/datasets/scene_check/rays.h"
#include "tests/support/error_message.h"
#include "tests/support/image_file.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;

void ExpectSamePose(const RigidTransform& a, const RigidTransform& b, const std::string& what) {
  EXPECT_LT((a.translation() - b.translation()).norm(), 1e-9) << what;
  EXPECT_LT(RotationAngle(a.rotation().conjugate() * b.rotation()), 1e-9) << what;
}

void ExpectSameBodies(const ObjectTruth& own, const ObjectTruth& other) {
  ASSERT_EQ(own.bodies.size(), other.bodies.size());
  for (std::size_t i = 0; i < own.bodies.size(); ++i) {
    std::optional<RigidTransform> turn;  // of the object frame
    for (std::size_t k = 0; k < own.frame_count(); ++k) {
      const auto& a = own.bodies[i].frames[k];
      const auto& b = other.bodies[i].frames[k];
      ASSERT_TRUE(a && b) << "body " << i << ", frame " << k;
      EXPECT_EQ(a->visible, b->visible) << "body " << i << ", frame " << k;
      if (!turn) turn = b->world_from_object.Inverse() * a->world_from_object;
      EXPECT_LT(turn->translation().norm(), 1e-9) << "body " << i;
      ExpectSamePose(a->world_from_object, b->world_from_object * *turn,
                     StrCat("body ", i, ", frame ", k));
    }
  }
}

RunScores Score(const Sequence& sequence, BodyTruthReader& truth) {
  const VariantInfo& full = FindVariant("full");
  const auto run = RunSequence(
      {.sequence = sequence, .variant = full, .options = full.defaults(), .seed = 1}, &truth);
  return ScoreRun(run.value(), &truth.objects());
}

void ExpectSameMetrics(const std::vector<Metric>& own, const std::vector<Metric>& other) {
  ASSERT_EQ(own.size(), other.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(own[i].name, other[i].name);
    EXPECT_NEAR(own[i].value, other[i].value, 1e-9) << own[i].name;
  }
}

}  // namespace

WrittenScene SmallScene() {
  WrittenScene scene;
  scene.camera = {.fx = 40.0,
                  .fy = 40.0,
                  .cx = 23.5,
                  .cy = 15.5,
                  .baseline_m = 0.1,
                  .width_px = 48,
                  .height_px = 32};
  Rng rng(1, "small");
  scene.bodies = {{"box1", "Block", {0.3, 0.3, 0.3}, {}}, {"box2", "Block", {0.2, 0.4, 0.6}, {}}};
  for (int k = 0; k < 3; ++k) {
    scene.times_ns.push_back(1'000'000'000 + 100'000'000LL * k);
    scene.world_from_left.emplace_back(ExpSo3({0.0, 0.05 * k, 0.01}),
                                       Eigen::Vector3d(0.1 * k, 0.0, 0.02));
    scene.bodies[0].world_from_object.emplace_back(ExpSo3({0.1, 0.2 * k, 0.0}),
                                                   Eigen::Vector3d(0.1 * k, 0.1, 2.0));
    scene.bodies[1].world_from_object.emplace_back(ExpSo3({0.0, 0.0, 0.3}),
                                                   Eigen::Vector3d(-0.4, 0.0, 3.0));
    std::array<cv::Mat, 2> pair;
    for (cv::Mat& image : pair) {
      image.create(scene.camera.height_px, scene.camera.width_px, CV_8UC1);
      for (int i = 0; i < image.rows * image.cols; ++i) {
        image.data[i] = static_cast<unsigned char>(rng.Uniform(0.0, 255.0));
      }
    }
    scene.images.push_back(pair);
    cv::Mat mask(pair[0].size(), CV_16UC1, cv::Scalar(0));
    mask(cv::Rect(4, 4, 24, 24)) = cv::Scalar(1);
    mask(cv::Rect(34, 4, 10, 24)) = cv::Scalar(2);
    scene.masks.push_back(mask);
  }
  return scene;
}

OwnScene::OwnScene(const fs::path& folder) : folder_(folder) {
  WriteRayScene(folder);
  fs::remove(folder / "manifest.json");  // as its files may be edited
  Read();
}

Sequence OwnScene::Open() const {
  return OpenSequence({.folder = folder_, .detections_file = detections()});
}

void OwnScene::Read() {
  const Sequence sequence = Open();
  written_ = {};
  written_.camera = sequence.camera;
  written_.times_ns = sequence.timestamps_ns;
  const auto rows = ReadSceneBodies(folder_ / "objects.csv", sequence.total_frames);
  for (const SceneBody& body : rows.front()) {
    written_.bodies.push_back({body.name, body.category, body.size_m, {}});
  }
  for (std::size_t k = 0; k < sequence.images.size(); ++k) {
    written_.world_from_left.push_back(*sequence.groundtruth_world_from_camera[k]);
    for (std::size_t i = 0; i < rows[k].size(); ++i) {
      written_.bodies[i].world_from_object.push_back(rows[k][i].world_from_object);
    }
    written_.images.push_back(
        {LoadFrameImage(sequence, k, 0).grey, LoadFrameImage(sequence, k, 1).grey});
    written_.masks.push_back(
        ReadInstances(folder_ / "instance_0" / sequence.images[k].left.filename(),
                      cv::Size(sequence.camera.width_px, sequence.camera.height_px)));
  }
}

std::string NumbersText(const std::vector<double>& numbers, const char* separator) {
  std::string text;
  for (const double number : numbers) {
    text += (text.empty() ? "" : separator) + FormatDouble(number);
  }
  return text;
}

std::string MatrixText(const RigidTransform& pose, const char* separator) {
  const Eigen::Matrix4d matrix = pose.Matrix();
  std::vector<double> numbers;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) numbers.push_back(matrix(i, j));
  }
  return NumbersText(numbers, separator);
}

void WriteImage(const fs::path& path, const cv::Mat& image) {
  fs::create_directories(path.parent_path());
  WriteImageFile(path, image);
}

Edit Replace(const std::string& from, const std::string& to) {
  return [=](const fs::path& file) {
    std::string text = ReadFileBytes(file);
    const std::size_t at = text.find(from);
    Require(at != std::string::npos, "Replace: not in the file");
    WriteFileBytes(file, text.replace(at, from.size(), to));
  };
}

namespace {

Edit WithRow(std::size_t row, int times) {
  return [=](const fs::path& file) {
    const TextFile lines(file);
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (int k = 0; k < (i + 1 == row ? times : 1); ++k) text += lines.line(i) + "\n";
    }
    WriteFileBytes(file, text);
  };
}

}  // namespace

Edit DropRow(std::size_t row) { return WithRow(row, 0); }
Edit RepeatRow(std::size_t row) { return WithRow(row, 2); }

Edit CutEnd(std::size_t bytes) {
  return [=](const fs::path& file) {
    const std::string text = ReadFileBytes(file);
    WriteFileBytes(file, text.substr(0, text.size() - bytes));
  };
}

void ExpectRefused(const SequenceRequest& request, const fs::path& file, const Edit& edit,
                   const std::string& says) {
  const std::string text = ReadFileBytes(file);
  edit(file);
  const std::string error = ErrorMessage([&] { OpenSequence(request); });
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 3) {
    end = says.find(" | ", begin);
    EXPECT_THAT(error, testing::HasSubstr(says.substr(begin, end - begin)));
  }
  WriteFileBytes(file, text);
}

void ExpectSameSequence(const Sequence& own, const Sequence& other) {
  ASSERT_EQ(own.images.size(), other.images.size());
  const StereoCamera& a = own.camera;
  const StereoCamera& b = other.camera;
  EXPECT_EQ(a.width_px, b.width_px);
  EXPECT_EQ(a.height_px, b.height_px);
  for (double StereoCamera::*field : {&StereoCamera::fx, &StereoCamera::fy, &StereoCamera::cx,
                                      &StereoCamera::cy, &StereoCamera::baseline_m}) {
    EXPECT_NEAR(a.*field, b.*field, 1e-12);
  }
  EXPECT_EQ(other.groundtruth, "official");
  const std::int64_t offset_ns = other.timestamps_ns[0] - own.timestamps_ns[0];
  for (std::size_t k = 0; k < own.images.size(); ++k) {
    EXPECT_EQ(own.timestamps_ns[k] + offset_ns, other.timestamps_ns[k]);
    ASSERT_TRUE(other.groundtruth_world_from_camera[k]);
    ExpectSamePose(*own.groundtruth_world_from_camera[k], *other.groundtruth_world_from_camera[k],
                   StrCat("camera, frame ", k));
    for (int side = 0; side < 2; ++side) {
      const LoadedImage first = LoadFrameImage(own, k, side);
      const LoadedImage second = LoadFrameImage(other, k, side);
      ASSERT_TRUE(second.ok()) << second.problem;
      EXPECT_EQ(cv::norm(first.grey, second.grey, cv::NORM_L1), 0.0) << "frame " << k;
    }
  }
  const auto bodies = ReadBodyTruth(other);
  if (bodies) ExpectSameBodies(ReadBodyTruth(own)->objects(), bodies->objects());
}

void ExpectSameErrors(const Sequence& own, const Sequence& other, bool tells_pixels,
                      bool clustering) {
  BodyTracks tracks = ReadSceneBodyTracks(own);
  if (!tells_pixels) tracks.mask = nullptr;
  const auto own_truth = MakeTrackBodyTruth(own, tracks);
  const auto other_truth = ReadBodyTruth(other);
  ASSERT_NE(other_truth, nullptr);
  const RunScores a = Score(own, *own_truth);
  const RunScores b = Score(other, *other_truth);
  EXPECT_FALSE(a.refined_bodies.empty());
  EXPECT_TRUE(a.refined_bodies.at(0).ate_m) << "the scene must have an estimate of a body";
  const auto compared = [clustering](std::vector<Metric> metrics) {
    std::erase_if(metrics, [clustering](const Metric& metric) {
      return !clustering && !metric.name.starts_with("camera") &&
             !metric.name.starts_with("object");
    });
    return metrics;
  };
  EXPECT_TRUE(!clustering || FindMetric(a.metrics, "clustering_ari") != nullptr);
  ExpectSameMetrics(compared(a.metrics), compared(b.metrics));
}

}  // namespace cvo::test
