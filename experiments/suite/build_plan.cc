// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/build_plan.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/files/json/options_json.h"
#include "core/files/sha256.h"
#include "experiments/runner/front_end_cache.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_job.h"
#include "experiments/runner/system_run.h"
#include "experiments/suite/suite.h"
#include "synth/write/render_cache.h"

namespace cvo {

std::string Describe(const PlanJob& job) {
  std::string text = StrCat(job.sequence, " ", job.system.empty() ? job.variant : job.system);
  if (job.system.empty()) text += StrCat(", seed ", job.seed);
  for (const auto& [path, value] : job.parameters.items()) {
    text += StrCat(", ", path, "=", value.dump());
  }
  for (std::size_t i = 0; i < job.oracle.size(); ++i) {
    text += StrCat(i == 0 ? ", oracle " : "+", job.oracle[i]);
  }
  return text;
}

std::string PlanText(const Plan& plan) {
  reports::PlanFile file;
  file.suite = {plan.suite.name, plan.suite.about, SplitOf(plan.suite)};
  file.build = plan.build;
  file.data = plan.data;
  file.table = plan.suite.table;
  file.definition = plan.suite.definition;
  file.jobs = plan.jobs;
  return FileText(file);
}

Plan ParsePlan(const Json& json, const std::string& where) {
  auto read = ReadRecord<reports::PlanFile>(json, where);
  Plan plan;
  plan.suite = ReadCheckedSuite(read.definition, where + ", definition");
  plan.build = read.build;
  plan.data = read.data;
  plan.jobs = std::move(read.jobs);
  for (const PlanJob& job : plan.jobs) {
    if (job.entry < plan.suite.sequences.size()) continue;
    ThrowError(where + ", jobs", "a job on a sequence that the suite does not have",
               StrCat("one of its ", plan.suite.sequences.size()));
  }
  return plan;
}

namespace {

namespace fs = std::filesystem;

// The input shared by jobs that differ only in variant, options or oracle.
struct Input {
  std::string folder;
  std::string missing;
  int frames = 0;
  Sequence sequence;
  std::string content;
  std::string detections;  // DetectionsHash
};

// What jobs of one variant at one grid point share.
struct VariantAtPoint {
  Options options;
  Json json;              // the same
  std::string front_end;  // front-end options, as text
};

fs::path Absolute(const fs::path& path) {
  return path.empty() ? path : fs::absolute(path).lexically_normal();
}

class Planner {
 public:
  Planner(const Suite& suite, const PlanRequest& request)
      : suite_(suite),
        request_(request),
        data_(Absolute(request.data)),
        scenes_(Absolute(request.cache)) {}

  BuiltPlan Build() {
    BuiltPlan built;
    built.plan.suite = suite_;
    built.plan.build = ThisBuild().identity;
    built.plan.data = data_.root().string();
    built.plan.jobs = ExpandSuite(suite_);
    for (std::size_t i = 0; i < built.plan.jobs.size(); ++i) {
      PlanInput(built.plan.jobs[i]);
      if (request_.progress) request_.progress(i + 1, built.plan.jobs.size());
    }
    OrderPreparations();
    built.preparations = std::move(wanted_);
    return built;
  }

 private:
  const SuiteSequence& SequenceOf(const PlanJob& job) const { return suite_.sequences[job.entry]; }

  void Want(Preparation preparation) {
    if (wanted_outputs_.insert(preparation.output).second)
      wanted_.push_back(std::move(preparation));
  }

  Sequence Opened(PlanJob job, const Input& input) const {
    job.folder = input.folder;
    return OpenSequence(RequestOf(suite_, job, data_.root()));
  }

  // A damaged scene is drawn again too, because it shares files with the cached drawing.
  bool IsRendered(Preparation& scene) {
    std::error_code ignored;
    if (!fs::exists(scene.output / synth::kManifestName, ignored)) return false;
    const auto damage = FindSceneDamage(scene.output);
    if (!damage) return true;
    request_.notice("a cached scene is damaged and will be rendered again:  " + *damage);
    scene.stage = Stage::kDrawing;
    return false;
  }

  // Of the scenes that share a drawing one draws it, unless the cache has it.
  void OrderPreparations() {
    std::set<std::string> drawing;
    for (Preparation& wanted : wanted_) {
      if (wanted.stage != Stage::kDrawing || drawing.insert(wanted.drawing).second) continue;
      wanted.stage = Stage::kNoise;
    }
    std::stable_sort(wanted_.begin(), wanted_.end(),
                     [](const auto& a, const auto& b) { return a.stage < b.stage; });
  }

  void Open(const PlanJob& job, Input& input) {
    input.sequence = Opened(job, input);
    input.frames = static_cast<int>(input.sequence.images.size());
    if (SequenceOf(job).scene.empty()) RequireAsRendered(input.sequence);
    input.content = ContentHash(input.sequence, RenderedHashes(input.sequence));
    input.detections = DetectionsHash(input.sequence);
  }

  Input FindInput(const PlanJob& job) {
    const SuiteSequence& sequence = SequenceOf(job);
    Input input;
    try {
      const std::string lacking = FindMissingFile(sequence, data_.root());
      if (!lacking.empty() && !data_.root().empty()) {
        input.missing = StrCat(kNoFile, lacking, " below ", data_.root().string());
      }
      if (sequence.scene.empty()) {
        const DataFolder::Found found = data_.Find(sequence.folder);
        if (!found.missing.empty()) input.missing = found.missing;
        if (input.missing.empty()) input.folder = found.folder.string();
      } else if (input.missing.empty()) {
        Preparation render = scenes_.Find(sequence, job.parameters, job.seed);
        if (IsRendered(render)) {
          input.folder = render.output.string();
        } else {
          input.missing = kNotRendered;
          input.frames = render.frames;
          Want(std::move(render));
        }
      }
      if (input.missing.empty()) Open(job, input);
    } catch (const Error& error) {
      input.missing = error.what();
    }
    return input;
  }

  Input& InputOf(const PlanJob& job) {
    const SuiteSequence& sequence = SequenceOf(job);
    std::string key =
        StrCat(sequence.name, "\n", sequence.detections, "\n",
               PerturbationToJson(PerturbationOf(sequence, job.parameters, job.seed)).dump(), "\n",
               sequence.layout.dump(), "\n");
    if (!sequence.scene.empty()) {
      key += std::to_string(job.seed);
      for (const std::string& assignment : SceneAssignments(sequence, job.parameters)) {
        key += "\n" + assignment;
      }
    }
    const auto found = inputs_.find(key);
    return found != inputs_.end() ? found->second
                                  : inputs_.emplace(key, FindInput(job)).first->second;
  }

  const VariantAtPoint& ResolvedOf(const PlanJob& job) {
    std::string key = job.variant;
    for (const auto& [path, value] : job.parameters.items()) {
      if (IsOptionPath(path)) key += StrCat("\n", path, "=", value.dump());
    }
    const auto found = resolved_.find(key);
    if (found != resolved_.end()) return found->second;
    VariantAtPoint resolved;
    resolved.options = OptionsOf(suite_, job.variant, job.parameters);
    const Json options = OptionsToJson(OptionLeaves(resolved.options));
    resolved.front_end = options["orb"].dump() + options["stereo"].dump();
    resolved.json = options;
    return resolved_.emplace(key, std::move(resolved)).first->second;
  }

  void IdentifyFiles(const Input& input, PlanJob& job) const {
    try {
      job.job = IdentifySystem(
          {.sequence = input.sequence,
           .content = input.content,
           .files = SystemFilesOf(suite_, job, data_.root(), Absolute(request_.cache)),
           .seed = job.seed});
    } catch (const Error& error) {
      job.missing = error.what();
    }
  }

  void PlanInput(PlanJob& job) {
    Input& input = InputOf(job);
    job.folder = input.folder;
    job.missing = input.missing;
    job.frames = input.frames;
    job.content = input.content;
    if (!job.missing.empty()) return;
    if (!job.system.empty()) {
      IdentifyFiles(input, job);
      return;
    }
    const VariantAtPoint& resolved = ResolvedOf(job);
    job.input = Sha256Hex(input.content + resolved.front_end);
    job.job = reports::JobIdentity(
        {ThisBuild().identity, job.variant, resolved.json, input.content, input.detections,
         Given(input.sequence, ClassesOf(SequenceOf(job)), OracleOf(job.oracle)), job.seed});
  }

  const Suite& suite_;
  const PlanRequest& request_;
  DataFolder data_;
  SceneFolders scenes_;
  std::map<std::string, Input> inputs_;
  std::map<std::string, VariantAtPoint> resolved_;
  std::vector<Preparation> wanted_;
  std::set<fs::path> wanted_outputs_;
};

}  // namespace

BuiltPlan BuildPlan(const Suite& suite, const PlanRequest& request) {
  return Planner(suite, request).Build();
}

}  // namespace cvo
