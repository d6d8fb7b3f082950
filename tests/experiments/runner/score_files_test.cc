// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/files/json/json.h"
#include "experiments/metrics/camera_metrics.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/runner/system_run.h"
#include "tests/support/error_message.h"
#include "tests/support/temp_folder.h"

namespace cvo::test::score_files_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A drive behind two cars, and files that another system could have written for it.

constexpr int kDriveFrames = 8;
constexpr double kLeftOffset_m = 0.06;  // p_in_read = p_in_camera0 + (offset, 0, 0)

RigidTransform DriveCamera(int frame) {
  return {ExpSo3({0.0, 0.02 * frame, 0.0}), Eigen::Vector3d(0.1 * frame, 0.0, frame)};
}

// Pose of a car in the world, with its origin at the centre of its box. Both cars advance by 0.9 m
// per frame; the second one turns.
RigidTransform CarInWorld(int track, int frame) {
  const double heading_rad = -1.5 + (track == 1 ? 0.05 * frame : 0.0);
  return {ExpSo3({0.0, heading_rad, 0.0}),
          Eigen::Vector3d(track == 0 ? -2.0 : 4.0, 0.8, 12.0 + 3.0 * track + 0.9 * frame)};
}

// A box as a system reports it.
struct ReportedBox {
  int track = 0;
  RigidTransform world_from_object;
};

// Returns the reported box in camera 0.
ObjectBox BoxOf(const ReportedBox& reported, int frame) {
  const RigidTransform camera_from_object =
      DriveCamera(frame).Inverse() * reported.world_from_object;
  const Eigen::Vector3d forward = camera_from_object.rotation() * Eigen::Vector3d::UnitX();
  ObjectBox box;
  box.frame = frame;
  box.track = reported.track;
  box.type = "Car";
  box.occlusion = 0;
  box.right_px = box.bottom_px = 100.0;
  box.box3d = {1.5, 1.8, 4.0,
               camera_from_object.translation() + Eigen::Vector3d(-kLeftOffset_m, 0.75, 0.0),
               std::atan2(-forward.z(), forward.x())};
  return box;
}

std::string Row(const ObjectBox& box) {
  const ObjectBox::Box3d& b = *box.box3d;
  std::ostringstream row;
  row.precision(17);
  row << box.frame << ' ' << box.track << ' ' << box.type << " -1 -1 0 0 0 100 100 " << b.height_m
      << ' ' << b.width_m << ' ' << b.length_m << ' ' << b.bottom_in_camera.x() << ' '
      << b.bottom_in_camera.y() << ' ' << b.bottom_in_camera.z() << ' ' << b.heading_rad << " 1\n";
  return row.str();
}

// Rows of the boxes in the sequence's labels, or as `report` changes them. A box is omitted if
// `report` returns no value.
using ReportBox = std::function<std::optional<ReportedBox>(ReportedBox truth, int frame)>;
std::string Rows(const ReportBox& report = [](const ReportedBox& truth, int) { return truth; }) {
  std::string rows;
  for (int frame = 0; frame < kDriveFrames; ++frame) {
    for (const int track : {0, 1}) {
      const auto reported = report({track, CarInWorld(track, frame)}, frame);
      if (reported) rows += Row(BoxOf(*reported, frame));
    }
  }
  return rows;
}

class SystemDrive {
 public:
  SystemDrive() {
    sequence_.name = "drive";
    sequence_.folder = folder_.path();
    sequence_.groundtruth = "official";
    sequence_.left_offset_m = kLeftOffset_m;
    sequence_.total_frames = kDriveFrames;
    for (int frame = 0; frame < kDriveFrames; ++frame) {
      sequence_.images.emplace_back();
      sequence_.timestamps_ns.push_back(100'000'000 * frame);
      sequence_.groundtruth_world_from_camera.emplace_back(DriveCamera(frame));
      for (const int track : {0, 1}) {
        sequence_.labels.push_back(BoxOf({track, CarInWorld(track, frame)}, frame));
      }
    }
  }

  Sequence& sequence() { return sequence_; }
  const TempFolder& folder() const { return folder_; }

  // The true camera trajectory in another world, with timestamps 7 ms late, for the frames of which
  // `has` is true.
  static Trajectory Camera(const std::function<bool(int)>& has = [](int) { return true; }) {
    Trajectory camera;
    for (int frame = 0; frame < kDriveFrames; ++frame) {
      if (has(frame))
        camera.push_back({100'000'000 * frame + 7'000'000, World() * DriveCamera(frame)});
    }
    return camera;
  }
  static RigidTransform World() { return {ExpSo3({0.3, -0.2, 0.1}), {5.0, 6.0, 7.0}}; }

  SystemRequest Request(const std::string& camera, const std::string& rows) const {
    SystemFiles files = {"other", folder_.Write("camera.txt", camera), {}};
    if (rows != "none") files.objects = folder_.Write("tracks.txt", rows);
    return {sequence_, "content", files, 0};
  }
  SystemOutcome Score(const std::string& rows,
                      const std::string& camera = FormatTumTrajectory(Camera())) const {
    return ScoreSystem(Request(camera, rows));
  }

 private:
  TempFolder folder_;
  Sequence sequence_;
};

double ValueOf(const SystemOutcome& outcome, const std::string& name) {
  const Metric* metric = FindMetric(outcome.metrics, name);
  return metric == nullptr ? std::nan("") : metric->value;
}

TEST(ScoreSystem, AnyObjectFrameAndAnyWorldIsAccepted) {
  const SystemDrive drive;
  const RigidTransform off[] = {{ExpSo3({0.0, 0.3, 0.0}), {0.5, -0.2, 0.1}},
                                {ExpSo3({0.0, -1.0, 0.0}), {-0.3, 0.0, 0.4}}};
  const SystemOutcome outcome = drive.Score(Rows([&](ReportedBox said, int) {
    said.world_from_object = said.world_from_object * off[said.track];
    return said;
  }));
  ASSERT_EQ(outcome.bodies.size(), 2U);
  EXPECT_EQ(ValueOf(outcome, "camera_coverage"), 1.0);
  EXPECT_LT(ValueOf(outcome, "camera_ate"), 1e-9);
  EXPECT_EQ(ValueOf(outcome, "object_coverage"), 1.0);
  for (const char* name : {"object_ate", "object_trpe_all_pairs", "object_rrpe_all_pairs",
                           "object_motion_t", "object_motion_r"}) {
    EXPECT_LT(ValueOf(outcome, name), 1e-6) << name;
  }
  EXPECT_EQ(ValueOf(outcome, "object_unmatched_clusters"), 0.0);
}

// The correction that our readers know for a calibration does not tell which one the system was
// given.
TEST(ScoreSystem, CorrectionIsTheSystemsOwn) {
  SystemDrive drive;
  drive.sequence().camera.right_shift_px = 0.16;
  const auto correction = [&](double right_shift_px) {
    SystemRequest request = drive.Request(FormatTumTrajectory(SystemDrive::Camera()), Rows());
    request.right_shift_px = right_shift_px;
    const Json result = ParseJson(ScoreSystem(request).result, "result");
    EXPECT_EQ(result["sequence"]["camera"]["right_shift_px"], right_shift_px);
    return result["metrics"][0]["contract"]["right_shift_px"].get<double>();
  };
  EXPECT_EQ(correction(0.0), 0.0);
  EXPECT_EQ(correction(0.2), 0.2);
}

TEST(ScoreSystem, AFolderOfTrajectoriesScoresLikeItsBoxes) {
  const SystemDrive drive;
  SystemRequest request = drive.Request(FormatTumTrajectory(SystemDrive::Camera()), "none");
  for (const int track : {0, 1}) {
    Trajectory object;
    for (int frame = 0; frame < kDriveFrames; ++frame) {
      object.push_back({100'000'000 * frame, SystemDrive::World() * CarInWorld(track, frame)});
    }
    drive.folder().Write(StrCat("objects/", 3 + track, ".tum"), FormatTumTrajectory(object));
  }
  request.files.objects = drive.folder().path() / "objects";
  const SystemOutcome folder = ScoreSystem(request);
  const SystemOutcome rows = drive.Score(Rows());
  ASSERT_EQ(folder.metrics.size(), rows.metrics.size());
  for (std::size_t i = 0; i < rows.metrics.size(); ++i) {
    EXPECT_EQ(folder.metrics[i].name, rows.metrics[i].name);
    EXPECT_NEAR(folder.metrics[i].value, rows.metrics[i].value, 1e-6) << rows.metrics[i].name;
  }
  EXPECT_EQ(folder.bodies[1].cluster, 4);
}

TEST(ScoreSystem, TheResultHasTheFormatOfARun) {
  const SystemDrive drive;
  const SystemRequest request = drive.Request(FormatTumTrajectory(SystemDrive::Camera()), Rows());
  const Json json = ParseJson(ScoreSystem(request).result, "result");
  EXPECT_EQ(json["kind"], "run");
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["variant"], "system:other");
  EXPECT_EQ(json["system"]["name"], "other");
  EXPECT_EQ(json["job"], IdentifySystem(request));
  EXPECT_EQ(json["frames"].size(), static_cast<std::size_t>(kDriveFrames));
  ASSERT_EQ(json["bodies"]["refined"].size(), 2U);
  EXPECT_EQ(json["bodies"]["refined"][0]["errors"]["frames"].size(),
            static_cast<std::size_t>(kDriveFrames));
  for (const Json& metric : json["metrics"]) EXPECT_EQ(metric["contract"]["poses"], "refined");
}

TEST(IdentifySystem, DependsOnWhatDecidesTheResult) {
  const SystemDrive drive;
  const std::string camera = FormatTumTrajectory(SystemDrive::Camera());
  const std::string job = IdentifySystem(drive.Request(camera, Rows()));
  const auto changed = [&](const std::function<void(SystemRequest&)>& change) {
    SystemRequest request = drive.Request(camera, Rows());
    change(request);
    return IdentifySystem(request) != job;
  };
  EXPECT_FALSE(changed([](SystemRequest&) {}));
  EXPECT_FALSE(changed(
      [&](SystemRequest& r) { r.files.camera = drive.folder().Write("elsewhere.txt", camera); }));
  EXPECT_TRUE(changed([](SystemRequest& r) { r.content = "another"; }));
  EXPECT_TRUE(changed([](SystemRequest& r) { r.files.name = "another"; }));
  EXPECT_TRUE(changed([](SystemRequest& r) { r.files.objects = ""; }));
  EXPECT_TRUE(changed([](SystemRequest& r) { r.seed = 1; }));
  EXPECT_NE(IdentifySystem(drive.Request(camera + "# a comment\n", Rows())), job);
  EXPECT_NE(IdentifySystem(drive.Request(camera, Rows() + Rows())), job);
}

std::string KittiCamera(int begin = 0, int end = kDriveFrames) {
  std::vector<RigidTransform> poses;
  for (int frame = begin; frame < end; ++frame) {
    poses.push_back(SystemDrive::World() * DriveCamera(frame));
  }
  return FormatKittiPoses(poses);
}

// Keeps only frames 2 to 5.
void KeepPart(Sequence& sequence) {
  sequence.first_frame = 2;
  const auto keep = [](auto& values) {
    values.erase(values.begin() + 6, values.end());
    values.erase(values.begin(), values.begin() + 2);
  };
  keep(sequence.images);
  keep(sequence.timestamps_ns);
  keep(sequence.groundtruth_world_from_camera);
  std::erase_if(sequence.labels,
                [](const ObjectBox& box) { return box.frame < 2 || box.frame > 5; });
}

TEST(SystemFiles, FramesOutsideTheRangeAreIgnored) {
  SystemDrive drive;
  KeepPart(drive.sequence());
  for (const std::string& camera :
       {FormatTumTrajectory(SystemDrive::Camera()), KittiCamera(), KittiCamera(2, 6)}) {
    const SystemOutcome outcome = drive.Score(Rows(), camera);
    EXPECT_EQ(outcome.object_frames, 8);
    EXPECT_EQ(ValueOf(outcome, "camera_coverage"), 1.0);
    EXPECT_EQ(ValueOf(outcome, "object_coverage"), 1.0);
    EXPECT_LT(ValueOf(outcome, "camera_ate"), 1e-9);
    EXPECT_LT(ValueOf(outcome, "object_ate"), 1e-9);
  }
}

class BadFiles : public testing::Test {
 protected:
  std::string Camera(const std::string& camera) const {
    return ErrorMessage([&] { drive_.Score("none", camera); });
  }
  std::string Objects(const std::string& rows) const {
    return ErrorMessage([&] { drive_.Score(rows); });
  }
  // The rows with the first `from` replaced by `to`.
  static std::string Changed(const std::string& from, const std::string& to) {
    std::string rows = Rows();
    rows.replace(rows.find(from), from.size(), to);
    return rows;
  }

  SystemDrive drive_;
};

TEST_F(BadFiles, Cameras) {
  const std::string tum = FormatTumTrajectory(SystemDrive::Camera());
  EXPECT_THAT(Camera(tum + "0.95 0 0 0 0 0 0 1\n"),
              AllOf(HasSubstr("camera.txt:9: "), HasSubstr("0.95"), HasSubstr("a frame")));
  EXPECT_THAT(Camera("# of another start\n" + tum + "99 0 0 0 0 0 0 1\n"),
              HasSubstr("camera.txt:10: "));
  EXPECT_THAT(Camera("0.1 0 0 0 0 0 0 1\n0.11 0 0 0 0 0 0 1\n"), HasSubstr("camera.txt:2: "));
  EXPECT_THAT(Camera("0.1 0 0 0 0 0 0 1\n0.0 0 0 0 0 0 0 1\n"), HasSubstr("camera.txt:2: "));
  EXPECT_THAT(Camera("0.1 0 nan 0 0 0 0 1\n"), HasSubstr("camera.txt:1: "));
  EXPECT_THAT(Camera("0.1 0 0 0 0 0 0 1\n"), HasSubstr("found 1 poses"));
  EXPECT_THAT(Camera(""), HasSubstr("no pose"));
  EXPECT_THAT(Camera(KittiCamera(0, 7)),
              AllOf(HasSubstr("camera.txt:7: "), HasSubstr("7 poses"), HasSubstr("8, one per")));
  EXPECT_THAT(ErrorMessage([&] {
                ReadSystem(drive_.sequence(), {"other", "/no/such/camera", {}});
              }),
              HasSubstr("/no/such/camera"));
}

TEST_F(BadFiles, Objects) {
  EXPECT_THAT(Objects(""), AllOf(HasSubstr("tracks.txt:1: "), HasSubstr("DontCare")));
  EXPECT_THAT(Objects(Rows() + Rows()),
              AllOf(HasSubstr("tracks.txt:17: "), HasSubstr("tracks.txt:1")));
  EXPECT_THAT(Objects(Changed("3 1 Car", "8 1 Car")),
              AllOf(HasSubstr("tracks.txt:8: "), HasSubstr("frame 8"), HasSubstr("0 to 7")));
  EXPECT_THAT(Objects(Changed("3 1 Car", "3 -1 Car")),
              AllOf(HasSubstr("tracks.txt:8: "), HasSubstr("track -1")));
  EXPECT_THAT(Objects(Changed(" 1.5 1.8", " -1 1.8")),
              AllOf(HasSubstr("tracks.txt:1: "), HasSubstr("3D box")));
  EXPECT_THAT(Objects(Changed(" 1.5 1.8", " inf 1.8")), HasSubstr("tracks.txt:1: "));
  EXPECT_THAT(Objects("0 1 Car\n"), HasSubstr("tracks.txt:1: "));
}

TEST_F(BadFiles, FoldersOfObjects) {
  const auto objects = [&] {
    const auto camera =
        drive_.folder().Write("camera.tum", FormatTumTrajectory(SystemDrive::Camera()));
    return ErrorMessage([&] {
      ReadSystem(drive_.sequence(), {"other", camera, drive_.folder().path() / "objects"});
    });
  };
  EXPECT_THAT(objects(), HasSubstr("objects"));
  drive_.folder().Write("objects/readme.txt", "");
  EXPECT_THAT(objects(), HasSubstr("<id>.tum"));
  drive_.folder().Write("objects/1.tum", "0.1 0 0 0 0 0 0 1\n9 0 0 0 0 0 0 1\n");
  EXPECT_THAT(objects(), HasSubstr("1.tum:2: "));
  drive_.folder().Write("objects/1.tum", "0.1 0 0 0 0 0 0 1\n");
  EXPECT_EQ(objects(), "");
  drive_.folder().Write("objects/car.tum", "0.1 0 0 0 0 0 0 1\n");
  EXPECT_THAT(objects(), HasSubstr("car.tum"));
}

}  // namespace
}  // namespace cvo::test::score_files_test
