// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "reports/runs/run_comparison.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/lists.h"
#include "core/files/json/json.h"
#include "core/files/text/closest_names.h"
#include "core/geometry/rigid_transform.h"
#include "core/record/metric_catalogue.h"
#include "reports/runs/run_detail.h"
#include "reports/statistics/estimate.h"
#include "reports/tables/cells.h"

namespace cvo::reports {
namespace {

namespace fs = std::filesystem;

// Estimated and true positions of the camera, in frames that have both.
struct CameraPositions {
  std::vector<int> frames;  // ascending
  std::vector<Position> estimated_m;
  std::vector<Position> truth_m;
};

// A run to be compared.
struct RunToCompare {
  std::string name;
  RunSummary summary;
  CameraPositions camera;  // may be empty
};

// Errors in the frames that both runs have.
struct CommonErrors {
  std::vector<double> errors_m;
  std::vector<double> reference_m;
};

CommonErrors CommonBodyErrors(const FrameErrors& errors, int shift, const FrameErrors& reference,
                              int reference_shift) {
  CommonErrors common;
  ForCommonFrames(errors.frames, shift, reference.frames, reference_shift,
                  [&](std::size_t i, std::size_t k) {
                    common.errors_m.push_back(errors.position_m[i]);
                    common.reference_m.push_back(reference.position_m[k]);
                  });
  return common;
}

// Distances (m) between estimated and true positions, after applying to the estimate the rotation
// and translation that minimise the sum of their squares, as for camera ATE.
std::vector<double> AlignedErrors(const std::vector<Position>& estimate,
                                  const std::vector<Position>& truth) {
  if (estimate.empty()) return {};
  const auto count = static_cast<Eigen::Index>(estimate.size());
  const Eigen::Map<const Eigen::Matrix3Xd> from(estimate.front().data(), 3, count);
  const Eigen::Map<const Eigen::Matrix3Xd> to(truth.front().data(), 3, count);
  const RigidTransform to_from_from = AlignPoints(from, to);
  std::vector<double> errors_m;
  for (Eigen::Index i = 0; i < count; ++i) {
    errors_m.push_back((to_from_from * from.col(i) - to.col(i)).norm());
  }
  return errors_m;
}

// Aligns each run to the truth over the same frames: otherwise what one of them did in other frames
// would affect its errors in these.
CommonErrors CommonCameraErrors(const CameraPositions& run, const CameraPositions& reference) {
  CameraPositions here;
  CameraPositions there;
  const auto add = [](const CameraPositions& from, std::size_t i, CameraPositions& to) {
    to.estimated_m.push_back(from.estimated_m[i]);
    to.truth_m.push_back(from.truth_m[i]);
  };
  ForCommonFrames(run.frames, 0, reference.frames, 0, [&](std::size_t i, std::size_t k) {
    add(run, i, here);
    add(reference, k, there);
  });
  return {AlignedErrors(here.estimated_m, here.truth_m),
          AlignedErrors(there.estimated_m, there.truth_m)};
}

// Blocks take the place of bodies in the samples, because resampling happens within a single scene.
std::vector<Sample> BlocksOf(const CommonErrors& common) {
  const std::size_t length = BlockLength(common.errors_m.size());
  std::vector<Sample> blocks;
  for (std::size_t i = 0; i < common.errors_m.size(); ++i) {
    if (i % length == 0) {
      const std::string number = StrCat(blocks.size());
      blocks.push_back({"",
                        "",
                        std::string(8 - std::min<std::size_t>(number.size(), 8), '0') + number,
                        "",
                        {0.0, 0.0},
                        {0.0, 0.0}});
    }
    Sample& block = blocks.back();
    block.value.sum += common.errors_m[i];
    block.reference.sum += common.reference_m[i];
    block.value.weight += 1.0;
    block.reference.weight += 1.0;
  }
  return blocks;
}

void AddPair(const std::string& what, const std::string& metric, const CommonErrors& common,
             const RunToCompare& run, const RunToCompare& reference,
             std::vector<PairedComparison>& comparisons) {
  const std::vector<Sample> blocks = BlocksOf(common);
  const auto estimate = EstimateDifference(blocks, Within::kMean);
  if (!estimate) return;
  const std::string meaning = StrCat(
      "95 %, bootstrap over ", blocks.size(), " blocks of ", BlockLength(common.errors_m.size()),
      " consecutive frames of this sequence: says nothing about other scenes");
  comparisons.push_back(
      {run.name, what, metric, "m", common.errors_m.size(),
       DifferenceOf(*estimate, reference.name, meaning, "frames that both estimate"), ""});
}

// Only metrics of tables are paired, of bodies that move and of bodies that stay put. Any more of
// them would reduce each other's significance.
bool IsPaired(const BodyMetric& metric) {
  const std::vector<std::string> usual = ObjectMetrics();
  return !metric.form.causal && !metric.predicted() &&
         std::find(usual.begin(), usual.end(), MetricName({metric.form.id})) != usual.end();
}

CameraPositions CameraPositionsOf(const RunDetail& detail) {
  CameraPositions camera;
  const auto position = [](const Pose& pose) { return Position{pose[0], pose[1], pose[2]}; };
  for (const CameraFrame& frame : detail.camera) {
    if (!frame.truth || frame.status == "skipped") continue;
    camera.frames.push_back(frame.frame);
    camera.estimated_m.push_back(position(frame.world_from_camera));
    camera.truth_m.push_back(position(*frame.truth));
  }
  return camera;
}

std::vector<PairedComparison> PairByFrame(const RunToCompare& run, const RunToCompare& reference) {
  std::vector<PairedComparison> comparisons;
  AddPair("camera", "camera_ate_mean", CommonCameraErrors(run.camera, reference.camera), run,
          reference, comparisons);
  if (!run.summary.bodies || !reference.summary.bodies) return comparisons;
  for (const BodyRow& body : run.summary.bodies->refined) {
    const BodyRow* other = FindBy(reference.summary.bodies->refined, &BodyRow::id, body.id);
    if (other == nullptr) continue;
    AddPair(body.name, body.mover ? "object_ate" : "object_standing_ate",
            CommonBodyErrors(body.errors, run.summary.sequence.first_frame, other->errors,
                             reference.summary.sequence.first_frame),
            run, reference, comparisons);
  }
  return comparisons;
}

std::vector<PairedComparison> PairByBody(const RunToCompare& run, const RunToCompare& reference,
                                         const std::vector<ComparedMetric>& metrics) {
  std::vector<PairedComparison> comparisons;
  for (const ComparedMetric& metric : metrics) {
    const std::optional<BodyMetric> body_metric = FindBodyMetric(metric.name);
    if (!body_metric || !IsPaired(*body_metric) || !metric.differing.empty()) continue;
    std::vector<Sample> samples;
    for (const BodyRow& body : BodiesOf(*body_metric, run.summary)) {
      const BodyRow* other =
          FindBy(BodiesOf(*body_metric, reference.summary), &BodyRow::id, body.id);
      const auto pair = other == nullptr ? std::nullopt : PairOf(*body_metric, body, *other);
      if (!pair) continue;
      samples.push_back({"", "", StrCat("body ", body.id), "", pair->first, pair->second});
    }
    const auto estimate = EstimateDifference(samples, body_metric->within());
    if (!estimate) continue;
    const std::string meaning = StrCat("95 %, bootstrap over ", samples.size(),
                                       " bodies of one scene: says nothing about other scenes");
    comparisons.push_back(
        {run.name, metric.name, metric.name, metric.unit, 0,
         DifferenceOf(*estimate, reference.name, meaning, PairingText(*body_metric)), ""});
  }
  return comparisons;
}

RunToCompare ReadOne(const fs::path& folder, std::vector<std::string>& notes) {
  RunToCompare run;
  run.summary = ReadRun(folder / "result.json", AllMetricNames());
  run.name = run.summary.variant;
  run.camera = CameraPositionsOf(ReadRunDetail(folder));
  if (run.camera.frames.empty()) {
    notes.push_back(StrCat(folder.string(), ": no truth of the camera frame by frame"));
  }
  return run;
}

void CheckSameSequence(const std::vector<RunToCompare>& runs) {
  const RunSummary& first = runs.front().summary;
  for (const RunToCompare& run : runs) {
    const RunSequence& sequence = run.summary.sequence;
    if (sequence.name == first.sequence.name) continue;
    ThrowError(run.summary.file.string(), "a run of " + sequence.name,
               StrCat("one of ", first.sequence.name, ", as ", first.file.string()));
  }
}

// Returns, for each run, the options that differ between the runs, with the run's values.
std::vector<std::map<std::string, std::string>> DifferingOptions(
    const std::vector<RunToCompare>& runs) {
  std::vector<std::map<std::string, std::string>> all;
  for (const RunToCompare& run : runs) all.push_back(FlatJson(run.summary.options));
  std::map<std::string, std::map<std::string, std::size_t>> uses;
  for (const auto& options : all) {
    for (const auto& [path, value] : options) ++uses[path][value];
  }
  for (auto& options : all) {
    std::erase_if(options, [&](const auto& option) {
      return uses[option.first][option.second] == runs.size();
    });
  }
  return all;
}

std::vector<ComparedRun> DescribeRuns(const std::vector<RunToCompare>& runs,
                                      const std::vector<fs::path>& folders) {
  const auto options = DifferingOptions(runs);
  std::vector<ComparedRun> described;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunSummary& run = runs[i].summary;
    described.push_back({runs[i].name, folders[i].string(), run.variant, run.seed, run.status,
                         run.sequence.first_frame, run.sequence.frames, run.build.identity,
                         options[i]});
  }
  return described;
}

// Returns every metric that some run has, in the order of the catalogue.
std::vector<ComparedMetric> SideBySide(const std::vector<RunToCompare>& runs) {
  std::vector<ComparedMetric> metrics;
  for (const std::string& name : AllMetricNames()) {
    ComparedMetric metric{name, "", {}, ""};
    const MetricValue* first = nullptr;
    for (const RunToCompare& run : runs) {
      const MetricValue* value = FindMetric(run.summary, name);
      metric.values.push_back(value == nullptr ? std::nullopt : std::optional(value->value));
      if (value == nullptr) continue;
      if (first == nullptr) first = value;
      metric.unit = NameOf(value->unit);
      if (metric.differing.empty()) {
        metric.differing = FirstDifference(first->contract, value->contract);
      }
    }
    if (first != nullptr) metrics.push_back(std::move(metric));
  }
  return metrics;
}

void JudgeAll(RunComparison& comparison) {
  std::vector<Difference*> differences;
  for (auto* list : {&comparison.by_frame, &comparison.by_body}) {
    for (PairedComparison& paired : *list) differences.push_back(&paired.difference);
  }
  CorrectForMany(differences);
  for (auto* list : {&comparison.by_frame, &comparison.by_body}) {
    for (PairedComparison& paired : *list) {
      paired.verdict =
          VerdictText(paired.difference, paired.metric, paired.frames > 0 ? "block" : "pair");
    }
  }
}

}  // namespace

std::size_t BlockLength(std::size_t frames) {
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(frames)))));
}

RunComparison CompareRuns(const std::vector<fs::path>& folders) {
  Require(folders.size() >= 2, "CompareRuns: at least two runs");
  RunComparison comparison;
  std::vector<RunToCompare> runs;
  for (const fs::path& folder : folders) runs.push_back(ReadOne(folder, comparison.notes));
  CheckSameSequence(runs);
  std::vector<std::string> variants;
  for (const RunToCompare& run : runs) variants.push_back(run.summary.variant);
  const auto names = UniqueNames(variants, {folders.begin(), folders.end()});
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].name = names[i];
  comparison.sequence = runs.front().summary.sequence.name;
  comparison.runs = DescribeRuns(runs, folders);
  comparison.metrics = SideBySide(runs);
  for (std::size_t i = 1; i < runs.size(); ++i) {
    for (PairedComparison& paired : PairByFrame(runs[i], runs.front())) {
      comparison.by_frame.push_back(std::move(paired));
    }
    for (PairedComparison& paired : PairByBody(runs[i], runs.front(), comparison.metrics)) {
      comparison.by_body.push_back(std::move(paired));
    }
  }
  JudgeAll(comparison);
  return comparison;
}

}  // namespace cvo::reports
