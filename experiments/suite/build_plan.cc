// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/suite/build_plan.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "experiments/files/options_json.h"
#include "experiments/files/sha256.h"
#include "experiments/record/build_identity.h"
#include "experiments/record/job_identity.h"
#include "experiments/cache/content_hash.h"
#include "experiments/runner/run_job.h"
#include "experiments/suite/cell_input.h"
#include "experiments/suite/data_folder.h"
#include "experiments/suite/scenes.h"

namespace cvo {
namespace {

namespace fs = std::filesystem;

// What cells that differ in variant, options or oracle share.
struct Input {
  std::string folder;
  std::string missing;
  int frames = 0;
  Sequence sequence;
  std::string content;
  std::string images;  // hash of the pixels and the rig alone
};

// What the front end reads, and nothing that it does not: boxes and truth may differ.
std::string HashOfImages(const Sequence& sequence, const std::vector<ImageHashes>& images) {
  Json files = Json::array();
  for (const ImageHashes& pair : images) files.push_back(Json::array({pair.left, pair.right}));
  const StereoCamera& camera = sequence.camera;
  return Sha256Hex(DumpJson({{"camera",
                              {camera.fx, camera.fy, camera.cx, camera.cy, camera.baseline_m,
                               camera.width_px, camera.height_px, camera.right_shift_px}},
                             {"images", files}}));
}

std::vector<ImageHashes> HashImages(const Sequence& sequence, const FileHash& hash) {
  std::vector<ImageHashes> images;
  for (const StereoPaths& pair : sequence.images) {
    images.push_back({hash(pair.left), hash(pair.right)});
  }
  return images;
}

// Of the manifest's files by path.
FileHash ManifestHash(const fs::path& folder, const synth::Manifest& manifest) {
  std::map<fs::path, std::string> hashes;
  for (const synth::FileRecord& file : manifest.files) {
    hashes.emplace(folder / file.name, file.sha256);
  }
  return [hashes = std::move(hashes)](const fs::path& file) {
    const auto found = hashes.find(file);
    return found == hashes.end() ? HashImage(file) : found->second;
  };
}

fs::path Absolute(const fs::path& path) {
  return path.empty() ? path : fs::absolute(path).lexically_normal();
}

class Planner {
 public:
  Planner(const Suite& suite, const PlanRequest& request)
      : suite_(suite),
        request_(request),
        data_(Absolute(request.data)),
        scenes_(Absolute(request.cache)) {
    if (!request_.hash_file) request_.hash_file = HashImage;
  }

  BuiltPlan Build();

 private:
  const Input& InputOf(const Cell& cell);
  Input FindInput(const Cell& cell);
  void Open(const Cell& cell, const FileHash& hash, Input& input) const;
  PlannedJob PlanCell(const Cell& cell);
  void IdentifySystem(const Input& input, PlannedJob& job) const;
  void Want(const SceneFolder& scene, const Cell& cell);
  void OrderRenders();

  const Suite& suite_;
  PlanRequest request_;
  DataFolder data_;
  SceneFolders scenes_;
  BuildIdentity build_ = ThisBuild();
  std::map<std::string, Input> inputs_;
  std::vector<std::pair<std::string, SceneRender>> wanted_;  // with the key of the drawing
  std::set<fs::path> wanted_folders_;
};

void Planner::Want(const SceneFolder& scene, const Cell& cell) {
  if (!wanted_folders_.insert(scene.folder).second) return;
  const std::string name =
      StrCat("render-", cell.sequence.name, "-", scene.folder.parent_path().filename().string());
  wanted_.push_back(
      {scene.drawing,
       {name, cell.sequence.name, scene.folder, scene.arguments, scene.frames, !scene.drawn}});
}

// One of each drawing draws, unless the cache has it.
void Planner::OrderRenders() {
  std::set<std::string> drawing;
  for (auto& [key, render] : wanted_) render.draws = render.draws && drawing.insert(key).second;
  std::stable_partition(wanted_.begin(), wanted_.end(),
                        [](const auto& wanted) { return wanted.second.draws; });
}

void Planner::Open(const Cell& cell, const FileHash& hash, Input& input) const {
  input.sequence = OpenSequence(RequestOf(cell, input.folder, data_.root()));
  input.frames = static_cast<int>(input.sequence.images.size());
  const std::vector<ImageHashes> images = HashImages(input.sequence, hash);
  input.content = ContentHash(input.sequence, images);
  input.images = HashOfImages(input.sequence, images);
}

Input Planner::FindInput(const Cell& cell) {
  Input input;
  try {
    if (cell.sequence.scene.empty()) {
      const DataFolder::Found found = data_.Find(cell.sequence.folder);
      input.missing = found.missing;
      input.folder = found.folder.string();
      if (input.missing.empty()) Open(cell, request_.hash_file, input);
      return input;
    }
    const SceneFolder scene = scenes_.Find(cell.sequence, cell.parameters, cell.seed);
    const auto manifest = FindRendered(scene.folder);
    if (!manifest) {
      Want(scene, cell);
      input.missing = kNotRendered;
      input.frames = scene.frames;
      return input;
    }
    input.folder = scene.folder.string();
    Open(cell, ManifestHash(input.folder, *manifest), input);
  } catch (const Error& error) {
    input.missing = error.what();
  }
  return input;
}

const Input& Planner::InputOf(const Cell& cell) {
  const SuiteSequence& sequence = cell.sequence;
  std::string key = StrCat(sequence.name, "\n", sequence.detections, "\n");
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

void Planner::IdentifySystem(const Input& input, PlannedJob& job) const {
  Json files = {{"system", job.cell.system}};
  for (const SuiteSystem& system : suite_.systems) {
    if (system.name != job.cell.system) continue;
    for (const SuiteSystem::Files& file : system.files) {
      if (file.sequence != job.cell.sequence.name) continue;
      for (const auto& [key, name] :
           {std::pair("camera", file.camera), {"objects", file.objects}}) {
        if (name.empty()) continue;
        const std::string hash = HashImage(data_.root() / name);
        if (hash.empty()) job.missing = StrCat("no ", (data_.root() / name).string());
        files[key] = hash;
      }
    }
  }
  if (!job.missing.empty()) return;
  job.job = JobIdentity({build_.Hash(), "", files, input.content, DetectionsHash(input.sequence),
                         GivenToJson({}, {}), job.cell.seed});
}

PlannedJob Planner::PlanCell(const Cell& cell) {
  const Input& input = InputOf(cell);
  PlannedJob job{cell, input.folder, input.missing, input.frames, input.content, "", ""};
  if (!job.missing.empty()) return job;
  if (!cell.system.empty()) {
    IdentifySystem(input, job);
    return job;
  }
  Options options = OptionsOf(suite_, cell.parameters);
  job.input = Sha256Hex(DumpJson({{"images", input.images},
                                  {"orb", OptionsToJson(OptionLeaves(options.orb))},
                                  {"stereo", OptionsToJson(OptionLeaves(options.stereo))},
                                  {"estimator", build_.estimator_sources}}));
  job.job = IdentifyJob({.sequence = input.sequence,
                         .variant = FindVariant(cell.variant),
                         .options = options,
                         .seed = cell.seed,
                         .classes = ClassesOf(cell.sequence),
                         .oracle = OracleOf(cell.oracle)},
                        input.content);
  return job;
}

BuiltPlan Planner::Build() {
  BuiltPlan built;
  built.plan.suite = suite_;
  built.plan.build = build_.Hash();
  built.plan.data = data_.root().string();
  const std::vector<Cell> cells = ExpandSuite(suite_);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    built.plan.jobs.push_back(PlanCell(cells[i]));
    if (request_.progress) request_.progress(i + 1, cells.size());
  }
  OrderRenders();
  for (auto& [key, render] : wanted_) built.renders.push_back(std::move(render));
  return built;
}

}  // namespace

BuiltPlan BuildPlan(const Suite& suite, const PlanRequest& request) {
  return Planner(suite, request).Build();
}

}  // namespace cvo
