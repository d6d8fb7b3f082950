// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/faults/parsers.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/files/csv_file.h"
#include "core/files/json/options_json.h"
#include "core/files/text_file.h"
#include "core/interface/options.h"
#include "experiments/calibration/kitti_calibration.h"
#include "experiments/datasets/formats/grey_png.h"
#include "experiments/datasets/formats/object_boxes.h"
#include "experiments/datasets/formats/oxts.h"
#include "experiments/datasets/formats/png.h"
#include "experiments/datasets/formats/scene_truth.h"
#include "experiments/datasets/formats/timestamps.h"
#include "experiments/metrics/trajectory.h"
#include "experiments/suite/collection.h"
#include "experiments/suite/parse_suite.h"
#include "experiments/suite/plan/plan.h"
#include "reports/gate/baseline.h"
#include "reports/results/metric_catalogue.h"
#include "reports/results/run_summary.h"
#include "reports/results/timing.h"
#include "reports/results/truth.h"
#include "reports/tables/table_json.h"
#include "synth/family/family.h"
#include "synth/scene/description.h"

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

std::string GreyPng() {
  cv::Mat image(6, 9, CV_8UC1);
  cv::randu(image, 0, 256);
  std::vector<unsigned char> bytes;
  cv::imencode(".png", image, bytes);
  return {bytes.begin(), bytes.end()};
}

std::vector<Parser> SuiteParsers() {
  return {
      {"suite",
       {Source("experiments/configs/ci.json"), Source("experiments/configs/sweep_alpha.json"),
        Source("experiments/configs/kitti_raw.json")},
       [](const fs::path& file) { ReadCheckedSuite(ReadJson(file), file, file.parent_path()); }},
      {"collection",
       {Source("experiments/configs/paper.json")},
       [](const fs::path& file) { FindCollection(file); }},
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
      {"table",
       {Golden("table")},
       [](const fs::path& file) { ReadTable(ReadFileBytes(file), file); }},
      {"baseline", {Golden("baseline")}, [](const fs::path& file) { ReadBaseline(file); }}};
}

std::vector<Parser> SequenceParsers() {
  return {{"calibration",
           {"P0: 200 0 128 0 0 200 64 0 0 0 1 0\nP1: 200 0 128 -100 0 200 64 0 0 0 1 0\n"},
           [](const fs::path& file) {
             const CalibrationFile calibration(file);
             (void)CameraRig(calibration, "P").Stereo(0, 1, 256, 128);
           }},
          {"times", {"0\n0.1\n2e-1\n"}, [](const fs::path& file) { ReadSecondsTimes(file); }},
          {"dates",
           {"2011-09-26 13:02:25.964389445\n2011-09-26 13:02:26.064389445\n"},
           [](const fs::path& file) { ReadDateTimes(file); }},
          {"poses",
           {Repeated("1 0 0 1 0 1 0 2 0 0 1 3\n", 2)},
           [](const fs::path& file) { ReadKittiPoses(file); }},
          {"trajectory",
           {"# comment\n1.5 1 2 3 0 0 0 1\n2.5 1 2 3 0 0 0.6 0.8\n"},
           [](const fs::path& file) { ReadTumTrajectory(file); }},
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
          {"table of bodies",
           {"frame,id,x\n0,1,2.5\n1,1,2.75\n"},
           [](const fs::path& file) {
             const CsvFile csv(file, "frame,id,x");
             for (std::size_t row = 0; row < csv.rows(); ++row) {
               (void)csv.Integer(row, 0);
               (void)csv.Name(row, 1);
               (void)csv.Number(row, 2);
             }
           }},
          {"png",
           {std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x8\0\0\0\0\x3a\x7e\x9b\x55",
                        33)},
           [](const fs::path& file) {
             (void)FindPngDamage(ReadFileBytes(file));
             ReadPngHeader(file);
           }},
          {"pixels of a grey png", {GreyPng()}, [](const fs::path& file) {
             (void)DecodeGreyPng(ReadFileBytes(file));
           }}};
}

}  // namespace

std::vector<Parser> AllParsers() {
  std::vector<Parser> all;
  for (std::vector<Parser> part : {SuiteParsers(), ResultParsers(), SequenceParsers()}) {
    for (Parser& parser : part) all.push_back(std::move(parser));
  }
  return all;
}

}  // namespace cvo::test
