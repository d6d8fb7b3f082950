// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/cli/run/eval_ap.h"

#include <algorithm>
#include <iostream>

#include "core/base/error.h"
#include "core/files/number.h"
#include "experiments/cli/command.h"
#include "experiments/cli/run/text_table.h"
#include "experiments/metrics/kitti_ap/ap_files.h"

namespace cvo {
namespace {

// What `eval --ap --json` prints.
struct ApReport {
  struct Space {
    ApProtocol contract;
    std::vector<AveragePrecision> levels;

    template <typename Self, typename Archive>
    static void VisitFields(Self& self, Archive& archive) {
      archive.Field("contract", self.contract);
      archive.Field("levels", self.levels);
    }
  };
  std::int64_t frames = 0;
  std::int64_t detections = 0;
  std::vector<Space> average_precision;

  template <typename Self, typename Archive>
  static void VisitFields(Self& self, Archive& archive) {
    archive.Field("frames", self.frames);
    archive.Field("detections", self.detections);
    archive.Field("average_precision", self.average_precision);
  }
};

// Boxes without any 3D box are of a detector in the image.
std::vector<BoxSpace> SpacesOf(const std::vector<ApFrame>& frames) {
  const bool has_3d = std::any_of(frames.begin(), frames.end(), [](const ApFrame& frame) {
    return std::any_of(frame.detections.begin(), frame.detections.end(),
                       [](const ObjectBox& box) { return box.box3d.has_value(); });
  });
  if (!has_3d) return {BoxSpace::kImage};
  return {BoxSpace::kImage, BoxSpace::kBirdsEye, BoxSpace::kVolume};
}

ApReport Evaluate(const EvalAp& eval, const std::vector<ApFrame>& frames) {
  ApReport report;
  report.frames = static_cast<std::int64_t>(frames.size());
  for (const ApFrame& frame : frames) {
    report.detections += static_cast<std::int64_t>(frame.detections.size());
  }
  for (const BoxSpace space : SpacesOf(frames)) {
    ApProtocol protocol;
    protocol.category = eval.category;
    protocol.space = space;
    protocol.least_overlap = eval.least_overlap.value_or(eval.category == "Car" ? 0.7 : 0.5);
    protocol.truncation = *EnumOf<TruncationRule>(eval.truncation);
    protocol.dont_care = *EnumOf<DontCareRule>(eval.dont_care);
    const auto levels = EvaluateAp(frames, protocol);
    report.average_precision.push_back({protocol, {levels.begin(), levels.end()}});
  }
  return report;
}

void Print(const ApReport& report, std::ostream& out) {
  const ApProtocol& contract = report.average_precision.front().contract;
  out << contract.category << ", overlap over " << contract.least_overlap << ", " << report.frames
      << " frames, " << report.detections << " detections of all classes; truncation "
      << NameOf(contract.truncation) << ", DontCare regions: "
      << (contract.dont_care == DontCareRule::kAll ? "all boxes" : "2D alone") << "\n\n";
  TextTable table({"AP, percent", "points", "easy", "moderate", "hard"});
  for (const ApReport::Space& space : report.average_precision) {
    for (const bool at_40 : {false, true}) {
      std::vector<std::string> row = {NameOf(space.contract.space), at_40 ? "40" : "11"};
      for (const AveragePrecision& level : space.levels) {
        row.push_back(FormatFixed(100.0 * (at_40 ? level.ap40 : level.ap11), 2));
      }
      table.Add(std::move(row));
    }
  }
  std::vector<std::string> counts = {"labels", ""};
  for (const AveragePrecision& level : report.average_precision.front().levels) {
    counts.push_back(std::to_string(level.valid_labels));
  }
  table.Add(std::move(counts));
  table.Print(out);
}

}  // namespace

std::vector<std::string> EvalAp::FlagNames() {
  return {"--class", "--iou", "--truncation", "--dontcare"};
}

void EvalAp::AddTo(CLI::App& app) {
  app.add_flag("--ap", wanted,
               "score boxes by KITTI's average precision: --labels and --estimate are files of "
               "KITTI tracking, or folders of KITTI object files");
  app.add_option("--class", category, "class that is scored; Van and Person_sitting are neighbours")
      ->check(CLI::IsMember({"Car", "Pedestrian", "Cyclist"}))
      ->capture_default_str();
  app.add_option("--iou", least_overlap,
                 "intersection over union to exceed; default: the benchmark's, 0.7 for Car, else "
                 "0.5")
      ->type_name("NUMBER")
      ->check(CLI::Range(0.0, 1.0).description(""))
      ->check(FiniteProblem);
  app.add_option("--truncation", truncation,
                 "applied: labels truncated beyond a level's limit are ignored there (each of 1 or "
                 "2 in a tracking file is), or ignored")
      ->check(CLI::IsMember({"applied", "ignored"}))
      ->capture_default_str();
  app.add_option("--dontcare", dont_care,
                 "whose false positives DontCare regions forgive: 2d, as in KITTI's benchmark, or "
                 "all, by the box in the image")
      ->check(CLI::IsMember({"2d", "all"}))
      ->capture_default_str();
  for (const std::string& flag : FlagNames()) app.get_option(flag)->group("With --ap");
}

int EvaluateApOfFiles(const EvalAp& eval, const std::string& labels, const std::string& estimate,
                      const std::string& frames, bool json) {
  const FrameRange range = frames.empty() ? FrameRange() : ParseFrameRange(frames);
  const ApReport report = Evaluate(eval, ReadApFrames(labels, estimate, range));
  if (json) {
    Json file = {{"schema_version", 1}, {"kind", "average precision"}};
    file.update(ToJson(report));
    std::cout << DumpJson(file);
  } else {
    Print(report, std::cout);
  }
  return 0;
}

}  // namespace cvo
