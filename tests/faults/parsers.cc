// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/faults/parsers.h"

#include <chrono>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/files/images/image_file.h"
#include "core/files/json/options_json.h"
#include "core/files/text_file.h"
#include "core/interface/options.h"
#include "core/record/csv_rows.h"
#include "core/record/metric_catalogue.h"
#include "core/record/run_summary.h"
#include "core/record/truth.h"
#include "experiments/datasets/calibration/kitti_calibration.h"
#include "experiments/datasets/calibration/rig_file.h"
#include "experiments/datasets/formats/data_rows.h"
#include "experiments/datasets/formats/image_format.h"
#include "experiments/datasets/formats/object_boxes.h"
#include "experiments/datasets/formats/scene_truth.h"
#include "experiments/datasets/sequence_parts.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/runner/front_end_cache.h"
#include "experiments/suite/build_plan.h"
#include "experiments/suite/suite.h"
#include "reports/gate/baseline.h"
#include "reports/runs/run_detail.h"
#include "reports/tables/table.h"
#include "synth/family/family.h"
#include "synth/scene/description.h"
#include "synth/write/dataset.h"
#include "synth/write/render_cache.h"

namespace cvo::test {
namespace {

namespace fs = std::filesystem;

constexpr int kFrames = 10;  // of the sequence that boxes belong to
constexpr const char* kBox = "1 3 Car 0 0 0 10 10 40 40 1.5 1.6 4 0 1 8 0";

std::string Source(const std::string& name) {
  return ReadFileBytes(fs::path(CVO_SOURCE_DIR) / name);
}

std::string Golden(const std::string& name) {
  return Source("tests/reports/results/golden/" + name + ".json");
}

std::string DefaultOptions() {
  Options options;
  return DumpJson(OptionsToJson(OptionLeaves(options)));
}

std::string Repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

cv::Mat RandomImage(int type) {
  cv::Mat image(6, 9, type);
  cv::randu(image, 0, 256);
  return image;
}
std::string Png(int type) { return EncodeImage(".png", RandomImage(type)); }

std::string SceneManifest() {
  synth::Manifest manifest;
  manifest.scene = "tiny";
  manifest.frames = {0, 3};
  manifest.files = {{"image_0/000000.png", 17, "ab"}};
  return synth::FormatManifest(manifest);
}

std::string CachedFrame(bool damaged) {
  FrontEndFrame frame;
  if (damaged) {
    frame.problems.push_back({1, "a file that ends"});
  } else {
    frame.features.resize(2);
  }
  return EncodeFrame(frame);
}

std::vector<Parser> SuiteParsers() {
  return {
      {"suite",
       {Source("experiments/configs/ci.json"), Source("experiments/configs/sweep_alpha.json"),
        Source("experiments/configs/kitti_raw.json")},
       [](const fs::path& file) { ReadCheckedSuite(ReadJson(file), file, file.parent_path()); }},
      {"scene",
       {Source("synth/scenes/tiny.json"), Source("synth/scenes/swinging_4.json")},
       [](const fs::path& file) { synth::SceneDescription::Parse(ReadJson(file), file); }},
      {"family",
       {Source("synth/families/room.json"), Source("synth/families/street.json")},
       [](const fs::path& file) { synth::ParseFamily(ReadJson(file), file); }},
      {"options",
       {DefaultOptions()},
       [](const fs::path& file) { ResolveOptions<Options>(file, {}); }},
      {"plan", {Golden("plan")}, [](const fs::path& file) { ParsePlan(ReadJson(file), file); }}};
}

std::vector<Parser> ResultParsers() {
  using namespace reports;
  return {
      {"result", {Golden("result")}, [](const fs::path& file) { ReadRun(file, AllMetricNames()); }},
      {"timing", {Golden("timing")}, [](const fs::path& file) { ReadRecord<TimingData>(file); }},
      {"truth", {Golden("truth")}, [](const fs::path& file) { ReadRecord<TruthData>(file); }},
      {"baseline", {Golden("baseline")}, [](const fs::path& file) { ReadBaseline(file); }},
      {"clusters.csv",
       {StrCat(CsvHeader<ObjectRow>(),
               "\n3,0,1,Car,tracked,1,2,3,0,0,0,1,0,0,0,,,,,,,,,,,,0,0,0,1,2,3,0,0,0,0,0,0,1,"
               "1,2,3,1,2,3,4,17,0,0.5\n")},
       [](const fs::path& file) { ReadObjects(file); }},
      {"landmarks.csv",
       {StrCat(CsvHeader<LandmarkRow>(), "\n0,7,10.5,20,9,0,1,2,1,2,3,\n")},
       [](const fs::path& file) { ReadLandmarks(file, LandmarkLabel::kCluster); }}};
}

std::vector<Parser> SequenceParsers() {
  return {
      {"calibration",
       {"P0: 200 0 128 0 0 200 64 0 0 0 1 0\nP1: 200 0 128 -100 0 200 64 0 0 0 1 0\n"},
       [](const fs::path& file) {
         const CalibrationFile calibration(file);
         (void)CameraRig(calibration, "P").Stereo(0, 1, 256, 128);
       }},
      {"times", {"0\n0.1\n2e-1\n"}, [](const fs::path& file) { ReadTimes(file); }},
      {"dates",
       {"2011-09-26 13:02:25.964389445\n2011-09-26 13:02:26.064389445\n"},
       [](const fs::path& file) { ReadDateTimes(file); }},
      {"poses",
       {Repeated("1 0 0 1 0 1 0 2 0 0 1 3\n", 2)},
       [](const fs::path& file) { ReadKittiPoses(file); }},
      {"trajectory",
       {"# comment\n1.5 1 2 3 0 0 0 1\n2.5 1 2 3 0 0 0.6 0.8\n"},
       [](const fs::path& file) { ReadTrajectory(file); }},
      {"oxts",
       {"49 8 112" + Repeated(" 0.1", 27) + "\n"},
       [](const fs::path& file) { ImuPoses(ReadOxtsPackets(file)); }},
      {"labels",
       {StrCat(kBox, "\n0 -1 DontCare -1 -1 -10 1 2 3 4 -1 -1 -1 -1000 -1000 -1000 -10\n")},
       [](const fs::path& file) { ReadLabels(file, kFrames); }},
      {"detections",
       {StrCat(kBox, " 0.5\n", kBox, " 0.9\n")},
       [](const fs::path& file) { ReadDetections(file, kFrames); }},
      {"objects",
       {"Car 0 0 0 10 10 40 40 1.5 1.6 4 0 1 8 0 0.5\n"},
       [](const fs::path& file) { ReadObjectFile(file, 0); }},
      {"rig",
       {"left: {fx: 500, fy: 501, cx: 320, cy: 240, lens: plumb_bob, coefficients: [-0.2, 0.1, 0, "
        "0]}\n"
        "right: {fx: 500, fy: 501, cx: 320, cy: 240}\n"
        "right_from_left: [1, 0, 0, -0.1, 0, 1, 0, 0, 0, 0, 1, 0]\n",
        "{\"fx\": 700, \"fy\": 701, \"cx\": 320, \"cy\": 240, \"baseline_m\": 0.12}",
        "%YAML:1.0\n---\nK1: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nD1: [0, 0, 0, 0]\n"
        "K2: !!opencv-matrix\n   rows: 3\n   cols: 3\n   data: [500, 0, 320, 0, 500, 240, 0, 0, "
        "1]\n"
        "D2: [0, 0, 0, 0]\nR: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nT: [-0.1, 0, 0]\n",
        "cam0:\n  camera_model: pinhole\n  distortion_model: radtan\n"
        "  distortion_coeffs: [-0.28, 0.07, 0, 0]\n  intrinsics: [458, 457, 367, 248]\n"
        "cam1:\n  T_cn_cnm1:\n  - [1, 0, 0, -0.11]\n  - [0, 1, 0, 0]\n  - [0, 0, 1, 0]\n"
        "  - [0, 0, 0, 1]\n  intrinsics: [457, 456, 380, 255]\n  resolution: [752, 480]\n"},
       [](const fs::path& file) { ReadStereoRig(file); }},
      {"euroc_poses",
       {"#timestamp, x, y, z, qw, qx, qy, qz\n1403636580838555648,4.6,-1.7,0.8,1,0,0,0,9\n"
        "1403636580843555328,4.6,-1.7,0.8,0.6,0,0.8,0,9\n"},
       [](const fs::path& file) { ReadTrajectory(file); }},
      {"objects.csv",
       {StrCat(
           CsvHeader<SceneBody>(), "\n",
           "0,1,ball,Ball,1,2,3,0,0,0.6,0.8,0.5,0,0,0,0,1.25,0.7,0.7,0.7,12,24,0.5,0.25,1,2,4,4,"
           "1,2,5,6\n1,1,ball,Ball,1,2,3,0,0,0,1,0,0,0,0,0,0,0.7,0.7,0.7,0,0,0,1,,,,,,,,\n")},
       [](const fs::path& file) { ReadSceneBodies(file, 2); }},
      {"manifest.json",
       {SceneManifest()},
       [](const fs::path& file) { synth::ReadManifest(file.parent_path()); }},
      {"image.jpg",
       {std::string("\xff\xd8\xff\xe0\0\4\0\0\xff\xc0\0\x0b\x8\0\x10\0\x20\1\1\x11\0\xff\xd9", 23)},
       [](const fs::path& file) {
         (void)FindJpegDamage(ReadFileBytes(file));
         ReadImageSize(file);
       }},
      {"cached_frame",
       {CachedFrame(false), CachedFrame(true)},
       [](const fs::path& file) { DecodeFrame(ReadFileBytes(file)); }},
      {"header.png",
       {std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x8\0\0\0\0\x3a\x7e\x9b\x55",
                    33)},
       [](const fs::path& file) {
         (void)FindPngDamage(ReadFileBytes(file));
         (void)ReadImageSize(file);
       }},
      {"grey.png",
       {Png(CV_8UC1)},
       [](const fs::path& file) { (void)DecodeGreyPng(ReadFileBytes(file)); }},
      {"any.png",
       {Png(CV_8UC3), Png(CV_16UC1)},
       [](const fs::path& file) { (void)ReadImageFile(file, cv::IMREAD_UNCHANGED); }},
      {"depth.tiff",
       {EncodeImage(".tiff", RandomImage(CV_32FC1)), synth::EncodeDepthTiff(RandomImage(CV_32FC1))},
       [](const fs::path& file) { (void)ReadImageFile(file, cv::IMREAD_UNCHANGED); }}};
}

}  // namespace

std::string Finding(const Parser& parser, const fs::path& file) {
  constexpr double kLongest_s = 5.0;
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  try {
    parser.read(file);
  } catch (const Error& error) {
    if (std::string_view(error.what()).size() > 1000) return "a message without an end";
  } catch (const std::exception& error) {
    return StrCat("another exception: ", error.what());
  }
  const std::chrono::duration<double> took = Clock::now() - start;
  return took.count() > kLongest_s ? StrCat(took.count(), " s") : "";
}

std::vector<Parser> AllParsers() {
  std::vector<Parser> all;
  for (std::vector<Parser> part : {SuiteParsers(), ResultParsers(), SequenceParsers()}) {
    for (Parser& parser : part) all.push_back(std::move(parser));
  }
  return all;
}

}  // namespace cvo::test
