// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "core/record/run_summary.h"

#include <algorithm>

#include "core/base/lists.h"
#include "core/files/sha256.h"
#include "core/files/text_file.h"
#include "core/record/metric_catalogue.h"

namespace cvo::reports {
namespace {

struct Count {
  const char* field;
  std::int64_t value;
};

void CheckCounts(const std::vector<Count>& counts, const std::string& where) {
  for (const Count& count : counts) {
    if (count.value >= 0) continue;
    ThrowError(StrCat(where, ", field ", count.field), StrCat(count.value), "an integer from 0");
  }
}

void CheckErrors(const FrameErrors& errors, const std::string& where) {
  if (errors.frames.size() != errors.position_m.size() ||
      !std::is_sorted(errors.frames.begin(), errors.frames.end())) {
    ThrowError(where,
               StrCat(errors.frames.size(), " frames and ", errors.position_m.size(), " errors"),
               "one error per frame, frames ascending");
  }
}

void CheckBodies(const std::vector<BodyRow>& bodies, const std::string& where) {
  for (const BodyRow& body : bodies) {
    CheckCounts({{"visible_frames", body.visible_frames},
                 {"estimated_frames", body.estimated_frames},
                 {"id_switches", body.id_switches},
                 {"fragments", body.fragments},
                 {"joins", body.joins},
                 {"wrong_joins", body.wrong_joins}},
                where);
    if (body.estimated_frames > body.visible_frames) {
      ThrowError(where + ", field estimated_frames", StrCat(body.estimated_frames),
                 StrCat("at most ", body.visible_frames, ", as many as visible_frames"));
    }
    CheckErrors(body.errors, where + ", errors");
    CheckErrors(body.predicted, where + ", predicted");
  }
}

// Of a system, the options are the identity of its program, or the hashes of its files.
std::string JobOf(const RunSummary& run) {
  Json options = run.options;
  if (run.system) {
    const Json objects = run.system->value("objects", Json());
    options = {{"camera", run.system->value("camera", "")},
               {"objects", objects.is_null() ? Json("") : objects}};
    if (run.system->contains("program")) options = run.system->at("program");
  }
  const std::string detections = run.system ? "" : run.sequence.detections_hash;
  return JobIdentity({IdentityOf(run.build), run.variant, options, run.sequence.content, detections,
                      run.given, run.seed});
}

// Finds the slip of a hand, not a forger. Older files state no checksum.
void CheckUnedited(const RunSummary& run) {
  if (run.checksum.empty()) return;
  if (run.checksum == ChecksumOf(run) && run.job == JobOf(run)) return;
  ThrowError(run.file.string(), "values, options or hashes that do not fit its checksum and job",
             "a result as it was written: run its job again");
}

}  // namespace

std::string ChecksumOf(RunSummary run) {
  run.checksum.clear();
  run.calibration.reset();
  return Sha256Hex(FileText(run));
}

std::string IdentityOf(const BuildInfo& build) {
  JsonWriter fields;
  BuildInfo::VisitIdentity(build, fields);
  return Sha256Hex(DumpJson(fields.Take()));
}

std::string JobIdentity(const Job& job) {
  return Sha256Hex(DumpJson({{"build", job.build},
                             {"variant", job.variant},
                             {"options", job.options},
                             {"content", job.content},
                             {"detections", job.detections},
                             {"given", job.given},
                             {"seed", job.seed}}));
}

void CheckPossible(const std::string& name, double value, const std::string& where) {
  constexpr double kLargest = 1e12;
  const MetricEntry* entry = FindEntry(name);
  const bool fraction = entry != nullptr && entry->kind == MetricKind::kFraction;
  const double least = entry == nullptr ? -kLargest : fraction ? -1.0 : 0.0;  // ARI can be below 0
  const double most = fraction ? 1.0 : kLargest;
  if (value >= least && value <= most) return;
  ThrowError(StrCat(where, ", ", name), StrCat(value),
             StrCat("a value in [", least, ", ", most, "]"));
}

RunSummary ReadRun(const std::filesystem::path& result_file,
                   const std::vector<std::string>& metrics) {
  // Skips the poses, which make up most of a result and are read elsewhere.
  auto run = ReadRecord<RunSummary>(result_file, {"clusters", "frames", "trajectories"});
  run.file = result_file;
  CheckUnedited(run);
  CheckCounts({{"first_frame", run.sequence.first_frame},
               {"frames", run.sequence.frames},
               {"total_frames", run.sequence.total_frames}},
              result_file.string() + ", sequence");
  for (const MetricValue& metric : run.metrics) {
    CheckCounts({{"n", metric.n}}, StrCat(result_file.string(), ", ", metric.name));
    CheckPossible(metric.name, metric.value, result_file.string());
  }
  const std::string gap = MetricName({MetricId::kCameraTruthGap});  // what differences are held to
  std::erase_if(run.metrics, [&](const MetricValue& metric) {
    return metric.name != gap &&
           std::find(metrics.begin(), metrics.end(), metric.name) == metrics.end();
  });
  if (run.bodies) {
    CheckBodies(run.bodies->refined, result_file.string() + ", bodies, refined");
    CheckBodies(run.bodies->causal, result_file.string() + ", bodies, causal");
  }
  return run;
}

const MetricValue* FindMetric(const RunSummary& run, const std::string& name) {
  return FindBy(run.metrics, &MetricValue::name, name);
}

}  // namespace cvo::reports
