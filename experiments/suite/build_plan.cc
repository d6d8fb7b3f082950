// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/build_plan.h"

#include <algorithm>
#include <future>
#include <map>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/files/json/options_json.h"
#include "core/files/sha256.h"
#include "experiments/runner/identity.h"
#include "experiments/runner/run_job.h"
#include "experiments/runner/system_run.h"
#include "experiments/suite/suite.h"
#include "experiments/suite/system_command.h"
#include "synth/family/family.h"
#include "synth/write/dataset.h"
#include "synth/write/render_cache.h"

namespace cvo {

std::string Describe(const PlanJob& job) {
  std::string text = StrCat(job.sequence, " ", job.system.empty() ? job.variant : job.system);
  text += StrCat(", seed ", job.seed);
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

// Whether the last components of `path` are those of `end`.
bool EndsWith(const fs::path& path, const fs::path& end) {
  auto a = path.end();
  auto b = end.end();
  while (b != end.begin()) {
    if (a == path.begin() || *--a != *--b) return false;
  }
  return true;
}

// Returns the first file of boxes or labels that does not exist below `data`, as written in the
// suite; empty if all exist.
std::string FindMissingFile(const SuiteSequence& sequence, const fs::path& data) {
  std::vector<std::string> files = {sequence.labels_file.string()};
  if (sequence.scene.empty() && !AreFromLabels(sequence.detections)) {
    files.push_back(sequence.detections);
  }
  for (const std::string& file : files) {
    std::error_code ignored;
    if (!file.empty() && !fs::is_regular_file(data / file, ignored)) return file;
  }
  return "";
}

// The user's data folder, searched on first need. Sequences are found by their path below it, or by
// the end of their path.
class DataFolder {
 public:
  explicit DataFolder(fs::path root) : root_(std::move(root)) {}

  const fs::path& root() const { return root_; }

  struct Found {
    fs::path folder;      // absolute; empty: missing
    std::string missing;  // why it is missing, for the user
  };
  Found Find(const std::string& folder) {
    if (root_.empty()) return {{}, "no data folder: use --data or set CLUSTERVO_DATA"};
    std::error_code ignored;
    if (!fs::is_directory(root_, ignored)) return {{}, "no data folder " + root_.string()};
    const fs::path direct = NormalFolder(root_ / folder);
    if (!DetectSequenceType(direct).empty()) {
      if (HasImages(direct)) return {fs::absolute(direct), ""};
      return {{}, StrCat("no images of both cameras of ", folder, " below ", root_.string())};
    }
    if (!all_) all_ = FindSequences(root_);
    Found found;
    for (const FoundSequence& sequence : *all_) {
      if (!EndsWith(sequence.folder, NormalFolder(fs::path("/") / folder).relative_path()))
        continue;
      if (!found.folder.empty()) {
        return {{},
                StrCat("both ", found.folder.string(), " and ", sequence.folder.string(),
                       " end in ", folder)};
      }
      found.folder = fs::absolute(sequence.folder);
    }
    if (found.folder.empty()) found.missing = StrCat("no ", folder, " below ", root_.string());
    return found;
  }

 private:
  fs::path root_;  // empty: none
  std::optional<std::vector<FoundSequence>> all_;
};

synth::RenderRequest RenderOf(const SuiteSequence& sequence, std::uint64_t seed) {
  synth::RenderRequest request;
  request.seed = seed;
  if (!sequence.frames.empty()) {
    const FrameRange range = ParseFrameRange(sequence.frames);
    request.frames.first = range.begin;
    if (range.end >= 0) request.frames.end = range.end;
  }
  return request;
}

// Finds scenes below <cache>/scenes by a key of what determines their content: the scene, the
// values assigned to it, the seed, the frames and the program that draws.
class SceneFolders {
 public:
  explicit SceneFolders(fs::path cache) : cache_(std::move(cache)) {}

  // Throws Error for an invalid scene, and if no renderer is available.
  Preparation Find(const SuiteSequence& sequence, const GridPoint& parameters, std::uint64_t seed) {
    const std::vector<std::string> assignments = SceneAssignments(sequence, parameters);
    const auto& [source, all_frames] = SourceFor(sequence, assignments);
    const synth::RenderRequest request = RenderOf(sequence, seed);
    const std::string key =
        StrCat(source.scene, "-", synth::DatasetKey(source, request).substr(0, 16));
    Preparation render;
    render.name = StrCat("render-", sequence.name, "-", key);
    render.sequence = sequence.name;
    render.output = synth::ScenesFolder(cache_) / key / source.scene;
    render.drawing = synth::DrawingKey(source, request);
    std::error_code ignored;
    const bool drawn = fs::exists(cache_ / render.drawing / synth::kManifestName, ignored);
    render.draws = !drawn;
    render.frames = request.frames.end.value_or(all_frames) - request.frames.first;
    render.arguments = {"synth",
                        "render",
                        sequence.scene,
                        "-o",
                        render.output.string(),
                        "--seed",
                        std::to_string(seed)};
    const auto add = [&](const char* flag, const std::string& value) {
      render.arguments.insert(render.arguments.end(), {flag, value});
    };
    if (!sequence.frames.empty()) add("--frames", sequence.frames);
    for (const std::string& assignment : assignments) add("--set", assignment);
    return render;
  }

 private:
  struct Source {
    synth::DatasetSource dataset;
    int frames = 0;
  };
  const Source& SourceFor(const SuiteSequence& sequence,
                          const std::vector<std::string>& assignments) {
    std::string key = sequence.scene;
    for (const std::string& assignment : assignments) key += "\n" + assignment;
    const auto found = sources_.find(key);
    if (found != sources_.end()) return found->second;
    const auto scene = synth::LoadScene(sequence.scene, assignments);
    Source source = {synth::SourceOf(scene, {}), scene.parts().frames};
    return sources_.emplace(key, std::move(source)).first->second;
  }

  fs::path cache_;
  std::map<std::string, Source> sources_;  // by scene and assignments
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
    scene.draws = true;
    return false;
  }

  // Of the scenes that share a drawing one draws it, unless the cache has it.
  void OrderPreparations() {
    std::set<std::string> drawing;
    for (Preparation& wanted : wanted_) {
      wanted.draws = wanted.draws && drawing.insert(wanted.drawing).second;
    }
    std::stable_partition(wanted_.begin(), wanted_.end(),
                          [](const Preparation& wanted) { return wanted.draws; });
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

  // The options of a variant at a grid point.
  const Json& ResolvedOf(const PlanJob& job) {
    std::string key = job.variant;
    for (const auto& [path, value] : job.parameters.items()) {
      if (IsOptionPath(path)) key += StrCat("\n", path, "=", value.dump());
    }
    const auto found = resolved_.find(key);
    if (found != resolved_.end()) return found->second;
    Options options = OptionsOf(suite_, job.variant, job.parameters);
    return resolved_.emplace(key, OptionsToJson(OptionLeaves(options))).first->second;
  }

  void IdentifyFiles(const Input& input, PlanJob& job) {
    const SuiteSystem& system = *SystemOf(suite_, job);
    SystemRequest request{input.sequence, input.content, {system.name}, job.seed};
    try {
      if (system.command.empty()) {
        request.files = SystemFilesOf(suite_, job, data_.root(), Absolute(request_.cache));
      } else {
        // Asked once for its version, also one that fails or hangs.
        std::shared_future<Json>& program = programs_[system.name];
        if (!program.valid()) {
          program = std::async(std::launch::deferred, IdentifyProgram, system).share();
        }
        request.program = WithInput(program.get(), system, input.sequence);
        job.input = InputsKey(input.sequence, input.content, ClassesOf(SequenceOf(job)));
      }
      job.job = IdentifySystem(request);
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
    const Json& options = ResolvedOf(job);
    job.input = Sha256Hex(input.content + options["orb"].dump() + options["stereo"].dump());
    job.job = reports::JobIdentity(
        {ThisBuild().identity, job.variant, options, input.content, input.detections,
         Given(input.sequence, ClassesOf(SequenceOf(job)), OracleOf(job.oracle)), job.seed});
  }

  const Suite& suite_;
  const PlanRequest& request_;
  DataFolder data_;
  SceneFolders scenes_;
  std::map<std::string, Input> inputs_;
  std::map<std::string, Json> resolved_;
  std::map<std::string, std::shared_future<Json>> programs_;  // of systems, identified
  std::vector<Preparation> wanted_;
  std::set<fs::path> wanted_outputs_;
};

}  // namespace

BuiltPlan BuildPlan(const Suite& suite, const PlanRequest& request) {
  return Planner(suite, request).Build();
}

Preparation FindScene(const fs::path& cache, const SuiteSequence& sequence,
                      const GridPoint& parameters, std::uint64_t seed) {
  return SceneFolders(cache).Find(sequence, parameters, seed);
}

}  // namespace cvo
