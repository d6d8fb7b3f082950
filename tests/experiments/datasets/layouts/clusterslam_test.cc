// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/files/text_file.h"
#include "experiments/datasets/body_truth.h"
#include "tests/experiments/datasets/layouts/written_scene.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::clusterslam_test {
namespace {

namespace fs = std::filesystem;
using test::NumbersText;
using test::WrittenScene;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const RigidTransform kDataFromWorld(ExpSo3({0.4, -0.8, 0.3}), Eigen::Vector3d(3.0, 1.0, -2.0));

std::string PoseRow(const RigidTransform& pose, bool w_first) {
  const auto q = pose.rotation();
  const auto t = pose.translation();
  return (w_first ? NumbersText({t.x(), t.y(), t.z(), q.w(), q.x(), q.y(), q.z()}, " ")
                  : NumbersText({t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}, " ")) +
         "\n";
}

std::string Digits4(std::size_t frame, const char* ending) { return StrCat("000", frame, ending); }

// The landmarks of one cluster, which are fixed in its frame. Cluster 0 is the static scene.
struct Points {
  std::vector<Eigen::Vector3d> p;  // in the world (cluster 0) or in the body
  int cluster = 0;
};

std::vector<Points> LandmarksOf(const WrittenScene& scene) {
  std::vector<Points> all(1);
  for (int i = 0; i < 60; ++i) {
    all[0].p.emplace_back(0.1 * (i % 10) - 0.45, 0.1 * (i / 10) - 0.25, 2.5 + 0.2 * (i % 3));
  }
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    Points& body = all.emplace_back();
    body.cluster = static_cast<int>(k) + 1;
    for (int i = 0; i < 8; ++i) body.p.emplace_back(0.04 * (i % 3), 0.03 * (i % 4), 0.02 * i);
  }
  return all;
}

void WriteLandmarks(const test::TempFolder& root, const WrittenScene& scene) {
  std::string mapping;
  const std::vector<Points> all = LandmarksOf(scene);
  std::vector<std::array<std::string, 2>> texts(scene.frames());
  int id = 0;
  for (const Points& points : all) {
    for (const Eigen::Vector3d& p : points.p) {
      ++id;
      mapping += StrCat(id, " ", points.cluster, "\n");
      for (std::size_t k = 0; k < scene.frames(); ++k) {
        const Eigen::Vector3d p_in_world =
            points.cluster == 0
                ? p
                : scene.bodies[static_cast<std::size_t>(points.cluster) - 1].world_from_object[k] *
                      p;
        const auto z = scene.camera.Project(scene.world_from_left[k].Inverse() * p_in_world);
        if (!z) continue;
        texts[k][0] += StrCat(id, " ") + NumbersText({z->x(), z->y()}, " ") + "\n";
        texts[k][1] += StrCat(id, " ") + NumbersText({z->z(), z->y()}, " ") + "\n";
      }
    }
  }
  root.Write("SUNCG-1/landmark_mapping.txt", mapping);
  for (std::size_t k = 0; k < scene.frames(); ++k) {
    root.Write("SUNCG-1/landmarks/left/" + Digits4(k, ".txt"), texts[k][0]);
    root.Write("SUNCG-1/landmarks/right/" + Digits4(k, ".txt"), texts[k][1]);
  }
}

fs::path WriteClusterSlam(const test::TempFolder& root, const WrittenScene& scene,
                          bool w_first = true) {
  const StereoCamera& c = scene.camera;
  for (std::size_t k = 0; k < scene.frames(); ++k) {
    std::string poses = PoseRow(kDataFromWorld * scene.world_from_left[k], w_first);
    for (const WrittenScene::Body& body : scene.bodies) {
      poses += PoseRow(kDataFromWorld * body.world_from_object[k], w_first);
    }
    root.Write("SUNCG-1/pose/" + Digits4(k, ".txt"), poses);
    for (std::size_t side = 0; side < 2; ++side) {
      cv::Mat image;  // with an alpha channel, as published
      cv::merge(
          std::vector<cv::Mat>{scene.images[k][side], scene.images[k][side], scene.images[k][side],
                               cv::Mat(scene.images[k][side].size(), CV_8UC1, cv::Scalar(9))},
          image);
      test::WriteImage(
          root.path() / "SUNCG-1/images" / (side == 0 ? "left" : "right") / Digits4(k, ".png"),
          image);
    }
  }
  std::string matrices;
  for (const double offset_px : {0.0, -c.fx * c.baseline_m}) {
    matrices += NumbersText({c.fx, 0, c.cx, offset_px}, " ") + "\n" +
                NumbersText({0, c.fy, c.cy, 0}, " ") + "\n0 0 1 0\n\n";
  }
  root.Write("SUNCG-1/instrinsic.txt", matrices);
  WriteLandmarks(root, scene);
  return root.path() / "SUNCG-1";
}

TEST(ClusterSlam, GivesTheSameErrorsAsOurOwnLayout) {
  const test::TempFolder own_folder, folder;
  const test::OwnScene own(own_folder.path() / "scene");
  const fs::path written = WriteClusterSlam(folder, own.written());
  Sequence sequence = OpenSequence({.folder = written, .detections_file = own.detections()});
  EXPECT_EQ(sequence.type, "clusterslam");
  EXPECT_EQ(sequence.name, "SUNCG-1");
  EXPECT_THAT(sequence.missing, IsEmpty());
  test::ExpectSameSequence(own.Open(), sequence);
  // Without labelled pixels, bodies are matched by nearness in both: there are too few labelled
  // landmarks here.
  sequence.bodies->pixels.clear();
  for (std::size_t i = 0; i < 2; ++i) {
    sequence.bodies->objects.bodies[i].size_m = own.written().bodies[i].size_m;
  }
  test::ExpectSameErrors(own.Open(), sequence, false, false);
}

class ClusterSlamFiles : public testing::Test {
 protected:
  ClusterSlamFiles() : scene_(test::SmallScene()), written_(WriteClusterSlam(folder_, scene_)) {}
  Sequence Open(const Json& layout = Json::object()) const {
    return OpenSequence({.folder = written_, .layout = layout});
  }
  std::string Refused(const Json& layout = Json::object()) const {
    return ErrorMessage([&] { Open(layout); });
  }

  test::TempFolder folder_;
  WrittenScene scene_;
  fs::path written_;
};

// Landmarks determine the order, and the camera poses are the same in either.
TEST_F(ClusterSlamFiles, DetectsTheQuaternionOrder) {
  const RigidTransform first = *Open().groundtruth_world_from_camera[2];
  const test::TempFolder other;
  WriteClusterSlam(other, scene_, false);
  const Sequence sequence = OpenSequence({.folder = other.path() / "SUNCG-1"});
  const RigidTransform second = *sequence.groundtruth_world_from_camera[2];
  EXPECT_LT((first.translation() - second.translation()).norm(), 1e-9);
  const RigidTransform expected = scene_.world_from_left[0].Inverse() * scene_.world_from_left[2];
  EXPECT_LT((first.translation() - expected.translation()).norm(), 1e-9);
  fs::remove(written_ / "landmark_mapping.txt");
  EXPECT_THAT(Open().missing, Contains(HasSubstr("landmarks that tell the order")));
}

TEST_F(ClusterSlamFiles, PosesThatContradictLandmarksAreRefused) {
  for (std::size_t k = 0; k < 3; ++k) {
    fs::path file = written_ / "pose" / Digits4(k, ".txt");
    std::string rows;
    for (int i = 0; i < 3; ++i) {
      rows += PoseRow(RigidTransform(ExpSo3({0.1, 0.5 * static_cast<double>(k), 0.0}),
                                     Eigen::Vector3d(static_cast<double>(k), 0, 0)),
                      true);
    }
    WriteFileBytes(file, rows);
  }
  EXPECT_THAT(Refused(), AllOf(HasSubstr("in either order of quaternions"), HasSubstr("pose")));
}

TEST_F(ClusterSlamFiles, LandmarksLabelNearbyPixels) {
  const auto truth = ReadBodyTruth(Open());
  const auto z = scene_.camera.Project(scene_.world_from_left[0].Inverse() *
                                       Eigen::Vector3d(-0.45, -0.25, 2.5));
  const Eigen::Vector2d at = z->head<2>();
  EXPECT_EQ(truth->Find(0, at, {0, 0, 2.5}).body, 0);
  EXPECT_EQ(truth->Find(0, {0.0, 31.0}, {0, 0, 2.5}).body, -1);
  EXPECT_TRUE(truth->objects().tells_pixels);
  EXPECT_TRUE(truth->objects().bodies[0].frames[0]->visible);
}

TEST_F(ClusterSlamFiles, BoxesAreDerivedFromLandmarks) {
  const Sequence sequence = OpenSequence({.folder = written_, .detections_file = "labels"});
  ASSERT_EQ(sequence.detections.size(), 6U);
  EXPECT_EQ(sequence.labels[1].track, 2);
  EXPECT_EQ(sequence.labels[1].type, "Block");
  EXPECT_LT(sequence.labels[1].left_px, sequence.labels[1].right_px);
  EXPECT_EQ(ReadBodyTruth(sequence)->BodyOfTrack(2), 2);
}

TEST_F(ClusterSlamFiles, BadRowsAreRefusedWithFileAndRow) {
  const std::string camera = "instrinsic.txt";
  const auto expect = [&](const std::string& file, const test::Edit& edit,
                          const std::string& says) {
    test::ExpectRefused({.folder = written_}, written_ / file, edit, says);
  };
  expect("landmark_mapping.txt", test::RepeatRow(5),
         "landmark_mapping.txt:6: found landmark 5 a second time");
  expect("landmark_mapping.txt", test::Replace("5 0", "5 3"),
         "landmark_mapping.txt:5: found cluster 3 | 0 to 2");
  expect("landmarks/right/0001.txt", test::RepeatRow(2),
         "right/0001.txt:3: found landmark 2 a second time");
  expect("pose/0002.txt", test::DropRow(3), "pose/0002.txt: found 2 rows | expected 3");
  expect("pose/0002.txt", test::CutEnd(30), "pose/0002.txt:3: found | columns");
  expect(
      "pose/0002.txt", [](const fs::path& file) { fs::remove(file); },
      "pose: found 2 files | as many as images");
  expect(camera, test::Replace(" -4\n", " 4\n"),
         "instrinsic.txt:5: found 4 | the right camera is the second");
  expect(camera, test::Replace("0 0 1 0", "0 0.1 1 0"), "instrinsic.txt:3 | a rectified pair");
}

TEST_F(ClusterSlamFiles, WithoutPosesThereIsNoTruth) {
  fs::remove_all(written_ / "pose");
  EXPECT_THAT(Open().missing, ElementsAre(HasSubstr("pose: no ground truth")));
  test::WriteImage(written_ / "images/right/0001.png", cv::Mat(9, 9, CV_8UC1, cv::Scalar(1)));
  EXPECT_THAT(Refused(), AllOf(HasSubstr("0001.png: found 9x9"), HasSubstr("48x32")));
}

}  // namespace
}  // namespace cvo::clusterslam_test
