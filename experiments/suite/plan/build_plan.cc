// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/plan/build_plan.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/task_pool.h"
#include "core/files/json/options_json.h"
#include "experiments/cache/content_hash.h"
#include "experiments/cache/file_hashes.h"
#include "experiments/cache/front_end_cache.h"
#include "experiments/record/build_identity.h"
#include "experiments/record/job_identity.h"
#include "experiments/runner/run_job.h"
#include "experiments/runner/score_files.h"
#include "experiments/suite/cell_input.h"
#include "experiments/suite/plan/data_folder.h"
#include "experiments/suite/plan/detector_boxes.h"
#include "experiments/suite/plan/scenes.h"
#include "experiments/suite/suite_grid.h"
#include "synth/write/manifest.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// The input shared by cells that differ only in variant, options or oracle.
struct Input {
  std::string folder;
  std::string missing;
  int frames = 0;
  Sequence sequence;
  std::string content;
  std::string boxes;       // written by a detector
  std::string detections;  // DetectionsHash
  std::vector<ImageHashes> images;
  std::map<std::string, std::string> front_end_keys;  // by front-end options
};

// What cells of one variant at one grid point share.
struct Resolved {
  Options options;
  std::string identity_head;
  std::string front_end;  // front-end options, as text
};
constexpr std::size_t kNameDigits = 8;
constexpr std::size_t kMaxResolved = 10'000;  // 7 kB each

fs::path Absolute(const fs::path& path) {
  return path.empty() ? path : fs::absolute(path).lexically_normal();
}

class Planner {
 public:
  Planner(const Suite& suite, const PlanRequest& request)
      : suite_(suite),
        request_(request),
        data_(Absolute(request.data)),
        scenes_(Absolute(request.cache)),
        pool_(request.threads),
        hash_index_(Absolute(request.cache) / "hashes") {
    hooks_.notice = request.notice;
  }

  BuiltPlan Build();

 private:
  Input& InputOf(const Cell& cell);
  const Resolved& ResolvedOf(const Cell& cell);
  const std::string& FrontEndKeyOf(const Resolved& resolved, Input& input) const;
  Input FindInput(const Cell& cell);
  void Open(const Cell& cell, Input& input);
  std::vector<std::string> Hashes(const std::vector<fs::path>& files);
  bool IsRendered(RenderedScene& scene);
  PlannedJob PlanCell(const Cell& cell);
  void IdentifyFiles(const Input& input, PlannedJob& job) const;
  void AddRender(const RenderedScene& scene, const Cell& cell);
  void FindBoxes(const Cell& cell, Input& input);
  void OrderPreparations();

  const Suite& suite_;
  const PlanRequest& request_;
  DataFolder data_;
  SceneFolders scenes_;
  TaskPool pool_;
  fs::path hash_index_;
  FileHashHooks hooks_;
  BuildIdentity build_ = ThisBuild();
  std::map<std::string, Input> inputs_;
  std::map<std::string, Resolved> resolved_;
  std::vector<std::pair<std::string, Preparation>> wanted_;  // each with the key of its drawing
  std::set<fs::path> wanted_outputs_;
};

void Planner::AddRender(const RenderedScene& scene, const Cell& cell) {
  if (!wanted_outputs_.insert(scene.folder).second) return;
  const std::string name =
      StrCat("render-", cell.sequence.name, "-", scene.folder.parent_path().filename().string());
  wanted_.push_back({scene.drawing,
                     {name, cell.sequence.name, scene.folder, scene.arguments, scene.frames,
                      scene.drawn ? Stage::kNoise : Stage::kDrawing}});
}

// Locates the file of a detector's boxes; adds a preparation if it does not exist or is damaged.
void Planner::FindBoxes(const Cell& cell, Input& input) {
  const Sequence sequence = OpenSequence(RequestOf(cell, input.folder, data_.root(), ""));
  input.frames = static_cast<int>(sequence.images.size());
  const DetectorInput detector = {cell.sequence, sequence, data_.root()};
  const fs::path file =
      BoxesFile(detector, FindImageHashes(sequence, hash_index_, pool_, hooks_),
                Absolute(request_.cache), [this](const auto& files) { return Hashes(files); });
  input.boxes = file.string();
  if (AreBoxesWhole(file, [this](const auto& files) { return Hashes(files); })) return;
  std::error_code ignored;
  if (fs::exists(file, ignored)) {
    request_.notice("cached boxes are damaged and will be found again:  " + input.boxes);
  }
  input.missing = kNotDetected;
  if (!wanted_outputs_.insert(file).second) return;
  const std::string name =
      StrCat("detect-", cell.sequence.name, "-", file.stem().string().substr(0, kNameDigits));
  wanted_.push_back({"",
                     {name, cell.sequence.name, file, DetectArguments(detector, file), input.frames,
                      Stage::kBoxes}});
}

std::vector<std::string> Planner::Hashes(const std::vector<fs::path>& files) {
  return FindFileHashes(files, hash_index_, pool_, hooks_);
}

// A damaged scene is drawn again too, because it shares files with the cached drawing.
bool Planner::IsRendered(RenderedScene& scene) {
  std::error_code ignored;
  if (!fs::exists(scene.folder / synth::kManifestName, ignored)) return false;
  const auto damage =
      FindSceneDamage(scene.folder, [this](const auto& files) { return Hashes(files); });
  if (!damage) return true;
  request_.notice("a cached scene is damaged and will be rendered again:  " + *damage);
  scene.drawn = false;
  return false;
}

// Of the scenes that share a drawing one draws it, unless the cache has it.
void Planner::OrderPreparations() {
  std::set<std::string> drawing;
  for (auto& [key, wanted] : wanted_) {
    if (wanted.stage == Stage::kDrawing && !drawing.insert(key).second)
      wanted.stage = Stage::kNoise;
  }
  std::stable_sort(wanted_.begin(), wanted_.end(),
                   [](const auto& a, const auto& b) { return a.second.stage < b.second.stage; });
}

void Planner::Open(const Cell& cell, Input& input) {
  if (!cell.sequence.detector.model.empty()) FindBoxes(cell, input);
  if (!input.missing.empty()) return;
  input.sequence = OpenSequence(RequestOf(cell, input.folder, data_.root(), input.boxes));
  input.frames = static_cast<int>(input.sequence.images.size());
  const auto hash = [this](const auto& files) { return Hashes(files); };
  if (cell.sequence.scene.empty()) RequireAsRendered(input.sequence, hash);
  input.images = FindImageHashes(input.sequence, hash_index_, pool_, hooks_);
  input.content = ContentHash(input.sequence, input.images);
  input.detections = DetectionsHash(input.sequence);
}

Input Planner::FindInput(const Cell& cell) {
  Input input;
  try {
    const std::string lacking = FindMissingFile(cell.sequence, data_.root());
    if (!lacking.empty() && !data_.root().empty()) {
      input.missing = StrCat(kNoFile, lacking, " below ", data_.root().string());
    }
    if (cell.sequence.scene.empty()) {
      const DataFolder::Found found = data_.Find(cell.sequence.folder);
      if (input.missing.empty() || !found.missing.empty()) input.missing = found.missing;
      if (!input.missing.empty()) return input;
      input.folder = found.folder.string();
      Open(cell, input);
      return input;
    }
    if (!input.missing.empty()) return input;
    RenderedScene scene = scenes_.Find(cell.sequence, cell.parameters, cell.seed);
    if (!IsRendered(scene)) {
      AddRender(scene, cell);
      input.missing = kNotRendered;
      input.frames = scene.frames;
      return input;
    }
    input.folder = scene.folder.string();
    Open(cell, input);
  } catch (const Error& error) {
    input.missing = error.what();
  }
  return input;
}

Input& Planner::InputOf(const Cell& cell) {
  const SuiteSequence& sequence = cell.sequence;
  std::string key =
      StrCat(sequence.name, "\n", sequence.detections, "\n",
             PerturbationToJson(PerturbationOf(sequence, cell.parameters, cell.seed)).dump(), "\n",
             sequence.layout.dump(), "\n");
  if (!sequence.scene.empty()) {
    key += std::to_string(cell.seed);
    for (const std::string& assignment : SceneAssignments(sequence, cell.parameters)) {
      key += "\n" + assignment;
    }
  }
  const auto found = inputs_.find(key);
  return found != inputs_.end() ? found->second
                                : inputs_.emplace(key, FindInput(cell)).first->second;
}

const Resolved& Planner::ResolvedOf(const Cell& cell) {
  std::string key = cell.variant;
  for (const auto& [path, value] : cell.parameters) {
    if (IsOptionPath(path)) key += StrCat("\n", path, "=", value.dump());
  }
  const auto found = resolved_.find(key);
  if (found != resolved_.end()) return found->second;
  if (resolved_.size() >= kMaxResolved) resolved_.clear();
  Resolved resolved;
  resolved.options = OptionsOf(suite_, cell.variant, cell.parameters);
  const Json options = OptionsToJson(OptionLeaves(resolved.options));
  resolved.identity_head = IdentityHead(build_.identity, cell.variant, options);
  resolved.front_end = options["orb"].dump() + options["stereo"].dump();
  return resolved_.emplace(key, std::move(resolved)).first->second;
}

const std::string& Planner::FrontEndKeyOf(const Resolved& resolved, Input& input) const {
  const auto [found, added] = input.front_end_keys.try_emplace(resolved.front_end);
  if (added) {
    found->second = FrontEndKey({.build = build_.identity,
                                 .camera = input.sequence.camera,
                                 .orb = resolved.options.orb,
                                 .stereo = resolved.options.stereo,
                                 .perturbation = input.sequence.perturbation,
                                 .rectification = input.sequence.rectification,
                                 .first_frame = input.sequence.first_frame},
                                input.images);
  }
  return found->second;
}

void Planner::IdentifyFiles(const Input& input, PlannedJob& job) const {
  try {
    job.job = IdentifySystem(
        {.sequence = input.sequence,
         .content = input.content,
         .files = SystemFilesOf(suite_, job.cell, data_.root(), Absolute(request_.cache)),
         .seed = job.cell.seed});
  } catch (const Error& error) {
    job.missing = error.what();
  }
}

PlannedJob Planner::PlanCell(const Cell& cell) {
  Input& input = InputOf(cell);
  PlannedJob job{cell, input.folder, input.missing, input.frames, input.content,
                 "",   "",           input.boxes};
  if (!job.missing.empty()) return job;
  if (!cell.system.empty()) {
    IdentifyFiles(input, job);
    return job;
  }
  const Resolved& resolved = ResolvedOf(cell);
  job.input = FrontEndKeyOf(resolved, input);
  job.job = JobIdentity(
      resolved.identity_head,
      {input.content, input.detections,
       Given(input.sequence, ClassesOf(cell.sequence), OracleOf(cell.oracle)), cell.seed});
  return job;
}

BuiltPlan Planner::Build() {
  BuiltPlan built;
  built.plan.suite = suite_;
  built.plan.build = build_.identity;
  built.plan.data = data_.root().string();
  const std::vector<Cell> cells = ExpandSuite(suite_);
  built.plan.jobs.reserve(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    built.plan.jobs.push_back(PlanCell(cells[i]));
    if (request_.progress) request_.progress(i + 1, cells.size());
  }
  OrderPreparations();
  for (auto& [key, wanted] : wanted_) built.preparations.push_back(std::move(wanted));
  return built;
}

}  // namespace

BuiltPlan BuildPlan(const Suite& suite, const PlanRequest& request) {
  return Planner(suite, request).Build();
}

}  // namespace cvo
